#include "walkthroughs/model/farthest_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace walkthroughs::model {
namespace {

using render::Vec2;

constexpr int rim_points = 72;

/// One overload for each shape.
struct FaceOf {
  const DirectionFrame& frame;
  const Tolerance& tolerance;

  FarthestFace operator()(const Points& points) const {
    double reach = points[0].dot(frame.d);
    for (const Point& p : points) reach = std::max(reach, p.dot(frame.d));
    std::vector<Vec2> face;
    for (const Point& p : points)
      if (p.dot(frame.d) >= reach - tolerance.length) face.push_back(frame.across(p));
    return {reach, convex_hull(std::move(face)), 0};
  }
  FarthestFace operator()(const Ball& ball) const {
    return {ball.center.dot(frame.d) + ball.radius, {frame.across(ball.center)}, 0};
  }
  FarthestFace operator()(const Cylinder& cylinder) const {
    const Point axis = cylinder.axis.stableNormalized();
    const double rise = frame.d.dot(axis), half = cylinder.height / 2, radius = cylinder.radius;
    const Point outward = frame.d - rise * axis;
    const double lean = outward.norm(), reach = half * std::abs(rise) + radius * lean;
    FarthestFace face{cylinder.center.dot(frame.d) + reach, {}, radius * (1 - std::cos(std::numbers::pi / rim_points))};
    if (lean <= tolerance.angle) {  // a cap
      for (int i = 0; i < rim_points; ++i) {
        const double angle = 2 * std::numbers::pi * i / rim_points;
        face.hull.push_back(frame.across(cylinder.center) + radius * Vec2(std::cos(angle), std::sin(angle)));
      }
    } else {  // a point of a rim, or a line from rim to rim
      face.slack = radius * (tolerance.angle / lean);
      for (const double end : {-half, half})
        if (end * rise >= half * std::abs(rise) - tolerance.length)
          face.hull.push_back(frame.across(cylinder.center + outward * (radius / lean) + end * axis));
    }
    face.hull = convex_hull(std::move(face.hull));
    return face;
  }
  FarthestFace operator()(const Sum& sum) const {
    const FarthestFace a = visit_shape(*this, sum.summands[0]), b = visit_shape(*this, sum.summands[1]);
    return {a.reach + b.reach, sum_of_hulls(a.hull, b.hull), a.slack + b.slack};
  }
};

double largest(const Point& p) { return p.cwiseAbs().maxCoeff(); }

struct BoundOf {
  double operator()(const Points& points) const {
    double bound = 0;
    for (const Point& p : points) bound = std::max(bound, largest(p));
    return bound;
  }
  double operator()(const auto& round) const {
    using Row = RowOf<decltype(round)>;
    return largest(Row::middle(round)) + Row::reach(round);
  }
  double operator()(const Sum& sum) const {
    return visit_shape(*this, sum.summands[0]) + visit_shape(*this, sum.summands[1]);
  }
};

}  // namespace

FarthestFace farthest_face(const AnyShape& shape, const DirectionFrame& frame, const Tolerance& tolerance) {
  return visit_shape(FaceOf{frame, tolerance}, shape);
}

double bound_of(const AnyShape& shape) { return visit_shape(BoundOf{}, shape); }

double distance(const Vec2& p, const std::vector<Vec2>& hull) {
  double least = std::numeric_limits<double>::infinity();
  bool is_inside = hull.size() > 2;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &from = hull[i], &to = hull[(i + 1) % hull.size()], edge = to - from, to_p = p - from;
    least = std::min(least, render::distance_to_segment(p, from, to));
    is_inside = is_inside && edge.x() * to_p.y() - edge.y() * to_p.x() >= 0;
  }
  return is_inside ? 0 : least;
}

}  // namespace walkthroughs::model
