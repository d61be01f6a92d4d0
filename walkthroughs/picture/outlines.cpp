#include "walkthroughs/picture/outlines.hpp"

#include <algorithm>

namespace walkthroughs {

using render::Vec2;

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

}  // namespace walkthroughs
