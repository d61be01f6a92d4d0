#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <variant>

#include "walkthroughs/picture/stage.hpp"

namespace walkthroughs::picture {
namespace {

constexpr double least_size = 1e-30, most_size = 1e30;  // whose products of eight lengths are still finite, and not 0
constexpr double farthest_in_sizes = 1e9;  // from the origin: there a coordinate says a billionth of the size
constexpr int most_doublings = 1000;       // a scale that is a number, and its inverse, too

using Extent = Eigen::AlignedBox3d;

/// A box around a shape where the pose puts it, perhaps with some room.
struct ExtentOf {
  const Pose& pose;

  Extent operator()(const Points& points) const {
    Extent extent;
    for (const Point& p : points) extent.extend(pose(p));
    return extent;
  }
  Extent operator()(const auto& round) const {
    using Row = RowOf<decltype(round)>;
    const Point middle = pose(Row::middle(round)), reach = Point::Constant(Row::reach(round));
    return {middle - reach, middle + reach};
  }
  Extent operator()(const Sum& sum) const {
    const Pose turned{pose.rotation, Point::Zero()};
    const Extent first = visit_shape(*this, sum.summands[0]);
    const Extent second = visit_shape(ExtentOf{turned}, sum.summands[1]);
    return {first.min() + second.min(), first.max() + second.max()};
  }
};

struct Scaled {
  double scale;
  Point point(const Point& p) const { return p * scale; }
  Point direction(const Point& d) const { return d; }
  /// What has a size keeps one, also where it vanishes beside the other.
  double length(double x) const { return x == 0 ? 0 : std::max(x * scale, least_size); }
};

/// Moves and scales the points of an event; numbers that are said stay as they are.
struct PlacedEvent {
  const Placing& placing;

  Vertex vertex(Vertex v) const {
    v.a.point = (v.a.point - placing.center) * placing.scale;
    v.b.point = (v.b.point - placing.center) * placing.scale;
    v.w *= placing.scale;
    return v;
  }
  Simplex simplex(const Simplex& simplex) const {
    Simplex moved;
    for (int i = 0; i < simplex.size(); ++i) moved.add(vertex(simplex[i]));
    return moved;
  }
  void operator()(gjk::SupportFound<double>& event) const { event.vertex = vertex(event.vertex); }
  void operator()(gjk::VertexAdded<double>& event) const { event.simplex = simplex(event.simplex); }
  void operator()(gjk::SimplexReduced<double>& event) const {
    event.before = simplex(event.before);
    event.after = simplex(event.after);
  }
  void operator()(gjk::FeatureKept<double>& event) const {
    event.before = simplex(event.before);
    event.after = simplex(event.after);
  }
  void operator()(auto&) const {}
};

}  // namespace

Scene Placing::placed(Scene scene) const {
  for (Object* object : {&scene.a, &scene.b}) {
    object->form = converted<double>(object->form, Scaled{scale});
    object->pose.translation = (object->pose.translation - center) * scale;
  }
  return scene;
}

Trace Placing::placed(Trace trace) const {
  for (auto& event : trace.events) std::visit(PlacedEvent{*this}, event);
  return trace;
}

LabelledHull Placing::placed(LabelledHull hull) const {
  for (render::Vec2& corner : hull.corners) corner *= scale;
  return hull;
}

Placing placing_of(const std::vector<Telling>& tellings) {
  Extent objects;
  double largest = 0;  // of what is drawn
  for (const Telling& telling : tellings) {
    for (const Object* object : {&telling.scene.a, &telling.scene.b})
      objects.extend(visit_shape(ExtentOf{object->pose}, object->form));
    for (const auto& event : telling.trace.events)
      if (const auto* found = std::get_if<gjk::SupportFound<double>>(&event))
        largest = std::max(largest, found->vertex.w.cwiseAbs().maxCoeff());
  }
  Placing placing;
  const double size = objects.sizes().maxCoeff();
  if (tellings.empty() || !(size > 0)) return placing;
  largest = std::max(largest, size);
  if (largest < least_size || largest > most_size)
    placing.scale = std::ldexp(1, std::clamp(-std::ilogb(largest), -most_doublings, most_doublings));
  const Point middle = objects.min() / 2 + objects.max() / 2;
  if (middle.cwiseAbs().maxCoeff() > farthest_in_sizes * size) placing.center = middle;
  return placing;
}

}  // namespace walkthroughs::picture
