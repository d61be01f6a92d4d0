/// Polygons of the plane, as tests measure them.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "render/geometry.hpp"

namespace walkthroughs::test {

using render::Vec2;

inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Returns: its area, negative where the corners go around clockwise.
inline double area(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

/// Returns: whether `p` lies in a convex polygon whose corners go around either way, or within `tolerance` of it.
inline bool holds(const std::vector<Vec2>& polygon, const Vec2& p, double tolerance = 0) {
  double most_left = -std::numeric_limits<double>::infinity(), most_right = most_left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double side = cross((polygon[(i + 1) % polygon.size()] - polygon[i]).normalized(), p - polygon[i]);
    most_left = std::max(most_left, side);
    most_right = std::max(most_right, -side);
  }
  return polygon.size() > 2 && std::min(most_left, most_right) <= tolerance;
}

}  // namespace walkthroughs::test
