#include "walkthroughs/scene.hpp"

#include "core/gjk.hpp"

namespace walkthroughs {

gjk::SupportPoint<double> Object::support(const Point& d) const {
  ++support_calls;
  const Point own_d = pose.turned_back(d);
  gjk::SupportPoint<double> found = std::visit([&](const auto& shape) { return shape.support(own_d); }, form);
  found.point = pose(found.point);
  return found;
}

std::vector<Point> vertices_of(const Object& object) {
  std::vector<Point> vertices;
  if (const auto* set = std::get_if<Points>(&object.form))
    for (const Point& p : set->points()) vertices.push_back(object.pose(p));
  return vertices;
}

Trace run(const Scene& scene) {
  Trace trace;
  switch (scene.rules) {
    case RuleSet::as_intended: gjk::collision<double>(scene.a, scene.b, scene.options, trace); break;
    case RuleSet::as_printed: gjk::collision<double, gjk::AsPrinted>(scene.a, scene.b, scene.options, trace); break;
  }
  return trace;
}

}  // namespace walkthroughs
