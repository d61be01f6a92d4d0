/// Outlines that only Figures 2 and 3 need: a band around a polygon, and a set known by its support function.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

/// Returns: the curve at `distance` around a convex polygon, its arcs as polygons, counter-clockwise.
/// Requires: at least 3 corners, counter-clockwise, not on one line; distance > 0.
std::vector<render::Vec2> offset_outward(const std::vector<render::Vec2>& corners, double distance);

/// Returns: the corners of a planar set that is known only by its support function, counter-clockwise, as far as `questions`
/// directions at equal angles find them. Requires: a multiple of 4; then none of them is an axis, where two corners may be
/// equally far.
template <gjk::Shape<double> S>
std::vector<render::Vec2> outline_by_support(const S& shape, int questions) {
  std::vector<render::Vec2> corners;
  for (int i = 0; i < questions; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / questions;
    const gjk::SupportPoint<double> found = shape.support(Point(std::cos(angle), std::sin(angle), 0));
    const render::Vec2 corner = found.point.template head<2>();
    if (corners.empty() || corners.back() != corner) corners.push_back(corner);
  }
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

}  // namespace walkthroughs
