#include "render/panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

namespace panel_test {

using namespace render;
using kit::vertices_of;

namespace {

constexpr Size size{400, 300};
const Box frame{{50, 20}, {350, 280}};
const TextStyle style{.size = 20};

/// The box around the vertices from `first` on: what the labels drew, when nothing came after them.
Box drawn_since(const Canvas& canvas, std::size_t first) {
  REQUIRE(vertices_of(canvas).size() > first);
  return kit::box_around(vertices_of(canvas, first));
}

/// A panel, on a canvas whose scene units are tenths of page units around the middle of the frame, (200,150).
struct Desk {
  Font font{Font::default_directory()};
  Canvas canvas{size, size, palette::white, font};
  View view = View::fit({-15, -13}, {15, 13}, frame, 10);
  Panel panel{canvas, frame, view};

  /// Places one label and returns its box.
  Box place(const Vec2& anchor, const Vec2& toward, const std::string& text) {
    const std::size_t before = vertices_of(canvas).size();
    panel.label(anchor, toward, text, style);
    panel.place_labels();
    return drawn_since(canvas, before);
  }
};

bool inside(const Box& outer, const Box& inner) {
  return outer.min.x() <= inner.min.x() && outer.min.y() <= inner.min.y() && inner.max.x() <= outer.max.x() &&
         inner.max.y() <= outer.max.y();
}

}  // namespace

TEST_CASE("a view's scale: the tighter side decides, up to the limit, also for boxes without size") {
  const Box page{{0, 0}, {100, 200}};
  REQUIRE(View::fit({0, 0}, {10, 100}, page, 1000).scale() == 2);
  REQUIRE(View::fit({0, 0}, {10, 1}, page, 1000).scale() == 10);
  REQUIRE(View::fit({0, 0}, {10, 1}, page, 4).scale() == 4);
  REQUIRE(View::fit({3, 3}, {3, 3}, page, 40).scale() == 40);
  REQUIRE(View::fit({3, 3}, {3, 3}, page, 40).page({3, 3}) == page.center());
  REQUIRE(View::fit({3, 0}, {3, 100}, page, 40).scale() == 2);
}

std::vector<CanvasVertex> letters(std::span<const CanvasVertex> all) {
  std::vector<CanvasVertex> found;
  std::ranges::copy_if(all, std::back_inserter(found),
                       [](const CanvasVertex& v) { return v.kind == CanvasVertex::Kind::glyph; });
  return found;
}

TEST_CASE_METHOD(Desk, "a label that finds no place near its anchor is tied to it by a line, others are not") {
  const auto lines_of_a_label = [&] {
    panel.label({0, 0}, {1, 0}, "name", style);
    const std::size_t before = vertices_of(canvas).size();
    panel.place_labels();
    const auto list = vertices_of(canvas, before);
    return list.size() - letters(list).size();
  };
  REQUIRE(lines_of_a_label() == 0);
  panel.disc({0, 0}, 40, palette::blue);
  REQUIRE(lines_of_a_label() == 6);
  const CanvasVertex last = vertices_of(canvas).rbegin()[4 * 6];
  const Vec2 anchor = view.page({0, 0});
  REQUIRE((Vec2(last.x, last.y) - anchor).norm() < 60);
}

TEST_CASE_METHOD(Desk, "labels keep off each other, first come first served") {
  const Box alone = place({0, 0}, {1, 0}, "name");
  for (int i = 0; i < 4; ++i) panel.label({0, 0}, {1, 0}, "name", style);
  const std::size_t before = vertices_of(canvas).size();
  panel.place_labels();
  const std::vector<CanvasVertex> list = letters(vertices_of(canvas, before));
  REQUIRE(list.size() == 4 * 4 * 6);
  std::vector<Box> boxes;
  for (std::size_t label = 0; label < 4; ++label) {
    const Box box = kit::box_around(std::span(list).subspan(label * 4 * 6, 4 * 6));
    for (const Box& other : boxes) REQUIRE_FALSE(box.overlaps(other));
    boxes.push_back(box);
  }
  REQUIRE(boxes[0].min == alone.min);
}

TEST_CASE_METHOD(Desk, "labels stay inside the frame") {
  for (const Vec2& corner : panel.corners()) {
    const Box box = place(0.99 * corner, corner, "outward");
    REQUIRE(inside(frame.grown(-3), box));
  }
}

TEST_CASE_METHOD(Desk, "labels stay inside the frame also where all places beside their points would leave it") {
  for (const std::string& text : {std::string(15, 'H'), std::string(18, 'H'), std::string(80, 'H')})
    for (const double x : {-14.0, -5.0, 0.0, 9.0})
      for (const double y : {-12.0, 0.0, 12.0}) {
        INFO(text << " at " << x << ", " << y);
        CHECK(inside(frame.grown(-3), place({x, y}, {1, 1}, text)));
      }
}

TEST_CASE_METHOD(Desk, "what lies outside of the frame has a name only where that is whole") {
  const std::size_t before = vertices_of(canvas).size();
  panel.label({100, 0}, {1, 0}, "far", style);
  CHECK(panel.place_labels() == 0);
  CHECK(vertices_of(canvas).size() == before);
}

TEST_CASE_METHOD(Desk, "labels without a free place are drawn all the same and counted, others are not") {
  panel.label({0, 0}, {1, 1}, "free", style);
  panel.label({-5, -5}, {1, 1}, "as well", style);
  CHECK(panel.place_labels() == 0);
  for (double y = -13; y <= 13; y += 0.5) panel.line({-15, y}, {15, y}, {.width = 3});
  panel.label({0, 0}, {1, 1}, "crowded", style);
  panel.label({-5, -5}, {1, 1}, "too", style);
  CHECK(panel.place_labels() == 2);
  CHECK(inside(frame, place({0, 0}, {1, 1}, "crowded")));
}

TEST_CASE("a label that finds no place gets the largest letters with which it finds one") {
  const auto placed = [](double smallest) {
    Desk desk;
    for (double y = -13; y <= 13; y += 2.6) desk.panel.line({-15, y}, {15, y}, {.width = 3});
    desk.panel.label({0, 0.1}, {1, 1}, "X", style);
    const std::size_t before = vertices_of(desk.canvas).size();
    const int crowded = desk.panel.place_labels(smallest);
    return std::pair(crowded, drawn_since(desk.canvas, before));
  };
  const auto [crowded, usual] = placed(1);
  const auto [crowded_small, small] = placed(0.4);
  const auto [crowded_tiny, tiny] = placed(0.2);
  CHECK(std::array{crowded, crowded_small, crowded_tiny} == std::array{1, 0, 0});
  CHECK((small.min == tiny.min && small.max == tiny.max));
  CHECK_FALSE((small.min == usual.min && small.max == usual.max));
}

TEST_CASE_METHOD(Desk, "an area too small for its name is named all the same") {
  const std::array<Vec2, 3> speck = {{{0, 0}, {0.1, 0}, {0, 0.1}}};
  const std::size_t before = vertices_of(canvas).size();
  panel.name_area(speck, "R3", style);
  panel.place_labels();
  REQUIRE(vertices_of(canvas).size() > before);
}

TEST_CASE_METHOD(Desk, "an area may go without its name where that finds no place, and none is missed then") {
  const std::array<Vec2, 3> triangle = {{{-2, -2}, {2, -2}, {0, 2}}};
  panel.keep_clear(frame);
  const std::size_t before = vertices_of(canvas).size();
  panel.name_area(triangle, "R3", style, {""});
  CHECK(panel.place_labels() == 0);
  CHECK(vertices_of(canvas).size() == before);
}

// ---------------------------------------------------------------------------------------------- hatching

namespace {

/// The middle line of a stroke, in page units.
struct Drawn {
  Vec2 from, to;
};

/// Returns: all lines, of 45 degrees. The first and third vertex of each are opposite corners.
std::vector<Drawn> lines_of(const Canvas& canvas) {
  std::vector<Drawn> lines;
  const auto list = vertices_of(canvas);
  for (std::size_t i = 0; i + 5 < list.size(); i += 6) {
    Vec2 middle = Vec2::Zero();
    for (const std::size_t corner : {0u, 2u}) middle += Vec2(list[i + corner].x, list[i + corner].y) / 2;
    const Vec2 along = Vec2(1, -1).normalized() * static_cast<double>(list[i].half_length);
    lines.push_back({middle - along, middle + along});
  }
  return lines;
}

std::vector<Drawn> hatched(std::span<const Vec2> corners, double spacing) {
  Desk desk;
  desk.panel.hatch(corners, spacing, {.width = 1});
  return lines_of(desk.canvas);
}

const std::array square = {Vec2(-5, -5), Vec2(5, -5), Vec2(5, 5), Vec2(-5, 5)};  // page (150,100)..(250,200)

}  // namespace

TEST_CASE("hatching stays inside the frame however large the area") {
  const std::array huge = {Vec2(-1e6, -1e6), Vec2(1e6, -1e6), Vec2(0, 1e6)};
  const auto lines = hatched(huge, 20);
  REQUIRE(lines.size() > 20);
  REQUIRE(lines.size() <= 29);  // 300 + 260 page units, 20 apart
  for (const Drawn& line : lines) {
    REQUIRE(inside(frame.grown(0.01), {line.from.cwiseMin(line.to), line.from.cwiseMax(line.to)}));
  }
}

TEST_CASE("nothing is hatched where there is no area, no distance, or no number") {
  const double nan = std::nan("");
  REQUIRE(hatched(std::array{Vec2(100, 100), Vec2(110, 100), Vec2(100, 110)}, 20).empty());
  REQUIRE(hatched(std::vector<Vec2>{}, 20).empty());
  for (const double spacing : {0.0, -4.0, 2.9, nan}) REQUIRE(hatched(square, spacing).empty());
  REQUIRE(hatched(std::array{Vec2(0, 0), Vec2(nan, 0), Vec2(0, 5)}, 20).empty());
}

}  // namespace panel_test
