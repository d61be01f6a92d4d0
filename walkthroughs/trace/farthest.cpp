#include <cmath>

#include "render/length.hpp"
#include "walkthroughs/model/farthest_face.hpp"
#include "walkthroughs/trace/replay.hpp"

namespace walkthroughs::trace {
namespace {

/// A share of the largest coordinate: a few dozen roundings, and what they leave of a rotation.
constexpr double roundings = 1024;

double largest(const Point& p) { return p.cwiseAbs().maxCoeff(); }

/// Multiplies lengths by a power of two, which rounds nothing that is not as small as its new unit of rounding.
struct Scaled {
  int exponent;

  double length(double x) const { return std::scalbn(x, exponent); }
  Point point(const Point& p) const {
    return p.unaryExpr([this](double x) { return length(x); });
  }
  Point direction(const Point& d) const { return d; }
};

/// One overload for each form that has a sentence of its own.
class Objection {
 public:
  Objection(const gjk::SupportPoint<double>& found, const Object& object, const Point& direction,
            const Precision& precision)
      : found_(found),
        pose_(object.pose),
        length_(largest(direction)),
        along_(direction / length_),
        precision_(precision),
        shear_(object.pose.matrix_as_written ? distance_from_rotation(object.pose.rotation) : 0) {}

  std::string operator()(const Points& points) const {
    if (!found_.index) return "has no index, though it is one of a list of points";
    if (*found_.index >= static_cast<int>(points.size()))
      return "has index " + std::to_string(*found_.index) + ", but there are " + std::to_string(points.size()) +
             " points";
    const double size = bound_of(points), allowed = allowance(size);
    if (has_overflowed(size)) return "";
    const Point claimed = pose_(points[static_cast<std::size_t>(*found_.index)]);
    if (!(largest(found_.point - claimed) <= allowed))
      return "is not where the point of index " + std::to_string(*found_.index) + " lies";
    for (std::size_t i = 0; i < points.size() && !may_overflow(size); ++i)
      if (pose_(points[i]).dot(along_) > found_.point.dot(along_) + 3 * allowed + vanished())
        return "is not the farthest: the point of index " + std::to_string(i) + " reaches farther";
    return "";
  }

  std::string operator()(const Ball& ball) const {
    if (has_overflowed(bound_of(ball))) return "";
    const Point farthest = pose_(ball.center) + along_ * (ball.radius / along_.norm());
    const bool is_there = largest(found_.point - farthest) <= allowance(bound_of(ball));
    return is_there ? "" : "is not the farthest point of the sphere";
  }

  std::string operator()(const Cylinder& cylinder) const {
    if (has_overflowed(bound_of(cylinder))) return "";
    const double half = cylinder.height / 2, radius = cylinder.radius;
    const double allowed = allowance(bound_of(cylinder));
    const Point axis = turned(cylinder.axis.stableNormalized()), from_center = found_.point - pose_(cylinder.center);
    const double height = from_center.dot(axis), distance = render::length_of(from_center - height * axis);
    const bool in_cap = std::abs(std::abs(height) - half) <= allowed;
    const bool on_rim = std::abs(distance - radius) <= allowed;
    if (!in_cap || !(on_rim || distance <= allowed)) return "lies neither on a rim nor in the middle of a cap";
    const double rise = along_.dot(axis);
    const double reach = std::abs(rise) * half + (along_ - rise * axis).norm() * radius;
    return from_center.dot(along_) >= reach - 3 * allowed ? "" : "is not the farthest point of the cylinder";
  }

  /// Seen from the shape at rest, and as if it were about as large as 1: the products of lengths neither vanish nor overflow.
  std::string operator()(const auto& shape) const {
    const double size = bound_of(shape), allowed = 3 * allowance(size) + vanished();
    if (may_overflow(size)) return "";
    const Eigen::Matrix3d back = pose_.rotation.transpose();
    const DirectionFrame frame(back * along_);
    const Scaled scaled{size > 0 ? -std::ilogb(size) : 0};
    const double tolerance = scaled.length(allowed);
    const FarthestFace farthest =
        farthest_face(converted<double>(AnyShape(shape), scaled), frame, {tolerance, roundings * precision_.epsilon});
    const Point point = scaled.point(back * (found_.point - pose_.translation));
    if (!(std::abs(point.dot(frame.d) - farthest.reach) <= tolerance))
      return "does not reach as far as the " + std::string(RowOf<decltype(shape)>::kind);
    if (!(distance(frame.across(point), farthest.hull) <= farthest.slack + tolerance))
      return "is not a farthest point of the " + std::string(RowOf<decltype(shape)>::kind);
    return "";
  }

 private:
  double vanished() const { return 4 * precision_.least / length_; }  ///< of the products with the direction itself
  bool may_overflow(double size) const { return !(3 * (size * length_) <= precision_.largest); }

  /// Infinite, as what lies beyond all numbers of the scalar is.
  bool has_overflowed(double size) const {
    return !found_.point.allFinite() && 3 * size + largest(pose_.translation) > precision_.largest;
  }

  double allowance(double size) const {
    return roundings * precision_.epsilon * (3 * size + largest(pose_.translation)) + precision_.least_normal +
           8 * shear_ * size;
  }
  Point turned(const Point& p) const { return Pose{pose_.rotation, Point::Zero()}(p); }

  const gjk::SupportPoint<double>& found_;
  const Pose& pose_;
  const double length_;
  const Point along_;  // its largest component is 1 or -1, so that nothing overflows
  const Precision precision_;
  const double shear_;  // what a matrix as it was written lacks of a rotation
};

}  // namespace

std::string objection_to(const gjk::SupportPoint<double>& found, const Object& object, const Point& direction,
                         Scalar scalar) {
  if (found.index && !std::holds_alternative<Points>(object.form))
    return "has an index, but only objects of 'points' have a list that it could count in";
  return visit_shape(Objection(found, object, direction, precision_of(scalar)), object.form);
}

}  // namespace walkthroughs::trace
