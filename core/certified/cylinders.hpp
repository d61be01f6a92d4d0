/// Collision tests of cylinders whose axes are parallel to one coordinate axis, with each other and with balls, points
/// and capsules along that axis. They are exact: never wrong, never undecided. Needs what certified.hpp needs.
///
///     const auto can = gjk::AxialCylinder::of({0, 0, 1}, {0, 0, 1}, 0.5, 2);  // center, axis, radius, height
///     gjk::certified_status(*can, *other);                                    // intersecting or separated
///
/// Such cylinders are discs times intervals.
///  C11. They meet where their intervals and their discs do. A ball or a capsule meets one that is at most its
///       radius away. That distance has a part along the axis and one across it. All is compared in numbers that do not
///       round.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "dyadic.hpp"
#include "grown.hpp"

namespace gjk {

/// A cylinder along a coordinate axis.
class AxialCylinder {
 public:
  /// `axis`: of any length but zero. Where a motion moves the cylinder it moves center and axis. Radius and height stay.
  /// Returns: none where the axis, once moved, is not exactly parallel to a coordinate axis.
  /// Errors: std::invalid_argument where numbers are not finite, or radius or height is negative.
  static std::optional<AxialCylinder> of(const Vec3<double>& center, const Vec3<double>& axis, double radius,
                                         double height, const Motion& motion = {}) {
    if (!(radius >= 0 && height >= 0 && std::isfinite(radius) && std::isfinite(height)))
      throw std::invalid_argument("a cylinder needs a finite radius and height that are not negative");
    const detail::Triple<detail::Dyadic> along = detail::MovedSet({{axis}, {motion.turn}}).exactly(0);
    std::optional<int> along_one;
    int i = 0;
    for (const detail::Dyadic* component : {&along.x, &along.y, &along.z}) {
      if (component->m != 0 && along_one) return std::nullopt;
      if (component->m != 0) along_one = i;
      ++i;
    }
    if (!along_one) return std::nullopt;
    return AxialCylinder(detail::MovedSet({{center}, motion}), *along_one, radius, height);
  }

  const detail::MovedSet& center() const { return center_; }
  int axis() const { return axis_; }
  double radius() const { return radius_; }
  double height() const { return height_; }

 private:
  AxialCylinder(detail::MovedSet center, int axis, double radius, double height)
      : center_(std::move(center)), axis_(axis), radius_(radius), height_(height) {}

  detail::MovedSet center_;
  int axis_;
  double radius_, height_;
};

namespace detail {

/// Returns: the point seen along an axis: the two coordinates across it, and the one along it.
inline std::array<Dyadic, 3> seen_along(int axis, const Triple<Dyadic>& p) {
  const std::array<Dyadic, 3> all{p.x, p.y, p.z};
  const auto at = [&](int i) { return all[static_cast<std::size_t>((axis + i) % 3)]; };
  return {at(1), at(2), at(0)};
}

inline Dyadic square(const Dyadic& x) { return x * x; }
inline bool is_at_most(const Dyadic& x, const Dyadic& y) { return sign_of(y - x) >= 0; }

/// What lies `across`² and `beyond` from a cylinder's axis and its caps, against a reach of s. Across a cylinder of
/// radius r that is √q − r where q > r². Together at most s:
///
///     (√q − r)² <= m, m = s² − beyond² >= 0;  q − r² − m <= 2r√m, both squared where the left side is positive.
inline bool is_within_reach(const Dyadic& q, const Dyadic& beyond, const Dyadic& r, const Dyadic& s) {
  const Dyadic m = square(s) - square(beyond);
  if (sign_of(m) < 0 || is_at_most(q, square(r))) return sign_of(m) >= 0;
  const Dyadic more = q - square(r) - m;
  return sign_of(more) <= 0 || is_at_most(square(more), Dyadic(4) * square(r) * m);
}

}  // namespace detail

/// Do they have a point in common? The answer is exact (C11). Touching is intersecting.
///
/// Requires: axes parallel to the same coordinate axis. Errors: std::invalid_argument where they are not;
/// std::runtime_error as certified_collision().
inline Status certified_status(const AxialCylinder& a, const AxialCylinder& b) {
  using detail::Dyadic;
  detail::expect_usual_arithmetic();
  if (a.axis() != b.axis()) throw std::invalid_argument("the cylinders are not parallel");
  const Dyadic of_a = a.center().divisor(), of_b = b.center().divisor(), both = of_a * of_b;
  const auto p = detail::seen_along(a.axis(), a.center().exactly(0)),
             q = detail::seen_along(a.axis(), b.center().exactly(0));
  std::array<Dyadic, 3> way;
  for (std::size_t i = 0; i < 3; ++i) way[i] = of_b * p[i] - of_a * q[i];
  const Dyadic reach = both * (Dyadic(a.radius()) + b.radius()), heights = both * (Dyadic(a.height()) + b.height());
  const bool intervals_meet = detail::is_at_most(Dyadic(4) * detail::square(way[2]), detail::square(heights));
  const bool discs_meet = detail::is_at_most(detail::square(way[0]) + detail::square(way[1]), detail::square(reach));
  return intervals_meet && discs_meet ? Status::intersecting : Status::separated;
}

/// The same of a cylinder and a ball, a point, or a capsule along its axis. Returns: none where the core of b is not in
/// one line parallel to the axis, or more than a sum of one set.
inline std::optional<Status> certified_status(const AxialCylinder& a, const Grown& b) {
  using detail::Dyadic;
  detail::expect_usual_arithmetic();
  if (b.sets().size() != 1) return std::nullopt;
  const detail::MovedSet& points = b.sets()[0];
  const Dyadic of_a = a.center().divisor(), of_b = points.divisor(), both = of_a * of_b;
  const auto center = detail::seen_along(a.axis(), a.center().exactly(0));
  std::optional<std::array<Dyadic, 3>> low, high;  // from the center of the cylinder
  for (std::size_t k = 0; k < points.given().points.size(); ++k) {
    std::array<Dyadic, 3> way = detail::seen_along(a.axis(), points.exactly(k));
    for (std::size_t i = 0; i < 3; ++i) way[i] = of_a * way[i] - of_b * center[i];
    if (low && (sign_of(way[0] - (*low)[0]) != 0 || sign_of(way[1] - (*low)[1]) != 0)) return std::nullopt;
    if (!low || sign_of(way[2] - (*low)[2]) < 0) low = way;
    if (!high || sign_of(way[2] - (*high)[2]) > 0) high = way;
  }
  const Dyadic half = both * a.height();  // all along the axis is taken twice: no half of a double is lost
  const Dyadic above = Dyadic(2) * (*low)[2] - half, below = -(Dyadic(2) * (*high)[2]) - half;
  Dyadic beyond = sign_of(above) > 0 ? above : sign_of(below) > 0 ? below : Dyadic();
  const Dyadic across = Dyadic(4) * (detail::square((*low)[0]) + detail::square((*low)[1]));
  const Dyadic twice = Dyadic(2) * both;
  Dyadic reach;
  for (const double radius : b.radii()) reach = reach + radius;
  return detail::is_within_reach(across, beyond, twice * a.radius(), twice * reach) ? Status::intersecting
                                                                                    : Status::separated;
}

}  // namespace gjk
