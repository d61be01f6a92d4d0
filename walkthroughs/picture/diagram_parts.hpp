/// What the diagrams share: frames, points, outlines.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

/// Returns: `box` cut into `count` frames of equal width, side by side.
std::vector<render::Box> side_by_side(const render::Box& box, int count);

void draw_point(render::Panel& panel, const render::Vec2& at, render::Color color, const Style& style);
/// A ring, for a point that is not the one meant.
void draw_hollow_point(render::Panel& panel, const render::Vec2& at, render::Color color, const Style& style);
void draw_origin(render::Panel& panel, const Style& style);
/// The plus sign of the origin in a search. On the mark of one of `points`, where it would be lost, it reaches out beyond that.
void draw_origin_among(render::Panel& panel, const render::Vec2& at, const std::vector<render::Vec2>& points,
                       const Style& style);

/// Returns: the curve at `distance` around a convex polygon, its arcs as polygons, counter-clockwise.
/// Requires: at least 3 corners, counter-clockwise, not on one line; distance > 0.
std::vector<render::Vec2> offset_outward(const std::vector<render::Vec2>& corners, double distance);

/// Returns: the corners of a planar set that is known only by its support function, counter-clockwise, as far as
/// `questions` directions at equal angles find them. Requires: a multiple of 4; then none of them is an axis, where two
/// corners may be equally far.
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

/// Returns: "12,345".
std::string with_commas(std::size_t count);

}  // namespace walkthroughs::picture
