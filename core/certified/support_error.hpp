/// How well the support functions of shapes.hpp know their points. Proofs about shapes whose points are computed rest
/// on that.
///
///  C6. Of a shape let SupportError{size, error} = support_error(shape). The shape lies within `size` of the origin.
///      Let d be any direction with a length from 1/4 to 4. Then near_support(shape, d) is within `error` of a point of
///      the shape. And no point of the shape lies farther along d than near_support(shape, d) by more than error·|d|.
///
/// A shape is what its numbers say, as they are stored: the rotation of a pose is its matrix, not an angle. u is half
/// the epsilon of S. Terms of u² are far below what each bound leaves over. So is what does not overflow, see
/// SupportError.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>

#include "../shapes.hpp"

namespace gjk {

struct SupportError {
  double size = 0;
  double error = 0;  ///< infinite where products might overflow

  /// Adds what underflow loses, some ten times half the least number, and leaves room for how this itself was rounded. Of finer
  /// numbers it adds what they lose as doubles: half the least one in each of three components and in a radius.
  /// `in_roundings`: long doubles, in which multiples of the largest doubles do not overflow.
  template <class S>
  static SupportError of(double size, long double in_roundings) {
    constexpr double u = std::numeric_limits<S>::epsilon() / 2.0,
                     of_doubles = std::numeric_limits<double>::denorm_min();
    constexpr double least = std::max(static_cast<double>(std::numeric_limits<S>::denorm_min()), of_doubles);
    constexpr S most = std::numeric_limits<S>::max() * S(0x1p-20);
    const double error = static_cast<double>(u * in_roundings) + 16 * least;
    return {size + 4 * of_doubles, size < most ? error : std::numeric_limits<double>::infinity()};
  }
};

namespace detail {

/// Returns: |x| + |y| + |z|, which is at least the length.
template <class S>
double sum_of_sizes(const Vec3<S>& v) {
  return v.template cast<double>().cwiseAbs().sum();
}

}  // namespace detail

// -- Points -----------------------------------------------------------------------------------------------------------

/// A point is given, not computed. It may be the wrong one: products p·d of two points are off by 3u|p||d| each.
template <class S>
SupportError support_error(const PointSet<S>& points) {
  const double size = detail::sum_of_sizes(points.extent());
  return SupportError::of<S>(size, 8.0L * size);
}
template <class S>
Vec3<S> near_support(const PointSet<S>& points, const Vec3<S>& d) {
  return points.support(d).point;
}

// -- Balls ------------------------------------------------------------------------------------------------------------

/// c + r d/|d|:
///  1. The components of d divided by the largest turn it by u, and the point by ur.
///  2. The norm is off by 2.5u of it, the quotient by 1u, the product by 1u.
///  3. Their sum is rounded by u(|c| + r).
///  4. Together 6.5ur + u|c|.
template <class S>
SupportError support_error(const Sphere<S>& ball) {
  const double center = detail::sum_of_sizes(ball.center()), r = static_cast<double>(ball.radius());
  return SupportError::of<S>(center + r, 8.0L * r + 2.0L * center);
}
template <class S>
Vec3<S> near_support(const Sphere<S>& ball, const Vec3<S>& d) {
  return ball.support(d).point;
}

// -- Cylinders --------------------------------------------------------------------------------------------------------

/// Here a and s are the axis and d, each divided by its largest component. So 1 <= |a|, |s| <= √3. H is half the
/// height.
///
/// From the point computed to the cylinder:
///  1. The quotient a turns it by u: u(H + r).
///  2. Norm, quotient and product make the way to the cap off by 4.5uH.
///  3. Two sums round by u(|c| + H) and u(|c| + H + r).
///  4. a×s is off by at most 7u. Where it is longer than 16u, more than 0.9 of it is perpendicular to a.
///  5. (a×s)×a rounds by 2.5u|a×s||a|. So at most 2.8u of it are out of the plane of the cap.
///  6. Quotient and products bring that to 5u, and the length is off by 5.5u.
///  7. Together 13ur + 9uH + 2u|c|.
///
/// Along d:
///  1. The other cap is taken where s·a, which is off by 3u|s||a|, has the wrong sign: 8uH.
///  2. s is d turned by u: 2u(H + r).
///  3. The error of a×s turns the way to the rim, which costs less than 4ur.
///  4. Where a×s is no longer than 16u in any component, it is at most 35u long. There near_support() takes the middle
///     of the cap, which costs 35ur.
///  5. Together with the above 54ur + 19uH.
template <class S>
SupportError support_error(const Cylinder<S>& can) {
  const double center = detail::sum_of_sizes(can.center()), r = static_cast<double>(can.radius());
  const double H = static_cast<double>(can.height()) / 2;
  return SupportError::of<S>(center + r + H, 64.0L * (r + H) + 4.0L * center);
}
template <class S>
Vec3<S> near_support(const Cylinder<S>& can, const Vec3<S>& d) {
  const Vec3<S> s = d / d.cwiseAbs().maxCoeff();
  if (can.axis().cross(s).cwiseAbs().maxCoeff() > 8 * std::numeric_limits<S>::epsilon()) return can.support(d).point;
  return s.dot(can.axis()) < S(0) ? Vec3<S>(can.center() - can.to_cap()) : Vec3<S>(can.center() + can.to_cap());
}

// -- Shapes that are moved, and sums ----------------------------------------------------------------------------------

/// The error is finite where the rotation is one to a thousandth. Else it is not known how far it stretches.
///
///  1. Of a point x, each component of the rotated one is a sum of three products, off by 3u of their sizes: together
///     3√3u|x|.
///  2. Moved, it is rounded by u(|x| + |t|).
///  3. The direction turned back is as much off, 3√3u|d|. So is what it finds, twice: for a point and for the one that
///     would be farther.
///  4. Together 17u·size + u|t|, and the error of the shape at rest.
template <class S, class A>
SupportError support_error(const Posed<S, A>& posed) {
  const Eigen::Matrix<double, 3, 3> R = posed.pose().rotation.template cast<double>();
  const auto off = (R.transpose() * R - Eigen::Matrix<double, 3, 3>::Identity()).cwiseAbs().maxCoeff();
  const SupportError rest = support_error(posed.shape());
  const double way = detail::sum_of_sizes(posed.pose().translation), stretched = 1.002;
  SupportError moved = SupportError::of<S>(stretched * rest.size + way, 18.0L * rest.size + 2.0L * way);
  moved.error += stretched * rest.error;
  if (!(off < 1e-3)) moved.error = std::numeric_limits<double>::infinity();
  return moved;
}
template <class S, class A>
Vec3<S> near_support(const Posed<S, A>& posed, const Vec3<S>& d) {
  return posed.pose()(near_support(posed.shape(), posed.pose().turned_back(d)));
}

/// Two points are added, which rounds by u of their sizes.
template <class S, class A, class B>
SupportError support_error(const MinkowskiSum<S, A, B>& sum) {
  const SupportError a = support_error(sum.a()), b = support_error(sum.b());
  SupportError both = SupportError::of<S>(a.size + b.size, 2.0L * (a.size + b.size));
  both.error += a.error + b.error;
  return both;
}
template <class S, class A, class B>
Vec3<S> near_support(const MinkowskiSum<S, A, B>& sum, const Vec3<S>& d) {
  return near_support(sum.a(), d) + near_support(sum.b(), d);
}

/// A shape whose support points are known that well.
template <class T, class S>
concept BoundedShape = requires(const T& shape, const Vec3<S>& d) {
  { support_error(shape) } -> std::same_as<SupportError>;
  { near_support(shape, d) } -> std::convertible_to<Vec3<S>>;
};

}  // namespace gjk
