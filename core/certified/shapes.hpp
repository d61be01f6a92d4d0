/// Collision tests of shapes whose points are computed, such as cylinders, sums, and what a pose moves. The answer is
/// never wrong. Where their points are known too badly for an answer it is undecided, with a bound on how near the
/// shapes are. Needs Eigen and Boost.Multiprecision.
///
///     const gjk::ShapesResult result = gjk::certified_shapes(can, gjk::Posed(box, pose));
///     result.status;  // intersecting, separated, or undecided
///     result.gap;     // undecided: no farther apart than that, and no deeper in each other
///
/// A point w of the difference is known to ε. ε has the errors of both shapes, see C6 in support_error.hpp. It also has
/// what w itself and its product with a direction are rounded by. The assumptions are those of certified.hpp.
///  C7. Apart: a direction d with −w·d > ε|d|, w being the point found along it. For no point of the difference is
///      farther along d than w by more than ε|d|.
///  C8. Together: the surface of the hull of points that were found, which is exact. The origin is inside, and no
///      triangle of it comes as near to the origin as ε. Move every point to where it truly is: no triangle passes the
///      origin on the way there. So the surface still goes around the origin, and the origin is in the hull of its
///      points.
///  C9. Bounds. The shapes are no farther apart than the triangle of that surface nearest to the origin is from it,
///      plus 2ε. A flat difference has no such surface. There they are no farther apart than g, where the difference
///      grown by a ball of radius g surrounds the origin. Find the direction in which the difference reaches least: the
///      shapes are no deeper in each other than it reaches there, plus ε (C7).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "../result.hpp"
#include "dyadic.hpp"
#include "support_error.hpp"
#include "usual_arithmetic.hpp"

namespace gjk {

struct ShapesResult {
  Status status = Status::undecided;
  /// Where undecided, a bound (C9). The shapes are at most so far apart, and to part them takes a move of at most so
  /// much. It is infinite where their points are beyond a millionth of what S can hold. So it is where a rotation is off
  /// by more than a thousandth, and nothing is known. Where decided it is 0.
  double gap = 0;
  int iterations = 0;               ///< how many times each of the two support functions was called
  Vec3<double> direction{0, 0, 0};  ///< where separated: a·d < b·d for all points a and b
};

namespace detail {

/// What lengths are computed in: doubles, or S where that is finer.
template <class S>
using Wide = std::conditional_t<(std::numeric_limits<S>::digits > std::numeric_limits<double>::digits), S, double>;

/// Not inlined: GCC 12 vectorizes from -O2 on. It then leaves the rounding out where two numbers are turned to float
/// and back.
template <class S>
[[gnu::noinline]] Vec3<S> rounded(const Vec3<Wide<S>>& direction) {
  return direction.template cast<S>();
}

/// The difference of two shapes, grown by a ball, asked about points. It keeps what directions prove.
///
/// Lengths are in units of a power of two near the shapes' size. So no product of three is beyond all doubles, or lost
/// below them, however large or small the shapes are. What a coordinate loses below the least double there is nothing
/// beside ε.
template <class S, class A, class B>
class BoundedDifference {
 public:
  using N = Wide<S>;
  using Place = Vec3<N>;

  /// ε, all in N:
  ///  - w = a − b is rounded by u|w|.
  ///  - w·d/|d| or the height of a triangle is off by 6.5u|w| at most: 3u for the product, 2.5u for the length, 1u for
  ///    the quotient.
  ///  - How far it reaches with ε (C9) is a sum, rounded by another u.
  BoundedDifference(const A& a, const B& b) : a_(a), b_(b) {
    const SupportError of_a = support_error(a), of_b = support_error(b);
    if (const double largest = std::max({of_a.size, of_b.size, of_a.error, of_b.error}); std::isfinite(largest))
      exponent_ = std::ilogb(largest);
    size_ = in_units(of_a.size) + in_units(of_b.size);
    error_ = (in_units(of_a.error) + in_units(of_b.error) + 9 * u * size_) * (1 + 0x1p-20);
  }

  /// Returns: a length in the units of the shapes, rounded up.
  double unscaled(N length) const {
    const double nearest = static_cast<double>(std::scalbn(length, exponent_));
    return in_units(nearest) < length ? std::nextafter(nearest, std::numeric_limits<double>::infinity()) : nearest;
  }

  /// ε; once the difference is grown by a ball, more:
  ///  - The ball's radius over |d| is off by 3.5u.
  ///  - The way and the point are rounded by u each.
  ///  - The height is off by 6.5u.
  N error(N radius = 0) const { return error_ + 16 * u * radius; }
  /// No point of the difference is farther from the origin.
  N size() const { return size_; }
  int times_asked() const { return times_asked_; }
  /// The difference itself reaches at most so far along some direction. To part the shapes takes no more than that.
  N least_reach() const { return least_reach_; }
  /// C7.
  const std::optional<Vec3<double>>& separation() const { return separation_; }

  /// Requires: a vector with a largest component near 1. Returns: a point far along it of the difference grown by
  /// `radius`.
  Place far_along(const Place& direction, N radius) {
    const Vec3<S> d = rounded<S>(direction);
    const Place along = d.template cast<N>();
    const N length = along.norm();
    const Place w = in_units(near_support(a_, d)) - in_units(near_support(b_, Vec3<S>(-d)));
    ++times_asked_;
    const N reach = w.dot(along) / length;
    if (reach + error_ * (1 + 0x1p-20) < 0) separate(along);
    least_reach_ = std::min(least_reach_, reach + error_);
    return w + along * (radius / length);
  }

 private:
  static constexpr N u = std::numeric_limits<N>::epsilon() / 2;

  /// A direction is told in doubles. Where that is another, it is asked whether it separates, too.
  void separate(const Place& along) {
    const Vec3<double> told = along.template cast<double>();
    if (told.template cast<N>() == along)
      separation_ = told;
    else
      far_along(told.template cast<N>(), 0);
  }

  N in_units(N length) const { return std::scalbn(length, -exponent_); }
  Place in_units(const Vec3<S>& p) const {
    return p.template cast<N>().unaryExpr([this](N x) { return in_units(x); });
  }

  const A& a_;
  const B& b_;
  int exponent_ = 0;
  N size_, error_;
  int times_asked_ = 0;
  N least_reach_ = std::numeric_limits<N>::infinity();
  std::optional<Vec3<double>> separation_;
};

/// The surface of the convex hull of points: triangles, each counter-clockwise seen from outside. On which side of a
/// triangle a point lies is decided exactly.
template <class N = double>
class Surface {
  using Place = Vec3<N>;
  using Edge = std::array<std::size_t, 2>;

 public:
  struct Face {
    std::array<std::size_t, 3> corners;
    Place normal;  ///< of length 1, outward; any other vector would be as true, and of less use
    N height;      ///< the least of corner·normal: so far from the origin is the triangle, where that is positive
  };

  /// Requires: four points that are in no plane.
  explicit Surface(const std::array<Place, 4>& corners) : points_(corners.begin(), corners.end()) {
    const bool is_right_handed = side(corners[0], corners[1], corners[2], corners[3]) > 0;
    for (const auto& [i, j, k] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      is_right_handed ? add_face(i, k, j) : add_face(i, j, k);
  }

  const Face& lowest() const { return *std::ranges::min_element(faces_, {}, &Face::height); }

  /// Returns: 1 where p lies beyond the plane of the face, −1 where it lies below, 0 in it.
  int side(const Face& face, const Place& p) const {
    return side(points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]], p);
  }

  /// Returns: 1 where p lies on the side of the plane abc from where these are counter-clockwise.
  static int side(const Place& a, const Place& b, const Place& c, const Place& p) {
    const auto volume = [&]<class Number>() {
      const auto from_a = [&](const Place& q) {
        const auto of = [](N x) { return Number{x}; };
        return Triple<Number>{of(q.x()) - of(a.x()), of(q.y()) - of(a.y()), of(q.z()) - of(a.z())};
      };
      return dot(cross(from_a(b), from_a(c)), from_a(p));
    };
    const auto quick = volume.template operator()<BoundedNumber<N>>();
    return quick.has_certain_sign() ? sign_of(quick) : sign_of(volume.template operator()<Dyadic>());
  }

  /// Takes away the triangles that p is beyond, which are one piece. Joins p to the edges of what is left.
  void add(const Place& p) {
    const auto seen = std::ranges::partition(faces_, [&](const Face& face) { return side(face, p) <= 0; });
    std::vector<Edge> open;
    for (const Face& face : seen)
      for (const auto& [i, j] : edges_of(face)) {
        const auto other_side = std::ranges::find(open, Edge{j, i});
        if (other_side != open.end())
          open.erase(other_side);
        else
          open.push_back({i, j});
      }
    faces_.erase(seen.begin(), seen.end());
    points_.push_back(p);
    for (const auto& [i, j] : open) add_face(i, j, points_.size() - 1);
  }

  /// Returns: how far from the origin some point of it is. Of each triangle that is the point below the origin, or one
  /// on its rim.
  N nearness() const {
    N least = std::numeric_limits<N>::infinity();
    for (const Face& face : faces_) {
      const auto &a = points_[face.corners[0]], &b = points_[face.corners[1]], &c = points_[face.corners[2]];
      const auto part = [&](const Place& x, const Place& y) { return std::max(N(0), face.normal.dot(x.cross(y))); };
      const N of_a = part(b, c), of_b = part(c, a), of_c = part(a, b), sum = of_a + of_b + of_c;
      if (sum > 0) least = std::min(least, ((of_a / sum) * a + (of_b / sum) * b + (of_c / sum) * c).norm());
      least = std::min({least, nearness_of_edge(a, b), nearness_of_edge(b, c), nearness_of_edge(c, a)});
    }
    return least;
  }

  /// C8. Returns: whether the origin is inside.
  bool goes_around_origin() const {
    return std::ranges::all_of(faces_, [this](const Face& face) { return side(face, Place::Zero()) < 0; });
  }

 private:
  static std::array<Edge, 3> edges_of(const Face& face) {
    const auto& [i, j, k] = face.corners;
    return {{{i, j}, {j, k}, {k, i}}};
  }

  /// Of edges that are nearly parallel, such as the two long ones of a needle, rounding leaves nothing of the product.
  /// The two beside the corner across from the longest are the least so. Where all three corners are nearly in one line
  /// the product is made without rounding.
  Place normal_of(std::size_t i, std::size_t j, std::size_t k) const {
    const std::array<Place, 3> sides{points_[j] - points_[i], points_[k] - points_[j], points_[i] - points_[k]};
    const auto size = [](const Place& v) { return v.cwiseAbs().maxCoeff(); };
    const auto longest = static_cast<std::size_t>(std::ranges::max_element(sides, {}, size) - sides.begin());
    const Place &from = sides[(longest + 1) % 3], &to = sides[(longest + 2) % 3], n = from.cross(to);
    const bool is_in_line = size(n) < size(from) * size(to) / 64;
    return scaled_to_one(is_in_line ? exact_product(i, j, k) : n);
  }
  /// Squares of the least doubles would vanish.
  static Place scaled_to_one(const Place& n) { return (n / n.cwiseAbs().maxCoeff()).normalized(); }
  /// Returns: (b − a)×(c − a) times a power of two, rounded once. Requires: that it is not zero.
  Place exact_product(std::size_t i, std::size_t j, std::size_t k) const {
    const auto exactly = [this](std::size_t point) {
      const Place& p = points_[point];
      return Triple<Dyadic>{Dyadic(p.x()), Dyadic(p.y()), Dyadic(p.z())};
    };
    const Triple<Dyadic> a = exactly(i), n = cross(exactly(j) - a, exactly(k) - a);
    int most = std::numeric_limits<int>::min();
    for (const Dyadic* x : {&n.x, &n.y, &n.z})
      if (x->m != 0) most = std::max(most, exponent_of(*x));
    const auto near_one = [most](const Dyadic& x) {
      const int bits = x.m == 0 ? 0 : static_cast<int>(msb(abs(x.m)));
      const unsigned cut = bits > 200 ? static_cast<unsigned>(bits - 200) : 0;  // so that a double can hold it
      return std::scalbn(Whole(x.m >> cut).template convert_to<N>(), x.e + static_cast<int>(cut) - most);
    };
    return {near_one(n.x), near_one(n.y), near_one(n.z)};
  }

  void add_face(std::size_t i, std::size_t j, std::size_t k) {
    const Place normal = normal_of(i, j, k);
    faces_.push_back(
        {{i, j, k}, normal, std::min({normal.dot(points_[i]), normal.dot(points_[j]), normal.dot(points_[k])})});
  }

  static N nearness_of_edge(const Place& a, const Place& b) {
    const Place along = b - a;
    const N squared = along.squaredNorm();
    return squared > 0 ? (a + std::clamp(-a.dot(along) / squared, N(0), N(1)) * along).norm() : a.norm();
  }

  std::vector<Place> points_;
  std::vector<Face> faces_;
};

constexpr int most_points = 200;  // 60 were seen

/// Returns: four points of the grown difference in no plane. Each is found where it is far from those found before.
/// Nothing where the difference is flat, or apart.
template <class Difference>
auto first_corners(Difference& difference, typename Difference::N radius)
    -> std::optional<std::array<typename Difference::Place, 4>> {
  using Place = typename Difference::Place;
  std::array<Place, 4> w;
  const auto farther = [&](const Place& d, const Place& from) {
    const Place up = difference.far_along(d, radius), down = difference.far_along(-d, radius);
    return std::abs(d.dot(up - from)) > std::abs(d.dot(down - from)) ? up : down;
  };
  const auto normalized = [](const Place& v) { return Place(v / v.cwiseAbs().maxCoeff()); };
  w[0] = difference.far_along(Place(1, 0, 0), radius);
  w[1] = difference.far_along(Place(-1, 0, 0), radius);
  Place edge = w[1] - w[0];
  if (edge == Place::Zero()) return std::nullopt;
  edge = normalized(edge);
  Eigen::Index least;
  edge.cwiseAbs().minCoeff(&least);
  w[2] = farther(normalized(edge.cross(Place::Unit(least))), w[0]);
  const Place normal = edge.cross(w[2] - w[0]);
  if (normal == Place::Zero() || !normal.allFinite()) return std::nullopt;
  w[3] = farther(normalized(normal), w[0]);
  if (Surface<typename Difference::N>::side(w[0], w[1], w[2], w[3]) == 0) return std::nullopt;
  return w;
}

template <class N>
struct Surrounded {
  bool is_origin = false;                           ///< C8
  N nearness = std::numeric_limits<N>::infinity();  ///< of what does not surround it; infinite where that is flat
};

/// Expands a surface of points of the difference grown by `radius` toward the origin. It ends where
///  - the surface goes around the origin farther than ε (C8), and the difference itself is known to reach no farther than
///    `shallow` along some direction,
///  - a direction separates (C7),
///  - nothing more is found.
template <class Difference>
auto surrounded(Difference& difference, typename Difference::N radius,
                typename Difference::N shallow = std::numeric_limits<typename Difference::N>::infinity())
    -> Surrounded<typename Difference::N> {
  const auto corners = first_corners(difference, radius);
  if (!corners) return {};
  Surface surface(*corners);
  bool is_origin = false;
  for (int i = 4; i < most_points && !difference.separation(); ++i) {
    const auto lowest = surface.lowest();
    is_origin = is_origin || (lowest.height > difference.error(radius) * (1 + 0x1p-20) && surface.goes_around_origin());
    if (is_origin && difference.least_reach() <= shallow) break;
    if (!lowest.normal.allFinite()) break;
    const auto w = difference.far_along(lowest.normal, radius);
    if (surface.side(lowest, w) <= 0) break;
    surface.add(w);
  }
  return {is_origin, is_origin ? 0 : surface.nearness()};
}

/// C9. Requires: neither apart nor together by what was found. Returns: a bound on the distance and on the depth. On the
/// way there they may be found apart, which ends it.
///
/// Beside ε the bound has what the nearness itself is rounded by. That is the way to a point of a triangle, rounded by
/// 9u|w| at most. It is no more than another ε. A flat difference is found to be shallow only while it is grown.
template <class Difference>
auto bound(Difference& difference, typename Difference::N nearness) {
  auto distance = std::min(nearness, difference.size()) + 2 * difference.error();
  for (auto radius = 4 * difference.error(); radius < distance && !difference.separation(); radius *= 4)
    if (surrounded(difference, radius, 2 * radius).is_origin) distance = radius;
  return std::max(distance, difference.least_reach());
}

}  // namespace detail

/// Do they have a point in common? Touching is intersecting, but seldom decided.
///
/// Requires: finite shapes. S, float, double or long double, is what their points are computed in. The finer, the less
/// stays undecided: beside x86's long doubles ε of doubles is 2,048 times as large.
/// Errors: std::runtime_error as certified_collision(). What a support function throws passes through.
template <class S = double, class A, class B>
requires BoundedShape<A, S> && BoundedShape<B, S> ShapesResult certified_shapes(const A& a, const B& b) {
  detail::expect_usual_arithmetic();
  detail::BoundedDifference<S, A, B> difference(a, b);
  ShapesResult result;
  if (!std::isfinite(difference.error())) {
    result.gap = std::numeric_limits<double>::infinity();
    return result;
  }
  const auto [is_together, nearness] = detail::surrounded(difference, 0);
  if (is_together)
    result.status = Status::intersecting;
  else if (!difference.separation())
    result.gap = difference.unscaled(detail::bound(difference, nearness));
  if (difference.separation()) result = {Status::separated, 0, 0, *difference.separation()};
  result.iterations = difference.times_asked();
  return result;
}

}  // namespace gjk
