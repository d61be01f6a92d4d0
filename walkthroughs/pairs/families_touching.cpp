/// Pairs that touch, or miss it by the last bit of a number.
///
/// In a frame of its own each pair has A below the plane w = 0 and B above it, with a vertex, an edge or a face in that
/// plane, and (0, 0, 0) in both: so they touch, and nothing is deeper. Frames are of whole numbers, so that no coordinate
/// is rounded, in single precision either.
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "walkthroughs/pairs/families_recipes.hpp"

namespace walkthroughs::pairs {
namespace {

// -- Frames of whole numbers ------------------------------------------------------------------------------------------

struct Frame {
  Vec u, v, w, origin;

  Vec operator()(double along_u, double along_v, double along_w) const {
    return origin + along_u * u + along_v * v + along_w * w;
  }
  Points operator()(Points points) const {
    for (Vec& p : points) p = (*this)(p[0], p[1], p[2]);
    return points;
  }
};

/// Three vectors at right angles to each other and of equal length, in any order, each one or its opposite, with
/// coordinates in any order.
Frame shuffled(Dice& dice, std::vector<Vec> vectors, Vec origin) {
  dice.shuffle(vectors);
  std::vector<Eigen::Index> order{0, 1, 2};
  dice.shuffle(order);
  for (Vec& vector : vectors) {
    vector = Vec(vector[order[0]], vector[order[1]], vector[order[2]]);
    vector *= dice.sign();
  }
  return {vectors[0], vectors[1], vectors[2], std::move(origin)};
}

Vec whole_vector(Dice& dice, int least, int most) {
  Vec v;
  for (double& coordinate : v) coordinate = dice.whole(least, most);
  return v;
}

/// Along the axes, near the origin: products of four differences of coordinates below 2^6 are exact in single precision.
struct Plain {
  static constexpr int reach = 8;
  static Frame frame(Dice& dice) {
    return shuffled(dice, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, whole_vector(dice, -20, 20));
  }
};

/// Along none of the axes, and so large that products are rounded, in double precision too. A coordinate is at most
/// 5 · 2^18 away from the origin's, so between 2^21 and 2^24.
struct Askew {
  static constexpr int reach = 1 << 18;
  static Frame frame(Dice& dice) {
    Vec origin = whole_vector(dice, 1 << 22, 1 << 23);
    for (double& coordinate : origin) coordinate *= dice.sign();
    return shuffled(dice, {{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}, std::move(origin));
  }
};

// -- What lies in the plane -------------------------------------------------------------------------------------------

enum class Feature { vertex, edge, face };

double cross_in_plane(const Vec& p, const Vec& q) { return p[0] * q[1] - p[1] * q[0]; }

Vec in_plane(Dice& dice, int reach) {
  Vec p = Vec::Zero();
  while (p[0] == 0 && p[1] == 0) {
    p[0] = dice.whole(-reach, reach);
    p[1] = dice.whole(-reach, reach);
  }
  return p;
}

/// Around (0, 0, 0), which is inside, not on an edge.
Points face(Dice& dice, int reach) {
  for (;;) {
    Points corners;
    for (int i = 0; i < 3; ++i) corners.push_back(in_plane(dice, reach));
    const double c = cross_in_plane(corners[0], corners[1]);
    if (c * cross_in_plane(corners[1], corners[2]) > 0 && c * cross_in_plane(corners[2], corners[0]) > 0)
      return corners;
  }
}

/// Through (0, 0, 0), which is not an end.
Points edge(Dice& dice, int reach) {
  const Vec step = in_plane(dice, reach / 4);
  const double back = dice.whole(1, 4), forth = dice.whole(1, 4);
  return {-back * step, forth * step};
}

Points in_plane(Dice& dice, Feature feature, int reach) {
  switch (feature) {
    case Feature::vertex: return {Vec::Zero()};
    case Feature::edge: return edge(dice, reach);
    default: return face(dice, reach);
  }
}

/// A tetrahedron with `feature` in the plane and the other corners on one side of it: 1 is above, -1 below.
Points standing_on(Dice& dice, const Points& feature, int side, int reach) {
  Points corners = feature;
  while (corners.size() < 4) {
    const Vec foot = in_plane(dice, reach);
    corners.emplace_back(foot[0], foot[1], side * dice.whole(reach / 4, reach));
  }
  return corners;
}

struct Contact {
  Feature a, b;
};

template <class Where>
Pair touching(Dice& dice, std::span<const Contact> contacts) {
  Contact contact = contacts[static_cast<std::size_t>(dice.whole(0, static_cast<int>(contacts.size()) - 1))];
  if (dice.coin()) std::swap(contact.a, contact.b);
  const Frame frame = Where::frame(dice);
  Points a = standing_on(dice, in_plane(dice, contact.a, Where::reach), -1, Where::reach);
  Points b = standing_on(dice, in_plane(dice, contact.b, Where::reach), 1, Where::reach);
  dice.shuffle(a);
  dice.shuffle(b);
  return {frame(std::move(a)), frame(std::move(b))};
}

constexpr std::array vertex_contacts{Contact{Feature::vertex, Feature::vertex}, Contact{Feature::vertex, Feature::edge},
                                     Contact{Feature::vertex, Feature::face}};
constexpr std::array edge_contacts{Contact{Feature::edge, Feature::edge}, Contact{Feature::edge, Feature::face}};
constexpr std::array face_contacts{Contact{Feature::face, Feature::face}};

// -- The last bit -----------------------------------------------------------------------------------------------------

/// Something of A on a face of B; then the points of A in that face are moved off it or into B, by one unit in the last
/// place of Scalar, in the coordinate that is the most across.
template <class Scalar, class Where>
Pair one_ulp(Dice& dice) {
  const Frame frame = Where::frame(dice);
  const auto feature = static_cast<Feature>(dice.whole(0, 2));
  const Points below = in_plane(dice, feature, Where::reach);
  Points a = frame(standing_on(dice, below, -1, Where::reach));
  Points b = frame(standing_on(dice, face(dice, Where::reach), 1, Where::reach));
  Eigen::Index across = 0;
  frame.w.cwiseAbs().maxCoeff(&across);
  const double into_b = frame.w[across] * dice.sign();
  const auto toward = static_cast<Scalar>(std::copysign(std::numeric_limits<Scalar>::infinity(), into_b));
  for (std::size_t i = 0; i < below.size(); ++i)
    a[i][across] = std::nextafter(static_cast<Scalar>(a[i][across]), toward);
  dice.shuffle(a);
  dice.shuffle(b);
  return {std::move(a), std::move(b)};
}

/// As Plain, but nowhere near 0, where the last place is worth next to nothing.
struct PlainAwayFromZero {
  static constexpr int reach = Plain::reach;
  static Frame frame(Dice& dice) {
    return shuffled(dice, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, whole_vector(dice, 10, 30));
  }
};

/// Whether the plane through these corners leaves room in the unit ball on both of its sides.
bool parts_the_ball(const Points& face) {
  const Vec normal = (face[1] - face[0]).cross(face[2] - face[0]);
  return std::abs(normal.dot(face[0])) < 0.8 * std::sqrt(normal.squaredNorm());
}

/// A corner of B, or of A, on the given side of the plane of `face` and clearly off it. Requires: parts_the_ball(face).
Vec clearly_beside(Dice& dice, const Points& face, double side) {
  const Vec normal = (face[1] - face[0]).cross(face[2] - face[0]);
  for (;;) {
    const Vec p = dice.in_ball();
    if (side * normal.dot(p - face[0]) > 0.1 * std::sqrt(normal.squaredNorm())) return p;
  }
}

Pair rounded_vertex_on_face(Dice& dice) {
  Points b = points_in_ball(dice, 3);
  while ((b[1] - b[0]).cross(b[2] - b[0]).squaredNorm() < 0.04 || !parts_the_ball(b)) b = points_in_ball(dice, 3);
  Points a{point_within(dice, b)};
  for (int i = 0; i < 3; ++i) a.push_back(clearly_beside(dice, b, 1));
  b.push_back(clearly_beside(dice, b, -1));
  if (dice.coin()) std::swap(a, b);
  dice.shuffle(a);
  dice.shuffle(b);
  return {std::move(a), std::move(b)};
}

double small_number(Dice& dice, int least_exponent, int most_exponent) {
  return dice.sign() * std::ldexp(dice.between(1, 2), dice.whole(least_exponent, most_exponent));
}

Pair near_parallel_edges(Dice& dice) {
  const double angle = small_number(dice, -40, -7), depth = small_number(dice, -52, -10);
  Points a{{-dice.between(0.5, 1), 0, 0}, {dice.between(0.5, 1), 0, 0}};
  Points b;
  for (const double end : {-1.0, 1.0}) {
    const double length = end * dice.between(0.5, 1);
    b.emplace_back(length, length * angle, -depth);
  }
  for (int i = 0; i < 2; ++i) {
    Vec below = dice.in_cube(1), above = dice.in_cube(1);
    below[2] = -dice.between(0.25, 1);
    above[2] = dice.between(0.25, 1);
    a.push_back(below);
    b.push_back(above);
  }
  const Rotation turn = rotation(dice);
  const Vec by = dice.in_cube(1);
  return {moved(turned(std::move(a), turn), by), moved(turned(std::move(b), turn), by)};
}

// -- In one plane -----------------------------------------------------------------------------------------------------

Pair coplanar_axis(Dice& dice) {
  const auto axis = static_cast<Eigen::Index>(dice.whole(0, 2));
  const double height = dice.between(-1, 1);
  std::array<Points, 2> triangles;
  for (Points& triangle : triangles)
    for (int i = 0; i < 3; ++i) {
      triangle.push_back(dice.in_cube(1));
      triangle.back()[axis] = height;
    }
  return {triangles[0], triangles[1]};
}

Pair coplanar_tilted(Dice& dice) {
  const Frame frame = Askew::frame(dice);
  std::array<Points, 2> triangles;
  for (Points& triangle : triangles)
    for (int i = 0; i < 3; ++i) triangle.push_back(in_plane(dice, Askew::reach));
  return {frame(triangles[0]), frame(triangles[1])};
}

template <class Where>
Family touching_family(const std::string& name, const std::string& what, std::span<const Contact> contacts) {
  return thrown(name, what, [contacts](Dice& dice) { return touching<Where>(dice, contacts); });
}

}  // namespace

std::vector<Family> touching_families() {
  const std::string plain = ": tetrahedra of small whole numbers, the plane between them square to an axis; all touch";
  const std::string askew = ": tetrahedra of whole numbers up to 2^24, the plane between them askew; all touch";
  const std::string vertex = "a vertex on a vertex, an edge or a face", edge = "an edge on an edge or a face",
                    face = "a face on a face";
  return {
      touching_family<Plain>("touching-vertex", vertex + plain, vertex_contacts),
      touching_family<Plain>("touching-edge", edge + plain, edge_contacts),
      touching_family<Plain>("touching-face", face + plain, face_contacts),
      touching_family<Askew>("touching-vertex-askew", vertex + askew, vertex_contacts),
      touching_family<Askew>("touching-edge-askew", edge + askew, edge_contacts),
      touching_family<Askew>("touching-face-askew", face + askew, face_contacts),
      thrown("one-ulp", "touching a face square to an axis, then one unit in the last place off it or in",
             one_ulp<double, PlainAwayFromZero>),
      thrown("one-ulp-askew", "touching a face askew, then one unit in the last place off it or in",
             one_ulp<double, Askew>),
      thrown("one-float-ulp", "as one-ulp, with the last place of single precision", one_ulp<float, PlainAwayFromZero>),
      thrown("one-float-ulp-askew", "as one-ulp-askew, with the last place of single precision", one_ulp<float, Askew>),
      thrown("rounded-vertex-on-face", "a vertex of one tetrahedron on a face of the other, up to rounding",
             rounded_vertex_on_face),
      thrown("near-parallel-edges", "edges that cross at 1e-12 to 1e-2 radians, 1e-16 to 1e-3 apart or deep",
             near_parallel_edges),
      thrown("coplanar-axis", "triangles in one plane, which is square to an axis", coplanar_axis),
      thrown("coplanar-tilted", "triangles of whole numbers up to 2^24 in one plane, which is askew", coplanar_tilted),
  };
}

}  // namespace walkthroughs::pairs
