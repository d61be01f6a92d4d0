/// The bodies of the study as this project's shapes.
#pragma once

#include <variant>

#include "core/shapes.hpp"
#include "tests/study/pairs/pair.hpp"

namespace peers {

using PointSet = gjk::PointSet<double>;
using Sphere = gjk::Sphere<double>;
using Cylinder = gjk::Cylinder<double>;

inline PointSet shape(const study::Points& points) { return PointSet(points); }
inline Sphere shape(const study::Ball& ball) { return {ball.center, ball.radius}; }
inline Cylinder shape(const study::Can& can) { return {can.center, can.axis, can.radius, can.height}; }

using AnyShape = std::variant<PointSet, Sphere, Cylinder>;
inline AnyShape any_shape(const study::Body& body) {
  return std::visit([](const auto& one) { return AnyShape(shape(one)); }, body);
}

/// Some point well inside, from which some searches start.
inline study::Vec center(const study::Points& points) {
  study::Vec sum = study::Vec::Zero();
  for (const study::Vec& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}
inline study::Vec center(const study::Ball& ball) { return ball.center; }
inline study::Vec center(const study::Can& can) { return can.center; }
inline study::Vec center(const study::Body& body) {
  return std::visit([](const auto& one) { return center(one); }, body);
}

}  // namespace peers
