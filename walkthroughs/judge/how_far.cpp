#include "walkthroughs/judge/how_far.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/certified/dyadic.hpp"
#include "walkthroughs/pairs/dice.hpp"
#include "walkthroughs/pairs/graded.hpp"

namespace walkthroughs::judge {
namespace {

constexpr std::size_t few_points = 24;   // points of a set, all of whose edges are looked at
constexpr double nearly_touches = 1e-7;  // of the size: what touches is found no deeper in doubles

double diagonal_of(const PointPair& pair) {
  Vec least = pair.a[0], most = pair.a[0];
  for (const Points* const set : {&pair.a, &pair.b})
    for (const Vec& p : *set) {
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    }
  return (most - least).stableNorm();
}

/// Returns: the pair of size 1, about 0, so that no product overflows or vanishes.
PointPair of_size_one(const PointPair& pair, double diagonal) {
  PointPair scaled = pair;
  const Vec middle = pair.a[0];
  for (Points* const set : {&scaled.a, &scaled.b})
    for (Vec& p : *set) p = (p - middle) / diagonal;
  return scaled;
}

// -- Apart ------------------------------------------------------------------------------------------------------------

double gap_of(const PointPair& pair) { return nearest_point(pair).stableNorm(); }

// -- In each other ----------------------------------------------------------------------------------------------------

struct Supported {
  double value;  ///< of the support function of the difference
  Vec vertex;    ///< where it is
};

Supported supported(const PointPair& pair, const Vec& d) {
  const auto farthest = [](const Points& points, const Vec& d) -> const Vec& {
    return *std::ranges::max_element(points, {}, [&](const Vec& p) { return p.dot(d); });
  };
  const Vec w = farthest(pair.a, d) - farthest(pair.b, -d);
  return {w.dot(d), w};
}

/// Along which the difference reaches least beyond 0, as far as is known.
struct Shallowest {
  double depth = std::numeric_limits<double>::infinity();
  Vec direction = Vec::Zero();

  void look(const PointPair& pair, const Vec& d) {
    const double length = d.norm();
    if (length == 0) return;
    for (const Vec& unit : {Vec(d / length), Vec(-d / length)})
      if (const double value = supported(pair, unit).value; value < depth) *this = {value, unit};
  }
};

/// From one point of a set to another.
struct Edge {
  const Points* set;
  std::size_t from, to;

  Vec vector() const { return (*set)[to] - (*set)[from]; }
};

std::vector<Edge> edges_of(const PointPair& pair) {
  std::vector<Edge> edges;
  for (const Points* const set : {&pair.a, &pair.b})
    for (std::size_t i = 0; i < set->size(); ++i)
      for (std::size_t j = 0; j < i; ++j) edges.push_back({set, i, j});
  return edges;
}

/// A normal of two vectors; in the plane of the first alone.
template <class V>
V normal_of(const V& u, const V& v, bool in_plane) {
  if (in_plane) return V{u[1], -u[0], u[0] - u[0]};
  return V{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// Calls use(u, v) with any two edges; in the plane with each one, twice.
template <class Use>
void for_each_two(const std::vector<Edge>& edges, bool in_plane, const Use& use) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = in_plane ? i : 0; j < (in_plane ? i + 1 : i); ++j) use(edges[i], edges[j]);
}

/// From there downhill: the value falls against the part of the vertex that is across the direction.
void descend(const PointPair& pair, Vec d, bool in_plane, Shallowest& best) {
  double step = 0.5;
  for (int i = 0; i < 60; ++i, step *= 0.9) {
    if (in_plane) d.z() = 0;
    if (d.norm() == 0) return;
    d.normalize();
    const auto [value, vertex] = supported(pair, d);
    if (value < best.depth) best = {value, d};
    const Vec across = vertex - value * d;
    if (across.norm() == 0) return;
    d -= step * across.normalized();
  }
}

bool are_few(const PointPair& pair) { return pair.a.size() <= few_points && pair.b.size() <= few_points; }

Shallowest shallowest(const PointPair& pair, bool in_plane) {
  Shallowest best;
  if (are_few(pair)) {
    for_each_two(edges_of(pair), in_plane, [&](const Edge& u, const Edge& v) {
      best.look(pair, normal_of<Vec>(u.vector(), v.vector(), in_plane));
    });
    if (best.depth == std::numeric_limits<double>::infinity()) best.depth = 0;  // all in a line: of no depth
    return best;
  }
  Dice dice(1, "descents", 0);
  for (int i = 0; i < 12; ++i)
    descend(pair, i < 6 ? Vec(Vec::Unit(i / 2) * (i % 2 ? 1 : -1)) : dice.direction(), in_plane, best);
  return best;
}

/// Returns: those points that may be on the face which the difference has there, of the pair of size 1 and of the pair itself.
/// Of few points all.
std::pair<PointPair, PointPair> near_face(const PointPair& scaled, const PointPair& pair, const Vec& d) {
  const bool takes_all = are_few(scaled);
  std::pair<PointPair, PointPair> face;
  const auto take = [&](Points PointPair::*set, const Vec& along) {
    const Points& points = scaled.*set;
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec& p : points) most = std::max(most, p.dot(along));
    for (std::size_t i = 0; i < points.size(); ++i)
      if (takes_all || (points[i].dot(along) > most - 0.01 && (face.first.*set).size() < few_points)) {
        (face.first.*set).push_back(points[i]);
        (face.second.*set).push_back((pair.*set)[i]);
      }
  };
  take(&PointPair::a, d);
  take(&PointPair::b, -d);
  return face;
}

// -- Contact, exactly ---------------------------------------------------------------------------------------------------

using Exact = std::array<gjk::detail::Dyadic, 3>;

Exact exact(const Vec& p) { return {p.x(), p.y(), p.z()}; }

Exact exact_vector(const Points& points, const Edge& edge) {
  Exact vector;
  for (int i = 0; i < 3; ++i)
    vector[static_cast<std::size_t>(i)] =
        gjk::detail::Dyadic(points[edge.to][i]) - gjk::detail::Dyadic(points[edge.from][i]);
  return vector;
}

/// Returns: whether no point of the difference is beyond 0 along this normal.
bool supports_at_origin(const PointPair& pair, const Exact& normal) {
  const auto is_zero = [](const auto& x) { return sign_of(x) == 0; };
  if (std::ranges::all_of(normal, is_zero)) return false;
  const auto along = [&](const Vec& p) {
    const Exact x = exact(p);
    return x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2];
  };
  std::vector<gjk::detail::Dyadic> of_b;
  for (const Vec& p : pair.b) of_b.push_back(along(p));
  return std::ranges::all_of(pair.a, [&](const Vec& p) {
    return std::ranges::all_of(of_b, [x = along(p)](const auto& y) { return sign_of(x - y) <= 0; });
  });
}

/// `found`: of `scaled`, the pair of size 1.
bool touches(const PointPair& pair, const PointPair& scaled, const Shallowest& found, bool in_plane) {
  if (found.depth > nearly_touches) return false;
  if (found.direction == Vec::Zero()) return true;  // all in a line
  const auto [near, of_pair] = near_face(scaled, pair, found.direction);
  bool touch = false;
  for_each_two(edges_of(near), in_plane, [&](const Edge& u, const Edge& v) {
    if (touch) return;
    const Vec normal = normal_of<Vec>(u.vector(), v.vector(), in_plane);
    const double length = normal.norm();
    if (length == 0) return;
    for (const double sign : {1.0, -1.0}) {
      if (supported(scaled, sign / length * normal).value > nearly_touches) continue;
      const auto points = [&](const Edge& edge) -> const Points& {
        return edge.set == &near.a ? of_pair.a : of_pair.b;
      };
      Exact exact = normal_of<Exact>(exact_vector(points(u), u), exact_vector(points(v), v), in_plane);
      if (sign < 0)
        for (gjk::detail::Dyadic& x : exact) x = -x;
      touch = touch || supports_at_origin(pair, exact);
    }
  });
  return touch;
}

}  // namespace

HowFar how_far(const Case& asked, bool in_plane) {
  // Scaled by a power of two, so that no difference overflows.
  const double most = largest_number(asked.pair);
  if (most == 0) return {};
  const int power = std::ilogb(most) + 2;
  PointPair pair = asked.pair;
  for (Points* const set : {&pair.a, &pair.b})
    for (Vec& p : *set)
      for (double& x : p) x = std::scalbn(x, -power);
  const double diagonal = diagonal_of(pair);
  if (diagonal == 0) return {};
  if (!asked.meet()) {
    const double gap = gap_of(pair);
    return {std::scalbn(gap, power), gap / diagonal, false};
  }
  const PointPair scaled = of_size_one(pair, diagonal);
  const Shallowest found = shallowest(scaled, in_plane);
  if (touches(pair, scaled, found, in_plane)) return {};
  const double depth = std::max(0.0, found.depth);
  return {std::scalbn(depth * diagonal, power), depth, !are_few(pair)};
}

bool only_touch(const PointPair& pair, bool in_plane) {
  const double diagonal = diagonal_of(pair);
  if (diagonal == 0) return true;
  const PointPair scaled = of_size_one(pair, diagonal);
  return touches(pair, scaled, shallowest(scaled, in_plane), in_plane);
}

}  // namespace walkthroughs::judge
