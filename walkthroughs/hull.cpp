#include "walkthroughs/hull.hpp"

#include <algorithm>
#include <tuple>

namespace walkthroughs {
namespace {

using render::Vec2;

bool turns_left(const Vec2& p, const Vec2& q, const Vec2& r) {
  const Vec2 u = q - p, v = r - q;
  return u.x() * v.y() - u.y() * v.x() > 0;
}

/// Appends the chain of left turns through `points` to `hull`, and drops its last point, where the next chain begins.
template <class Points>
void append_chain(const Points& points, std::vector<Vec2>& hull) {
  const std::size_t start = hull.size();
  for (const Vec2& p : points) {
    while (hull.size() >= start + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
    hull.push_back(p);
  }
  if (hull.size() > start + 1) hull.pop_back();
}

/// Andrew's monotone chain (Inf. Proc. Letters 9, 1979). Counter-clockwise, without collinear points.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto key = [](const Vec2& p) { return std::tuple(p.x(), p.y()); };
  std::ranges::sort(points, {}, key);
  const auto repeated = std::ranges::unique(points);
  points.erase(repeated.begin(), repeated.end());
  std::vector<Vec2> hull;
  append_chain(points, hull);
  std::ranges::reverse(points);
  if (points.size() > 1) append_chain(points, hull);
  return hull;
}

}  // namespace

std::string LabelledHull::name(const Point& w) const {
  const auto corner = std::ranges::find(corners, Vec2(w.head<2>()));
  if (corner == corners.end()) return "";
  const auto index = corner - corners.begin();
  const std::string letter(1, static_cast<char>('A' + index % 26));
  return index < 26 ? letter : letter + std::to_string(index / 26);
}

LabelledHull difference_hull(const Scene& scene) {
  std::vector<Vec2> differences;
  const std::vector<Point> of_b = vertices_of(scene.b);
  for (const Point& a : vertices_of(scene.a))
    for (const Point& b : of_b) differences.push_back((a - b).head<2>());
  std::vector<Vec2> corners = convex_hull(std::move(differences));
  const auto first = std::ranges::max_element(corners, {}, [](const Vec2& p) { return std::tuple(p.x(), p.y()); });
  std::ranges::rotate(corners, first);
  return {corners};
}

}  // namespace walkthroughs
