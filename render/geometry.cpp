#include "render/geometry.hpp"

#include <algorithm>

namespace render {

// Liang and Barsky (1984): the segment enters the box where it has entered both slabs and leaves it where it leaves
// the first.
std::optional<Interval> clip_segment(const Vec2& from, const Vec2& to, const Box& box) {
  Interval inside;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = to[axis] - from[axis];
    if (step == 0) {
      if (from[axis] < box.min[axis] || from[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double at_min = (box.min[axis] - from[axis]) / step;
    const double at_max = (box.max[axis] - from[axis]) / step;
    inside.from = std::max(inside.from, std::min(at_min, at_max));
    inside.to = std::min(inside.to, std::max(at_min, at_max));
  }
  if (inside.from > inside.to) return std::nullopt;
  return inside;
}

// Sutherland and Hodgman (1974), for one edge.
std::vector<Vec2> clip_polygon(std::span<const Vec2> polygon, const Vec2& gradient, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double at_from = gradient.dot(from) + offset, at_to = gradient.dot(to) + offset;
    if (at_from >= 0) kept.push_back(from);
    if ((at_from < 0) != (at_to < 0)) kept.push_back(from + (to - from) * (at_from / (at_from - at_to)));
  }
  return kept;
}

}  // namespace render
