#include "walkthroughs/picture/diagram_parts.hpp"

#include <algorithm>

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Vec2;

// Page units.
constexpr double gap_between_frames = 20;
constexpr double paper_around_point = 2, ring_width = 2.5;
constexpr double origin_arm = 10;
constexpr double arm_among = 8;     // so small that it does not hide the edge on which it stands
constexpr double arm_on_mark = 19;  // beyond the ring around the newest vertex

}  // namespace

std::vector<Box> side_by_side(const Box& box, int count) {
  const double width = (box.width() - gap_between_frames * (count - 1)) / count;
  std::vector<Box> frames;
  for (int i = 0; i < count; ++i) {
    const double left = box.min.x() + i * (width + gap_between_frames);
    frames.push_back({{left, box.min.y()}, {left + width, box.max.y()}});
  }
  return frames;
}

void draw_point(render::Panel& panel, const Vec2& at, render::Color color, const Style& style) {
  panel.disc(at, style.point_radius + paper_around_point, style.theme.paper);
  panel.disc(at, style.point_radius, color);
}

void draw_hollow_point(render::Panel& panel, const Vec2& at, render::Color color, const Style& style) {
  panel.disc(at, style.point_radius, style.theme.paper);
  panel.circle(at, style.point_radius - 1, {color, ring_width * style.theme.line});
}

void draw_origin(render::Panel& panel, const Style& style) {
  panel.plus(Vec2::Zero(), origin_arm, style.origin);
  panel.label(Vec2::Zero(), {1, 1}, "O", style.label(style.theme.ink));
}

void draw_origin_among(render::Panel& panel, const Vec2& at, const std::vector<Vec2>& points, const Style& style) {
  const auto distance = [&](const Vec2& p) { return (panel.view().page(p) - panel.view().page(at)).norm(); };
  const bool is_on_mark =
      std::ranges::any_of(points, [&](const Vec2& p) { return distance(p) < style.point_radius + paper_around_point; });
  panel.plus(at, is_on_mark ? arm_on_mark : arm_among, style.origin);
}

std::vector<Vec2> offset_outward(const std::vector<Vec2>& corners, double distance) {
  constexpr double step = std::numbers::pi / 24;  // of an arc, at most
  std::vector<Vec2> curve;
  const auto outward = [&](std::size_t i) {  // of the side from corner i to the next
    const Vec2 side = corners[(i + 1) % corners.size()] - corners[i % corners.size()];
    return Vec2(side.y(), -side.x()).normalized();
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 before = outward(i + corners.size() - 1), after = outward(i);
    const double start = std::atan2(before.y(), before.x());
    const double turn = std::acos(std::clamp(before.dot(after), -1.0, 1.0));
    const int steps = static_cast<int>(std::ceil(turn / step));
    for (int k = 0; k <= steps; ++k) {
      const double angle = start + turn * k / steps;
      curve.push_back(corners[i] + distance * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return curve;
}

std::string with_commas(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

}  // namespace walkthroughs::picture
