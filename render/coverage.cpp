#include <algorithm>
#include <cmath>
#include <limits>

#include "render/triangles.hpp"

namespace render {
namespace {

using Polygon = std::vector<Vec2>;

/// A linear function of the position.
struct Ramp {
  Vec2 gradient = Vec2::Zero();
  double offset = 0;

  double at(const Vec2& p) const { return gradient.dot(p) + offset; }
  friend Ramp operator-(const Ramp& a, const Ramp& b) { return {a.gradient - b.gradient, a.offset - b.offset}; }
};

/// Returns the ramp with value `value` at `p`.
Ramp ramp_through(const Vec2& p, double value, const Vec2& gradient) { return {gradient, value - gradient.dot(p)}; }

/// Each cell is clipped by the ramps of all corners: of more than this only those are kept that stand out by so many pixels.
constexpr std::size_t most_corners = 360;
constexpr double least_corner = 1.0 / 32;

/// Returns the corners that differ from the one before, turning from x to y. Empty for a polygon without area.
Polygon cleaned(std::span<const Vec2> corners) {
  Polygon polygon;
  for (const Vec2& corner : corners) {
    if (polygon.empty() || corner != polygon.back()) polygon.push_back(corner);
  }
  while (polygon.size() > 1 && polygon.back() == polygon.front()) polygon.pop_back();

  const double area = signed_area(polygon);
  if (area == 0) return {};
  if (area < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon.size() > most_corners ? simplified(polygon, least_corner) : polygon;
}

/// Blunter corners need no ramp of their own. The limit lies between 120 and 135 degrees: no usual corner is close to it.
constexpr double bluntest_cosine = -0.6;

/// The steepest ramp of a corner, per pixel: just enough for a rectangle of whole pixels to cover its corner pixels.
constexpr double steepest_tip = 1.07;

/// At its tip, a corner covers the share of a full turn that it takes (the sine of its half says it to within 0.04: a
/// quarter for a right angle, nothing for a needle). From there the coverage grows as fast as the corner widens.
Ramp tip_ramp(const Vec2& tip, const Vec2& to_previous, const Vec2& to_next) {
  const Vec2 axis = (to_previous + to_next).normalized();
  const double cosine = axis.dot(to_next);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double share = sine * std::sqrt(0.125);
  return ramp_through(tip, share, std::min(steepest_tip, 2 * sine / cosine) * axis);
}

/// Two equal ramps would each claim the same cell.
void add_if_new(std::vector<Ramp>& ramps, const Ramp& ramp) {
  const bool known = std::any_of(ramps.begin(), ramps.end(), [&](const Ramp& other) {
    return ramp.gradient == other.gradient && ramp.offset == other.offset;
  });
  if (!known) ramps.push_back(ramp);
}

std::vector<Ramp> coverage_ramps(const Polygon& polygon) {
  std::vector<Ramp> ramps;
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& previous = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Vec2& corner = polygon[i];
    const Vec2& next = polygon[(i + 1) % polygon.size()];
    const Vec2 along = (next - corner).normalized(), back = (previous - corner).normalized();

    const Ramp edge = ramp_through(corner, 0.5, {-along.y(), along.x()});
    add_if_new(ramps, edge);
    if (along.dot(back) > bluntest_cosine) add_if_new(ramps, tip_ramp(corner, back, along));

    double depth = 0;
    for (const Vec2& other : polygon) depth = std::max(depth, edge.at(other) - 0.5);
    width = std::min(width, depth);
  }
  add_if_new(ramps, {Vec2::Zero(), std::min(1.0, width)});
  return ramps;
}

/// Returns the part of `bounds` where `ramps[index]` is the least of all ramps and not negative.
Polygon cell_of(std::size_t index, const std::vector<Ramp>& ramps, const Box& bounds) {
  const auto clip = [](const Polygon& polygon, const Ramp& ramp) {
    return clip_polygon(polygon, ramp.gradient, ramp.offset);
  };
  Polygon cell = clip(bounds.corners(), ramps[index]);
  for (std::size_t other = 0; other < ramps.size() && !cell.empty(); ++other) {
    const Ramp above = ramps[other] - ramps[index];
    const bool is_cut = std::ranges::any_of(cell, [&](const Vec2& p) { return above.at(p) < 0; });
    if (other != index && is_cut) cell = clip(cell, above);  // most do not cut
  }
  return cell;
}

}  // namespace

std::vector<CoverageCell> coverage_cells(std::span<const Vec2> corners, const Box& bounds) {
  const Polygon polygon = cleaned(corners);
  if (polygon.empty()) return {};
  const std::vector<Ramp> ramps = coverage_ramps(polygon);

  std::vector<CoverageCell> cells;
  for (std::size_t i = 0; i < ramps.size(); ++i) {
    const Polygon outline = cell_of(i, ramps, bounds);
    if (outline.size() < 3) continue;
    CoverageCell& cell = cells.emplace_back();
    for (const Vec2& p : outline) cell.push_back({p, std::clamp(ramps[i].at(p), 0.0, 1.0)});
  }
  return cells;
}

}  // namespace render
