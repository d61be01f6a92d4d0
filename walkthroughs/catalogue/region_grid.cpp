#include "walkthroughs/catalogue/region_grid.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "core/event_words.hpp"
#include "core/gjk.hpp"

namespace walkthroughs::catalogue {
namespace {

using gjk::Role;
using render::Vec2;

/// Returns: the part of `v` perpendicular to `others`, which are at most two and linearly independent.
Point perpendicular_part(Point v, const std::vector<Point>& others) {
  std::vector<Point> basis;
  const auto remove_from = [&](Point u) {
    for (const Point& b : basis) u -= b * (b.dot(u) / b.squaredNorm());
    return u;
  };
  for (const Point& other : others) basis.push_back(remove_from(other));
  return remove_from(v);
}

/// The directions from the first of `points` to the others.
std::vector<Point> spanned(const std::vector<Point>& points) {
  std::vector<Point> vectors;
  for (std::size_t i = 1; i < points.size(); ++i) vectors.push_back(points[i] - points[0]);
  return vectors;
}

/// Returns: what a translucent colour looks like on paper.
render::Color on_paper(render::Color color, render::Color paper) {
  const auto mix = [&](std::uint8_t over, std::uint8_t under) {
    return static_cast<std::uint8_t>((over * color.a + under * (255 - color.a) + 127) / 255);
  };
  return {mix(color.r, paper.r), mix(color.g, paper.g), mix(color.b, paper.b)};
}

/// Keeps what a picture needs of the events.
struct Listener {
  Answer& answer;
  void operator()(gjk::RegionTested<double>&& event) { answer.regions.push_back(std::move(event)); }
  void operator()(gjk::DirectionChosen<double>&& event) { answer.direction = event.direction; }
  template <class E>
  void operator()(const E&) {}
};

}  // namespace

// -- Geometry: the regions of the report ----------------------------------------------------------------------------

// A point p lies beyond a feature when the nearest point of the feature's line or plane is one of the feature, and the step
// from there to p leads away from every other vertex. Both are linear in p: with the parts perpendicular to the feature
// (or to the feature without one of its vertices) they are signs of dot products.
std::vector<HalfSpace> region_beyond(const Simplex& simplex, std::string_view feature) {
  std::vector<Point> in, out;
  for (int i = 0; i < simplex.size(); ++i) {
    const Role role = static_cast<Role>(i);
    (feature.find(gjk::letter(role)) != std::string_view::npos ? in : out).push_back(simplex.point(role));
  }
  std::vector<HalfSpace> spaces;
  for (std::size_t i = 0; in.size() > 1 && i < in.size(); ++i) {
    std::vector<Point> rest = in;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    spaces.push_back({rest[0], perpendicular_part(in[i] - rest[0], spanned(rest))});
  }
  for (const Point& other : out) spaces.push_back({in[0], -perpendicular_part(other - in[0], spanned(in))});
  return spaces;
}

std::vector<Vec2> common_part(std::vector<Vec2> polygon, const std::vector<HalfSpace>& spaces, double height) {
  for (const HalfSpace& space : spaces)
    polygon = render::clip_polygon(polygon, space.normal.head<2>(), space(Point(0, 0, height)));
  return polygon;
}

bool lies_in(const Point& p, const std::vector<HalfSpace>& spaces) {
  return std::ranges::all_of(spaces, [&](const HalfSpace& space) { return space(p) >= 0; });
}

// -- Answers of the algorithm -----------------------------------------------------------------------------------------

Simplex simplex_of(const std::vector<Point>& oldest_first) {
  Simplex simplex;
  for (const Point& w : oldest_first) simplex.add({.a = w, .b = Point(Point::Zero()), .w = w});
  return simplex;
}

const gjk::RegionTested<double>& Answer::chosen() const {
  return *std::find_if(regions.rbegin(), regions.rend(),
                       [](const auto& r) { return r.verdict == gjk::Verdict::chosen; });
}

Answer ask(const Simplex& simplex, const Point& origin) {
  Simplex moved;
  for (int i = 0; i < simplex.size(); ++i) {
    Vertex vertex = simplex[i];
    vertex.a.point -= origin;
    vertex.w -= origin;
    moved.add(vertex);
  }
  Answer answer;
  Listener listener{answer};
  gjk::process<gjk::AsIntended>(moved, gjk::CrossingTest::on, listener);
  return answer;
}

std::string name_of(const Answer& answer, const Simplex& simplex) {
  const gjk::RegionTested<double>& chosen = answer.chosen();
  const gjk::RegionLabel label = label_of(chosen);
  if (label == gjk::RegionLabel::R3_or_R4) {
    const Point BA = simplex.point(Role::A) - simplex.point(Role::B);
    return BA.cross(answer.direction).z() > 0 ? "R3" : "R4";
  }
  if (label != gjk::RegionLabel::none) return std::string(to_string(label));
  if (chosen.feature == "ABCD") return "inside";
  return to_string(chosen.feature) + (chosen.face.empty() ? "" : " of " + to_string(chosen.face));
}

std::vector<HalfSpace> tested_half_spaces(const Answer& answer, const Simplex& simplex) {
  std::vector<HalfSpace> spaces;
  for (const gjk::RegionTested<double>& region : answer.regions) {
    if (!region.normal || region.relation != gjk::Relation::positive) continue;
    const bool chosen = region.verdict == gjk::Verdict::chosen;
    spaces.push_back({simplex.point(Role::A), chosen ? *region.normal : Point(-*region.normal)});
  }
  return spaces;
}

// -- The grid ---------------------------------------------------------------------------------------------------------

Window window_of(const render::Panel& panel, double height) {
  const render::Box shown = render::Box::around(panel.corners());
  return {shown.min, shown.max, height};
}

RegionGrid::RegionGrid(const Window& window, int columns, int rows, const std::function<std::string(const Point&)>& ask)
    : window_(window), columns_(columns), rows_(rows) {
  const Vec2 size = window.high - window.low;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Point middle(window.low.x() + size.x() * (column + 0.5) / columns,
                         window.low.y() + size.y() * (row + 0.5) / rows, window.height);
      cells_.push_back({middle, ask(middle)});
    }
}

Vec2 RegionGrid::corner(int column, int row) const {
  const Vec2 size = window_.high - window_.low;
  return {window_.low.x() + size.x() * column / columns_, window_.low.y() + size.y() * row / rows_};
}

const std::string& RegionGrid::text(int column, int row) const {
  return cells_[static_cast<std::size_t>(row * columns_ + column)].text;
}

bool RegionGrid::are_alike(int row, int other) const {
  return std::ranges::all_of(std::views::iota(0, columns_),
                             [&](int column) { return text(column, row) == text(column, other); });
}

std::vector<RegionGrid::Block> RegionGrid::blocks() const {
  std::vector<Block> blocks;
  for (int row = 0, above = 0; row < rows_; row = above) {
    for (above = row + 1; above < rows_ && are_alike(row, above);) ++above;
    for (int column = 0, next = 0; column < columns_; column = next) {
      for (next = column + 1; next < columns_ && text(next, row) == text(column, row);) ++next;
      blocks.push_back({corner(column, row), corner(next, above), text(column, row)});
    }
  }
  return blocks;
}

RegionGrid ask_everywhere(const Simplex& simplex, const Window& window, double cell) {
  const Vec2 size = window.high - window.low;
  const auto cells = [&](double length) { return std::max(1, static_cast<int>(std::lround(length / cell))); };
  return {window, cells(size.x()), cells(size.y()),
          [&](const Point& origin) { return name_of(ask(simplex, origin), simplex); }};
}

std::vector<AnsweredArea> answered_areas(const Simplex& simplex, const RegionGrid& grid) {
  std::vector<AnsweredArea> areas;
  for (const auto& [middle, name] : grid.cells())
    if (std::ranges::count(areas, name, &AnsweredArea::name) == 0)
      areas.push_back({name, tested_half_spaces(ask(simplex, middle), simplex)});
  return areas;
}

// -- Drawing ----------------------------------------------------------------------------------------------------------

RegionGrid ask_all_over(const render::Panel& panel, const Simplex& simplex, double height) {
  constexpr double cell = 1.75;  // page units
  return ask_everywhere(simplex, window_of(panel, height), cell / panel.view().scale());
}

void draw_blocks(render::Panel& panel, const std::vector<RegionGrid::Block>& blocks,
                 const std::function<render::Color(const std::string&)>& fill, render::Color paper) {
  // Of each block below its right and upper neighbours, which are drawn later: no seams.
  const Vec2 overlap = Vec2::Constant(4 / panel.view().scale());
  for (const RegionGrid::Block& block : blocks)
    panel.polygon(Window{block.low, block.high + overlap}.corners(), on_paper(fill(block.text), paper));
}

void draw_ruled_out(render::Panel& panel, const std::vector<Vec2>& area, const Style& style) {
  constexpr std::uint8_t veil = 150;
  if (area.empty()) return;
  panel.polygon(area, style.theme.paper.with_alpha(veil));
  panel.hatch(area, style.hatch_spacing, style.hatching);
}

}  // namespace walkthroughs::catalogue
