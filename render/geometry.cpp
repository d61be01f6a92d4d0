#include "render/geometry.hpp"

#include <algorithm>

namespace render {
namespace {

/// Appends what is needed of the corners from `first` to before `last`; an index beyond the last corner begins anew.
void append_needed(std::span<const Vec2> polygon, std::size_t first, std::size_t last, double tolerance,
                   std::vector<Vec2>& needed) {
  const auto at = [&](std::size_t i) -> const Vec2& { return polygon[i % polygon.size()]; };
  std::size_t farthest = first;
  double most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double away = distance_to_segment(at(i), at(first), at(last));
    if (away > most) {
      most = away;
      farthest = i;
    }
  }
  if (farthest == first) return needed.push_back(at(first));
  append_needed(polygon, first, farthest, tolerance, needed);
  append_needed(polygon, farthest, last, tolerance, needed);
}

}  // namespace

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += turn(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return twice / 2;
}

double distance_to_segment(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from, to_p = p - from;
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp(to_p.dot(along) / squared, 0.0, 1.0) : 0;
  return (to_p - along * share).norm();
}

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
  kept.reserve(polygon.size() + 1);  // of a convex one
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double at_from = gradient.dot(from) + offset, at_to = gradient.dot(to) + offset;
    if (at_from >= 0) kept.push_back(from);
    if ((at_from < 0) != (at_to < 0)) kept.push_back(from + (to - from) * (at_from / (at_from - at_to)));
  }
  return kept;
}

// What is cut is put onto the border, which rounding misses where corners are very far away.
std::vector<Vec2> clip_polygon(std::span<const Vec2> polygon, const Box& box) {
  std::vector<Vec2> part(polygon.begin(), polygon.end());
  for (const int axis : {0, 1}) {
    const Vec2 along = Vec2::Unit(axis);
    part = clip_polygon(clip_polygon(part, along, -box.min[axis]), -along, box.max[axis]);
    for (Vec2& p : part) p[axis] = std::clamp(p[axis], box.min[axis], box.max[axis]);
  }
  return part;
}

// Douglas and Peucker (1973).
std::vector<Vec2> simplified(std::span<const Vec2> polygon, double tolerance) {
  std::vector<Vec2> needed;
  if (!polygon.empty()) append_needed(polygon, 0, polygon.size(), tolerance, needed);
  return needed;
}

}  // namespace render
