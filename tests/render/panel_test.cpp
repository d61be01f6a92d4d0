#include "render/panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"

using namespace render;

namespace {

constexpr Size size{400, 300};
const Box frame{{50, 20}, {350, 280}};
const TextStyle style{.size = 20};

/// A panel whose scene units are tenths of page units around the middle of the frame, (200,150).
struct Desk {
  Font font{Font::default_directory()};
  Canvas canvas{size, size, palette::white, font};
  View view = View::fit({-15, -13}, {15, 13}, frame, 10);
};

/// The box around the vertices from `first` on: what the labels drew, when nothing came after them.
Box drawn_since(const Canvas& canvas, std::size_t first) {
  const auto list = canvas.vertices();
  REQUIRE(list.size() > first);
  Box box{Vec2(list[first].x, list[first].y), Vec2(list[first].x, list[first].y)};
  for (std::size_t i = first; i < list.size(); ++i) {
    box.min = box.min.cwiseMin(Vec2(list[i].x, list[i].y));
    box.max = box.max.cwiseMax(Vec2(list[i].x, list[i].y));
  }
  return box;
}

/// Places one label and returns its box.
Box place_one(Desk& desk, Panel& panel, const Vec2& anchor, const Vec2& toward, const std::string& text) {
  const std::size_t before = desk.canvas.vertices().size();
  panel.label(anchor, toward, text, style);
  panel.place_labels();
  return drawn_since(desk.canvas, before);
}

bool inside(const Box& outer, const Box& inner) {
  return outer.min.x() <= inner.min.x() && outer.min.y() <= inner.min.y() && inner.max.x() <= outer.max.x() &&
         inner.max.y() <= outer.max.y();
}

}  // namespace

TEST_CASE("a view turns y over, and back") {
  const View view = View::fit({-2, -1}, {2, 1}, {{100, 100}, {300, 300}}, 1000);
  REQUIRE(view.scale() == 50);  // the width decides
  REQUIRE(view.page({0, 0}) == Vec2(200, 200));
  REQUIRE(view.page({2, 1}) == Vec2(300, 150));
  REQUIRE(view.page({0, -1}).y() > view.page({0, 1}).y());
  for (const Vec2& p : {Vec2(0.3, -0.7), Vec2(-5, 2)}) REQUIRE(view.scene(view.page(p)).isApprox(p));
}

TEST_CASE("a view's scale: the tighter side decides, up to the limit, also for boxes without size") {
  const Box page{{0, 0}, {100, 200}};
  REQUIRE(View::fit({0, 0}, {10, 100}, page, 1000).scale() == 2);
  REQUIRE(View::fit({0, 0}, {10, 1}, page, 1000).scale() == 10);
  REQUIRE(View::fit({0, 0}, {10, 1}, page, 4).scale() == 4);
  REQUIRE(View::fit({3, 3}, {3, 3}, page, 40).scale() == 40);
  REQUIRE(View::fit({3, 3}, {3, 3}, page, 40).page({3, 3}) == page.center());
  REQUIRE(View::fit({3, 0}, {3, 100}, page, 40).scale() == 2);
}

TEST_CASE("a panel clips to its frame while it lives") {
  Desk desk;
  {
    Panel panel(desk.canvas, frame, desk.view);
    panel.line({-100, 0}, {100, 0}, {});
  }
  desk.canvas.disc({5, 5}, 2, palette::ink);
  const auto runs = desk.canvas.runs();
  REQUIRE(runs.size() == 2);
  REQUIRE(runs[0].left == 50);
  REQUIRE(runs[0].bottom == 280);
  REQUIRE(runs[1].left == 0);
  REQUIRE(runs[1].bottom == 300);
}

TEST_CASE("the corners of a panel are those of its frame") {
  Desk desk;
  const Panel panel(desk.canvas, frame, desk.view);
  const auto corners = panel.corners();
  REQUIRE(corners.size() == 4);
  for (const Vec2& corner : corners) {
    const Vec2 page = desk.view.page(corner);
    REQUIRE((page.x() == Approx(50) || page.x() == Approx(350)));
    REQUIRE((page.y() == Approx(20) || page.y() == Approx(280)));
  }
}

TEST_CASE("a grid has a line at every multiple of its step, unless they would run together") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  panel.grid(5, {.width = 1});
  REQUIRE(desk.canvas.vertices().size() == 6 * (7 + 5));  // x: -15..15, y: -10..10
  panel.grid(0.01, {.width = 1});
  panel.grid(0, {.width = 1});
  panel.grid(-1, {.width = 1});
  REQUIRE(desk.canvas.vertices().size() == 6 * (7 + 5));
}

TEST_CASE("a grid may go through any point, also one far away") {
  Desk desk, moved;
  {
    Panel panel(desk.canvas, frame, desk.view);
    panel.grid(5, {.width = 1});
  }
  Panel panel(moved.canvas, frame, moved.view);
  panel.grid(5, {.width = 1}, {5e6 + 1, -2.5e6});
  REQUIRE(moved.canvas.vertices().size() == 6 * (6 + 5));  // x: -14..11
  REQUIRE(moved.canvas.vertices()[0].x == Approx(desk.canvas.vertices()[0].x + moved.view.scale()));
}

TEST_CASE("a label stands where it was asked to, beside its anchor") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  panel.disc({0, 0}, 4, palette::ink);
  const Vec2 anchor = desk.view.page({0, 0});
  REQUIRE(place_one(desk, panel, {0, 0}, {3, 0}, "abc").min.x() > anchor.x() + 4);
  REQUIRE(place_one(desk, panel, {0, 0}, {-3, 0}, "abc").max.x() < anchor.x() - 4);
  REQUIRE(place_one(desk, panel, {0, 0}, {0, 3}, "abc").max.y() < anchor.y() - 4);   // up in the scene
  REQUIRE(place_one(desk, panel, {0, 0}, {0, -3}, "abc").min.y() > anchor.y() + 4);  // down
  const Box anywhere = place_one(desk, panel, {0, 0}, {0, 0}, "abc");
  REQUIRE(anywhere.center().x() > anchor.x());
  REQUIRE(anywhere.max.y() < anchor.y() - 4);
}

TEST_CASE("capitals are centred on the height of their anchor") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  for (const char* text : {"H", "H_1"}) {
    const std::size_t before = desk.canvas.vertices().size();
    place_one(desk, panel, {0, 0}, {1, 0}, text);
    const auto list = desk.canvas.vertices().subspan(before, 6);  // the H
    REQUIRE((list[0].y + list[2].y) / 2 == Approx(desk.view.page({0, 0}).y()).margin(1));
  }
}

TEST_CASE("labels keep off lines, arrows, rings and discs") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  // The whole upper right is crossed: a label that wants to go there has to turn.
  panel.line({0, 0}, {8, 8}, {.width = 3});
  panel.arrow({0, 0}, {8, 3}, {.width = 3});
  panel.circle({1, 3}, 8, {.width = 2});
  panel.disc({-4, 4}, 20, palette::ink);
  const Box box = place_one(desk, panel, {0, 0}, {1, 1}, "A_1");
  const auto crossed = [&](const Vec2& from, const Vec2& to, double radius) {
    return clip_segment(desk.view.page(from), desk.view.page(to), box.grown(radius)).has_value();
  };
  REQUIRE_FALSE(crossed({0, 0}, {8, 8}, 1.5));
  REQUIRE_FALSE(crossed({0, 0}, {8, 3}, 1.5));
  REQUIRE_FALSE(crossed({1, 3}, {1, 3}, 9));
  REQUIRE_FALSE(crossed({-4, 4}, {-4, 4}, 20));
}

std::vector<CanvasVertex> letters(std::span<const CanvasVertex> all) {
  std::vector<CanvasVertex> found;
  std::ranges::copy_if(all, std::back_inserter(found),
                       [](const CanvasVertex& v) { return v.kind == CanvasVertex::Kind::glyph; });
  return found;
}

TEST_CASE("a label that finds no place near its anchor is tied to it by a line, others are not") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  const auto lines_of_a_label = [&] {
    panel.label({0, 0}, {1, 0}, "name", style);
    const std::size_t before = desk.canvas.vertices().size();
    panel.place_labels();
    const auto list = desk.canvas.vertices().subspan(before);
    return list.size() - letters(list).size();
  };
  REQUIRE(lines_of_a_label() == 0);
  panel.disc({0, 0}, 40, palette::blue);
  REQUIRE(lines_of_a_label() == 6);
  const CanvasVertex last = desk.canvas.vertices()[desk.canvas.vertices().size() - 4 * 6 - 1];
  const Vec2 anchor = desk.view.page({0, 0});
  REQUIRE((Vec2(last.x, last.y) - anchor).norm() < 60);
}

TEST_CASE("labels keep off each other, first come first served") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  std::vector<Box> boxes;
  const Box alone = place_one(desk, panel, {0, 0}, {1, 0}, "name");
  for (int i = 0; i < 4; ++i) panel.label({0, 0}, {1, 0}, "name", style);
  const std::size_t before = desk.canvas.vertices().size();
  panel.place_labels();
  const std::vector<CanvasVertex> list = letters(desk.canvas.vertices().subspan(before));
  REQUIRE(list.size() == 4 * 4 * 6);
  for (std::size_t label = 0; label < 4; ++label) {
    Box box{Vec2(1e9, 1e9), Vec2(-1e9, -1e9)};
    for (const CanvasVertex& vertex : std::span(list).subspan(label * 4 * 6, 4 * 6)) {
      box.min = box.min.cwiseMin(Vec2(vertex.x, vertex.y));
      box.max = box.max.cwiseMax(Vec2(vertex.x, vertex.y));
    }
    for (const Box& other : boxes) REQUIRE_FALSE(box.overlaps(other));
    boxes.push_back(box);
  }
  REQUIRE(boxes[0].min == alone.min);
}

TEST_CASE("labels stay inside the frame") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  for (const Vec2& corner : panel.corners()) {
    const Box box = place_one(desk, panel, 0.99 * corner, corner, "outward");
    REQUIRE(inside(frame.grown(-3), box));
  }
}

TEST_CASE("a label without a free place is drawn all the same") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  for (double y = -13; y <= 13; y += 0.5) panel.line({-15, y}, {15, y}, {.width = 1});
  REQUIRE(inside(frame, place_one(desk, panel, {0, 0}, {1, 1}, "crowded")));
}

TEST_CASE("labels without a free place are counted, others are not") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  panel.label({0, 0}, {1, 1}, "free", style);
  panel.label({-5, -5}, {1, 1}, "as well", style);
  CHECK(panel.place_labels() == 0);
  for (double y = -13; y <= 13; y += 0.5) panel.line({-15, y}, {15, y}, {.width = 3});
  panel.label({0, 0}, {1, 1}, "crowded", style);
  panel.label({-5, -5}, {1, 1}, "too", style);
  CHECK(panel.place_labels() == 2);
}

TEST_CASE("a label that finds no place gets the largest letters with which it finds one") {
  const auto placed = [](double smallest) {
    Desk desk;
    Panel panel(desk.canvas, frame, desk.view);
    for (double y = -13; y <= 13; y += 2.6) panel.line({-15, y}, {15, y}, {.width = 3});
    panel.label({0, 0.1}, {1, 1}, "X", style);
    const std::size_t before = desk.canvas.vertices().size();
    const int crowded = panel.place_labels(smallest);
    return std::pair(crowded, drawn_since(desk.canvas, before));
  };
  const auto [crowded, usual] = placed(1);
  const auto [crowded_small, small] = placed(0.4);
  const auto [crowded_tiny, tiny] = placed(0.2);
  CHECK(crowded == 1);
  CHECK(crowded_small == 0);
  CHECK(crowded_tiny == 0);
  CHECK((small.min == tiny.min && small.max == tiny.max));
  CHECK_FALSE((small.min == usual.min && small.max == usual.max));
}

TEST_CASE("no label stands where none is to stand") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  const Box usual = place_one(desk, panel, {0, 0}, {1, 0}, "name");
  panel.keep_clear(usual);
  CHECK_FALSE(place_one(desk, panel, {0, 0}, {1, 0}, "name").overlaps(usual.grown(-2)));
}

TEST_CASE("fills and grids are no obstacles") {
  Desk desk;
  Panel plain(desk.canvas, frame, desk.view);
  const Box alone = place_one(desk, plain, {0, 0}, {1, 1}, "A");
  Panel panel(desk.canvas, frame, desk.view);
  panel.polygon(std::array{Vec2(-9, -9), Vec2(9, -9), Vec2(0, 9)}, palette::sky);
  panel.grid(1, {});
  REQUIRE(place_one(desk, panel, {0, 0}, {1, 1}, "A").min == alone.min);
}

TEST_CASE("the name of an area stands inside it, clear of lines and of the names of points") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  const std::array<Vec2, 3> triangle = {{{-12, -10}, {12, -10}, {0, 10}}};
  const Vec2 middle(0, -10.0 / 3);
  panel.line(middle - Vec2(12, 0), middle + Vec2(12, 0), {});
  const std::size_t before = desk.canvas.vertices().size();
  panel.name_area(triangle, "R3", style);
  panel.place_labels();
  const Box box = drawn_since(desk.canvas, before);
  for (const Vec2& corner : {box.min, box.max, Vec2(box.min.x(), box.max.y()), Vec2(box.max.x(), box.min.y())}) {
    const Vec2 p = desk.view.scene(corner);
    REQUIRE(p.y() > -10);
    REQUIRE(std::abs(p.x()) < 12 * (10 - p.y()) / 20);
  }
  const double line = desk.view.page(middle).y();
  REQUIRE((box.max.y() < line - 10 || box.min.y() > line + 10));
}

TEST_CASE("an area too small for its name is named all the same") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  const std::array<Vec2, 3> speck = {{{0, 0}, {0.1, 0}, {0, 0.1}}};
  const std::size_t before = desk.canvas.vertices().size();
  panel.name_area(speck, "R3", style);
  panel.place_labels();
  REQUIRE(desk.canvas.vertices().size() > before);
}

TEST_CASE("an area may go without its name where that finds no place, and none is missed then") {
  Desk desk;
  Panel panel(desk.canvas, frame, desk.view);
  const std::array<Vec2, 3> triangle = {{{-2, -2}, {2, -2}, {0, 2}}};
  panel.keep_clear(frame);
  const std::size_t before = desk.canvas.vertices().size();
  panel.name_area(triangle, "R3", style, {""});
  CHECK(panel.place_labels() == 0);
  CHECK(desk.canvas.vertices().size() == before);
}

// ---------------------------------------------------------------------------------------------- hatching

namespace {

/// The middle line of a stroke, in page units.
struct Drawn {
  Vec2 from, to;
};

/// Returns: the lines drawn since, all of them at 45 degrees. The first and third vertex of each are opposite corners.
std::vector<Drawn> lines_since(const Canvas& canvas, std::size_t first) {
  std::vector<Drawn> lines;
  const auto list = canvas.vertices();
  for (std::size_t i = first; i + 5 < list.size(); i += 6) {
    Vec2 middle = Vec2::Zero();
    for (const std::size_t corner : {0u, 2u}) middle += Vec2(list[i + corner].x, list[i + corner].y) / 2;
    const Vec2 along = Vec2(1, -1).normalized() * static_cast<double>(list[i].half_length);
    lines.push_back({middle - along, middle + along});
  }
  return lines;
}

const Stroke fine{.width = 1};

std::vector<Drawn> hatched(Desk& desk, std::span<const Vec2> corners, double spacing) {
  const std::size_t before = desk.canvas.vertices().size();
  Panel panel(desk.canvas, frame, desk.view);
  panel.hatch(corners, spacing, fine);
  return lines_since(desk.canvas, before);
}

const std::array square = {Vec2(-5, -5), Vec2(5, -5), Vec2(5, 5), Vec2(-5, 5)};  // page (150,100)..(250,200)

}  // namespace

TEST_CASE("hatching is made of parallel lines at the asked distance, from border to border") {
  Desk desk;
  const std::vector<Drawn> lines = hatched(desk, square, 20);
  REQUIRE(lines.size() == 10);  // x + y is 260, 280, ..., 440
  for (const Drawn& line : lines) {
    REQUIRE(line.from.sum() == Approx(line.to.sum()).margin(1e-3));
    for (const Vec2& end : {line.from, line.to}) {
      const double aside = (end - Vec2(200, 150)).cwiseAbs().maxCoeff();
      REQUIRE(aside == Approx(50).margin(1e-3));
    }
  }
  for (std::size_t i = 1; i < lines.size(); ++i)
    REQUIRE(lines[i].from.sum() - lines[i - 1].from.sum() == Approx(20).margin(1e-3));
}

TEST_CASE("hatching runs on from one area into the next, whichever way round their corners are") {
  Desk desk;
  const std::array left = {Vec2(-5, -5), Vec2(1, -5), Vec2(1, 5), Vec2(-5, 5)};
  const std::array right = {Vec2(1, 5), Vec2(5, 5), Vec2(5, -5), Vec2(1, -5)};
  const auto whole = hatched(desk, square, 20), first = hatched(desk, left, 20), second = hatched(desk, right, 20);
  const auto levels = [](const std::vector<Drawn>& lines) {
    std::vector<long> sums;
    for (const Drawn& line : lines) sums.push_back(std::lround(line.from.sum()));
    return sums;
  };
  const auto all = levels(whole);
  for (const auto& part : {levels(first), levels(second)})
    for (const long level : part) REQUIRE(std::ranges::count(all, level) == 1);
  const auto length = [](const std::vector<Drawn>& lines) {
    double sum = 0;
    for (const Drawn& line : lines) sum += (line.to - line.from).norm();
    return sum;
  };
  REQUIRE(length(first) + length(second) == Approx(length(whole)).margin(0.01));
}

TEST_CASE("hatching stays inside the frame however large the area") {
  Desk desk;
  const std::array huge = {Vec2(-1e6, -1e6), Vec2(1e6, -1e6), Vec2(0, 1e6)};
  const auto lines = hatched(desk, huge, 20);
  REQUIRE(lines.size() > 20);
  REQUIRE(lines.size() <= 29);  // 300 + 260 page units, 20 apart
  for (const Drawn& line : lines) {
    REQUIRE(inside(frame.grown(0.01), {line.from.cwiseMin(line.to), line.from.cwiseMax(line.to)}));
  }
}

TEST_CASE("nothing is hatched where there is no area, no distance, or no number") {
  Desk desk;
  const double nan = std::nan("");
  REQUIRE(hatched(desk, std::array{Vec2(100, 100), Vec2(110, 100), Vec2(100, 110)}, 20).empty());
  REQUIRE(hatched(desk, std::vector<Vec2>{}, 20).empty());
  for (const double spacing : {0.0, -4.0, 2.9, nan}) REQUIRE(hatched(desk, square, spacing).empty());
  REQUIRE(hatched(desk, std::array{Vec2(0, 0), Vec2(nan, 0), Vec2(0, 5)}, 20).empty());
}

TEST_CASE("hatching is no obstacle for labels") {
  Desk desk;
  Panel plain(desk.canvas, frame, desk.view);
  const Box alone = place_one(desk, plain, {0, 0}, {1, 1}, "A");
  Panel panel(desk.canvas, frame, desk.view);
  panel.hatch(square, 5, fine);
  REQUIRE(place_one(desk, panel, {0, 0}, {1, 1}, "A").min == alone.min);
}
