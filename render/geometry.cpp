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

}  // namespace render
