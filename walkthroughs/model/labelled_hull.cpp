#include "walkthroughs/model/labelled_hull.hpp"

#include <algorithm>
#include <tuple>

namespace walkthroughs::model {
namespace {

using render::Vec2;

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

bool turns_left(const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; }

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

}  // namespace

std::vector<Point> differences(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Point> list;
  for (const Point& p : a)
    for (const Point& q : b) list.push_back(p - q);
  return list;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto key = [](const Vec2& p) { return std::tuple(p.x(), p.y()); };
  std::ranges::sort(points, {}, key);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec2> hull;
  append_chain(points, hull);
  std::ranges::reverse(points);
  if (points.size() > 1) append_chain(points, hull);
  return hull;
}

/// The edges of the sum are those of both, in the order of their directions.
std::vector<Vec2> sum_of_hulls(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  const auto edge = [](const std::vector<Vec2>& hull, std::size_t i) {
    return Vec2(hull[(i + 1) % hull.size()] - hull[i % hull.size()]);
  };
  std::vector<Vec2> sum;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    sum.push_back(a[i % a.size()] + b[j % b.size()]);
    const double turn = cross(edge(a, i), edge(b, j));
    const bool takes_a = i < a.size() && (j == b.size() || turn >= 0);
    const bool takes_b = j < b.size() && (i == a.size() || turn <= 0);
    if (takes_a) ++i;
    if (takes_b) ++j;
  }
  return convex_hull(std::move(sum));
}

std::string LabelledHull::name(const Point& w) const {
  const auto corner = std::ranges::find(corners, Vec2(w.head<2>()));
  if (corner == corners.end()) return "";
  const auto index = corner - corners.begin();
  const std::string letter(1, static_cast<char>('A' + index % 26));
  return index < 26 ? letter : letter + std::to_string(index / 26);
}

LabelledHull difference_hull(const Scene& scene) {
  std::vector<Vec2> shadow;
  for (const Point& w : differences(vertices_of(scene.a), vertices_of(scene.b))) shadow.emplace_back(w.head<2>());
  std::vector<Vec2> corners = convex_hull(std::move(shadow));
  if (corners.empty()) return {};
  const auto first = std::ranges::max_element(corners, {}, [](const Vec2& p) { return std::tuple(p.x(), p.y()); });
  std::rotate(corners.begin(), first, corners.end());
  return {corners};
}

}  // namespace walkthroughs::model
