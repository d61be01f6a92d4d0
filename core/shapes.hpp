/// Convex sets, each known only by its support function (ARL-TR-7474, Section 2.4).
///
/// All points are in one common frame and one unit of length. `d` is a direction of any length except zero.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "direction_cells.hpp"

namespace gjk {

template <class S>
using Vec3 = Eigen::Matrix<S, 3, 1>;

/// The answer of a support function: a point of the set that no other exceeds in the direction asked for.
template <class S>
struct SupportPoint {
  SupportPoint() = default;
  SupportPoint(Vec3<S> p, std::optional<int> i = std::nullopt) : point(std::move(p)), index(i) {}

  Vec3<S> point;
  std::optional<int> index;  ///< position in the list of vertices; empty for sets that have no such list
  friend bool operator==(const SupportPoint&, const SupportPoint&) = default;
};

/// Anything with a support function is a shape. It may return a plain Vec3<S> where it has no vertices to number.
///
/// Requires of support(d): a point of the set with the largest dot product with d, for every finite d that is not zero.
template <class T, class S>
concept Shape = requires(const T& shape, const Vec3<S>& d) {
  { shape.support(d) } -> std::convertible_to<SupportPoint<S>>;
};

namespace detail {

/// Points in blocks of eight: all x first, then all y, then all z. So a processor multiplies several at a time. On
/// larger sets this takes half the time of asking point by point.
template <class S>
class PointBlocks {
 public:
  /// Whether blocks answer sooner than the points one by one, for so many points of this scalar.
  static constexpr bool pay_off(std::size_t points) { return fit_processor && points >= 2 * size; }

  explicit PointBlocks(const std::vector<Vec3<S>>& points) {
    if (!pay_off(points.size())) return;
    blocks_.reserve((points.size() + size - 1) / size);
    for (std::size_t first = 0; first < points.size(); first += size) {
      Block& block = blocks_.emplace_back();
      for (std::size_t i = 0; i < size; ++i)  // the last point fills up the last block
        block.row(static_cast<Eigen::Index>(i)) = points[std::min(first + i, points.size() - 1)].transpose();
    }
  }

  bool empty() const { return blocks_.empty(); }

  /// Returns: where in the list the first of the farthest points is, as PointSet::support() says. Never inlined: small
  /// sets, which have no blocks, should not have this in their way.
  [[gnu::noinline]] std::size_t farthest(const Vec3<S>& d) const {
    std::size_t best = 0;
    Reaches reaches = reach(blocks_[0], d);
    S most = reaches.maxCoeff();
    for (std::size_t i = 1; i < blocks_.size(); ++i) {
      const Reaches here = reach(blocks_[i], d);
      const S most_here = here.maxCoeff();
      if (most_here > most) {
        most = most_here;
        reaches = here;
        best = i;
      }
    }
    return best * size + first_equal(reaches, most);
  }

 private:
  static constexpr std::size_t size = 8;
  static constexpr bool fit_processor = std::same_as<S, float> || std::same_as<S, double>;
  using Block = Eigen::Array<S, size, 3>;
  using Reaches = Eigen::Array<S, size, 1>;

  /// In the order of PointSet::reach(), so that the same point is farthest.
  static Reaches reach(const Block& block, const Vec3<S>& d) {
    return block.col(0) * d.x() + (block.col(1) * d.y() + block.col(2) * d.z());
  }

  /// Requires: `most` is the largest of `reaches`. It is kept, not computed again: a compiler that is allowed to
  /// contract products might then round them otherwise. All are compared: the processor would guess wrongly how a loop
  /// that ends early goes on.
  /// Returns: below `size`, whatever is not a number.
  static std::size_t first_equal(const Reaches& reaches, const S& most) {
    unsigned equal = 1U << (size - 1);
    for (std::size_t i = 0; i + 1 < size; ++i)
      equal |= static_cast<unsigned>(reaches[static_cast<Eigen::Index>(i)] == most) << i;
    return static_cast<std::size_t>(std::countr_zero(equal));
  }

  std::vector<Block> blocks_;
};

}  // namespace detail

/// The convex hull of finitely many points. The hull itself is never computed.
template <class S>
class PointSet {
 public:
  /// Errors: std::invalid_argument where `points` is empty.
  explicit PointSet(std::vector<Vec3<S>> points) : points_(std::move(points)), blocks_(points_) {
    if (points_.empty()) throw std::invalid_argument("a point set needs at least one point");
    // In one loop of numbers that do not wait for each other: sets that move are made anew each frame.
    Vec3<S> least = Vec3<S>::Zero(), most = Vec3<S>::Zero(), sum = Vec3<S>::Zero();
    for (const Vec3<S>& p : points_) {
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
      if constexpr (std::floating_point<S>) sum += p;
    }
    extent_ = most.cwiseMax(-least);  // of scalars without abs(), too
    if constexpr (std::floating_point<S>) mean_ = sum / static_cast<S>(points_.size());
  }

  /// Eq. 5: the point P with P·d >= Q·d for all Q. Among equals the first in the list.
  SupportPoint<S> support(const Vec3<S>& d) const {
    const std::size_t farthest =
        blocks_.empty() ? farthest_of(points_.size(), d, [](std::size_t i) { return i; }) : among_many(d);
    return {points_[farthest], static_cast<int>(farthest)};
  }

  /// Makes ready for many questions: support() then answers the same, to the last bit, and looks at few points, however many there
  /// are. It pays off for hundreds of points that are asked as often as there are points. Takes n log n time for n points, and memory
  /// for some 32 n numbers at most.
  void prepare() requires std::floating_point<S> {
    if (!blocks_.empty()) cells_ = std::make_shared<detail::DirectionCells<S>>(points_, extent_);
  }

  const std::vector<Vec3<S>>& points() const { return points_; }

  /// Returns: the largest |x|, |y| and |z| of its points. Bounds on rounding need to know that of a set. Computed with
  /// each query it would cost as much as the query.
  const Vec3<S>& extent() const { return extent_; }

  /// Returns: the mean of its n points, well inside, for searches to start from (Options::inside). It is not finite
  /// where the sum overflows.
  ///
  /// It is off by at most nur in each component, but for terms of u². Here r is the extent and u half the epsilon of S.
  /// The reason: n − 1 sums of at most nr are rounded and divided by n. The quotient is rounded, too.
  const Vec3<S>& mean() const requires std::floating_point<S> { return mean_; }

 private:
  /// `place`: of the i-th of these points, `count` in all, one at least; they go up.
  std::size_t farthest_of(std::size_t count, const Vec3<S>& d, const auto& place) const {
    std::size_t farthest = place(0);
    S most = reach(points_[farthest], d);
    for (std::size_t i = 1; i < count; ++i) {
      const S here = reach(points_[place(i)], d);
      if (here > most) {
        most = here;
        farthest = place(i);
      }
    }
    return farthest;
  }

  /// Never inlined: small sets should not have this in their way.
  [[gnu::noinline]] std::size_t among_many(const Vec3<S>& d) const {
    if constexpr (std::floating_point<S>) {
      const auto few = cells_ ? cells_->along(d) : std::span<const std::uint32_t>();
      if (!few.empty()) return farthest_of(few.size(), d, [&](std::size_t i) { return few[i]; });
    }
    return blocks_.farthest(d);
  }

  /// P·d, added up from the right: the order that Eigen's dot() takes depends on the scalar and on the processor.
  static S reach(const Vec3<S>& p, const Vec3<S>& d) { return p.x() * d.x() + (p.y() * d.y() + p.z() * d.z()); }

  std::vector<Vec3<S>> points_;
  Vec3<S> extent_, mean_ = Vec3<S>::Zero();
  detail::PointBlocks<S> blocks_;
  std::shared_ptr<const detail::DirectionCells<S>> cells_;  ///< once it is prepared
};

/// A solid ball.
template <std::floating_point S>
class Sphere {
 public:
  /// Errors: std::invalid_argument unless the radius is finite and not negative. Without radius it is a point.
  Sphere(Vec3<S> center, S radius) : center_(std::move(center)), radius_(radius) {
    if (!(radius >= 0 && std::isfinite(radius)))
      throw std::invalid_argument("a sphere needs a finite radius that is not negative");
  }

  /// Eq. 6: C + R d/|d|. Here we differ: d is first divided by its largest component, because |d|² of a direction
  /// such as (1e-200, 0, 0) is zero in floating point.
  SupportPoint<S> support(const Vec3<S>& d) const {
    const Vec3<S> scaled = d / d.cwiseAbs().maxCoeff();
    return {Vec3<S>(center_ + scaled * (radius_ / scaled.norm()))};
  }

  const Vec3<S>& center() const { return center_; }
  S radius() const { return radius_; }

 private:
  Vec3<S> center_;
  S radius_;
};

/// A solid cylinder with flat caps.
template <std::floating_point S>
class Cylinder {
 public:
  /// `axis`: any length but zero. `height`: from cap to cap; `center` lies halfway. Without height it is a disc,
  /// without radius a segment.
  /// Errors: std::invalid_argument unless radius and height are finite and not negative and the axis is finite and not
  /// zero.
  Cylinder(Vec3<S> center, Vec3<S> axis, S radius, S height)
      : center_(std::move(center)), axis_(std::move(axis)), radius_(radius), height_(height) {
    if (!(radius >= 0 && height >= 0 && std::isfinite(radius) && std::isfinite(height)))
      throw std::invalid_argument("a cylinder needs a finite radius and height that are not negative");
    const S longest = axis_.cwiseAbs().maxCoeff();
    if (!(longest > 0) || !axis_.allFinite())
      throw std::invalid_argument("a cylinder needs a finite axis that is not zero");
    axis_ /= longest;
    to_cap_ = axis_ * (height / 2 / axis_.norm());
  }

  /// The cap on the side of d, and on it the rim point on the side of d, found from (axis×d)×axis.
  ///
  /// Where d is a multiple of the axis that product is exactly zero. All points of the cap are then equally far, and
  /// its middle is returned. Where d is perpendicular to the axis both caps are equally far. Then the one along the
  /// axis is taken. (Rounding decides where the components of an axis askew are rounded.)
  ///
  /// Axis and d have a largest component of 1 or -1.
  ///  - So a multiple of the axis is the axis itself or its opposite, however its quotients were rounded.
  ///  - Close to the axis cross products are little but rounding error. There two of the three components of axis×d are
  ///    exact. This keeps the rim point in the plane of its cap.
  SupportPoint<S> support(const Vec3<S>& d) const {
    const Vec3<S> scaled = d / d.cwiseAbs().maxCoeff();  // as in Sphere
    const Vec3<S> cap = scaled.dot(axis_) < S(0) ? Vec3<S>(center_ - to_cap_) : Vec3<S>(center_ + to_cap_);
    const Vec3<S> outward = axis_.cross(scaled).cross(axis_);
    const S largest = outward.cwiseAbs().maxCoeff();
    if (largest == S(0)) return {cap};
    const Vec3<S> radial = outward / largest;
    return {Vec3<S>(cap + radial * (radius_ / radial.norm()))};
  }

  const Vec3<S>& center() const { return center_; }
  S radius() const { return radius_; }
  /// A cylinder made from these four is the identical one: dividing by a largest component of 1 changes nothing.
  const Vec3<S>& axis() const { return axis_; }
  S height() const { return height_; }
  const Vec3<S>& to_cap() const { return to_cap_; }  ///< from the center to the middle of the cap along the axis

 private:
  Vec3<S> center_, axis_;  // the largest component of the axis is 1 or -1
  S radius_, height_;
  Vec3<S> to_cap_ = Vec3<S>::Zero();
};

/// The rotation p ↦ q p q⁻¹. Its length does not matter, but is not zero.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// A rigid motion: x ↦ rotation·x + translation. Products are written as dot products. Eigen's matrix product does not
/// compile for the exact numbers of Boost.
template <class S>
struct Pose {
  Eigen::Matrix<S, 3, 3> rotation = Eigen::Matrix<S, 3, 3>::Identity();  ///< orthogonal, determinant 1
  Vec3<S> translation = Vec3<S>::Zero();

  Vec3<S> operator()(const Vec3<S>& x) const {
    return Vec3<S>(rotation.row(0).dot(x), rotation.row(1).dot(x), rotation.row(2).dot(x)) + translation;
  }

  /// Returns: `d` turned back, as the resting shape sees it. Its length changes.
  ///
  /// Floating-point directions are first scaled by a power of two, which rounds nothing but what is beside the largest component as
  /// good as nothing. Otherwise the largest finite
  /// ones would overflow in the product, and the smallest would vanish. The shape would then be asked in no direction
  /// (P1). Those of usual size are taken as they are, which is the same but for that power, and sooner.
  Vec3<S> turned_back(const Vec3<S>& d) const {
    if constexpr (std::floating_point<S>) {
      if (!is_of_usual_size(d)) {
        const int exponent = std::ilogb(d.cwiseAbs().maxCoeff());
        return turned_back_as_it_is(d.unaryExpr([=](S x) { return std::scalbn(x, -exponent); }));
      }
    }
    return turned_back_as_it_is(d);
  }

 private:
  static bool is_of_usual_size(const Vec3<S>& d) {
    constexpr S epsilon = std::numeric_limits<S>::epsilon(), least = epsilon * epsilon;
    return std::ranges::all_of(d, [](S x) { return x == 0 || (std::abs(x) > least && std::abs(x) < 1 / least); });
  }

  Vec3<S> turned_back_as_it_is(const Vec3<S>& d) const {
    return {rotation.col(0).dot(d), rotation.col(1).dot(d), rotation.col(2).dot(d)};
  }
};

/// A shape, moved. Holds a copy of it.
template <class S, Shape<S> A>
class Posed {
 public:
  Posed(A shape, Pose<S> pose) : shape_(std::move(shape)), pose_(std::move(pose)) {}

  /// The support point of the moved shape is the moved support point of the shape at rest, along d turned back.
  SupportPoint<S> support(const Vec3<S>& d) const {
    const SupportPoint<S> own = shape_.support(pose_.turned_back(d));
    return {pose_(own.point), own.index};
  }

  void move_to(const Pose<S>& pose) { pose_ = pose; }

  const A& shape() const { return shape_; }
  const Pose<S>& pose() const { return pose_; }

 private:
  A shape_;
  Pose<S> pose_;
};

/// Eq. 3: { X + Y }. Holds copies of its two sets.
template <class S, Shape<S> A, Shape<S> B>
class MinkowskiSum {
 public:
  MinkowskiSum(A a, B b) : a_(std::move(a)), b_(std::move(b)) {}

  /// Eq. 7: support(A, d) + support(B, d).
  SupportPoint<S> support(const Vec3<S>& d) const {
    const SupportPoint<S> a = a_.support(d), b = b_.support(d);
    return {Vec3<S>(a.point + b.point)};
  }

  const A& a() const { return a_; }
  const B& b() const { return b_; }

 private:
  A a_;
  B b_;
};

/// A point w of the Minkowski difference, with the two points it comes from: w = a - b.
template <class S>
struct Vertex {
  SupportPoint<S> a, b;
  Vec3<S> w;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Eq. 4: { X - Y }. Refers to its two sets, which must outlive it. It contains the origin exactly when the sets have a
/// point in common (Section 2.3).
template <class S, Shape<S> A, Shape<S> B>
class MinkowskiDifference {
 public:
  MinkowskiDifference(const A& a, const B& b) : a_(a), b_(b) {}

  /// Eq. 8: support(A, d) - support(B, -d).
  Vertex<S> vertex(const Vec3<S>& d) const {
    Vertex<S> v{a_.support(d), b_.support(-d), {}};
    v.w = v.a.point - v.b.point;
    return v;
  }
  SupportPoint<S> support(const Vec3<S>& d) const { return {vertex(d).w}; }

 private:
  const A& a_;
  const B& b_;
};

}  // namespace gjk
