#include "render/triangles.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

namespace triangles_test {

using namespace render;
using kit::vertices_of;
using Kind = CanvasVertex::Kind;

namespace {

struct Page {
  Font font{Font::default_directory()};
  Canvas canvas{{200, 100}, {200, 100}, palette::white, font};
};

/// The two ends of a capsule's middle line, from the first corner of its quad: centre - along * (half + reach) - ...
struct Ends {
  Vec2 from, to;
};

Ends ends_of(const CanvasVertex& a, const CanvasVertex& b, const CanvasVertex& c) {
  const Vec2 corner(a.x, a.y), along = (Vec2(b.x, b.y) - corner).normalized();
  const Vec2 center = (corner + Vec2(c.x, c.y)) / 2;
  return {center - along * a.half_length, center + along * a.half_length};
}

std::vector<Ends> capsules_of(const Canvas& canvas) {
  std::vector<Ends> all;
  const auto list = vertices_of(canvas);
  for (std::size_t i = 0; i + 5 < list.size(); i += 6) {
    if (list[i].kind == Kind::capsule) all.push_back(ends_of(list[i], list[i + 1], list[i + 2]));
  }
  return all;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("no line is thinner than a pixel") {
  Font font(Font::default_directory());
  Canvas canvas({20, 20}, {200, 200}, palette::white, font);
  canvas.line({20, 30}, {80, 30}, {.width = 2});
  REQUIRE(vertices_of(canvas)[0].radius == 0.5f);
}

TEST_CASE("every dash of a line is drawn once, wherever the line begins and ends") {
  constexpr double period = 12, straight = 8 - 2;  // of a line 2 wide, whose caps belong to the dash
  for (int begin = 1; begin < 14; ++begin) {
    for (int length = 1; length < 40; length += 3) {
      Page page;
      const std::array corners = {Vec2(20, 30), Vec2(20 + begin, 30), Vec2(20 + begin + length, 30)};
      page.canvas.polyline(corners, {.width = 2, .dash = {8, 4}});
      std::vector<Vec2> expected;  // from and to, along the line
      for (const auto& [first, last] : {std::pair(0, begin), std::pair(begin, begin + length)})
        for (int i = 0; i < 10; ++i)
          if (const double from = std::max<double>(i * period, first),
              to = std::min<double>(i * period + straight, last);
              from <= to)
            expected.emplace_back(20 + from, 20 + to);
      INFO("a line of " << begin << " and on for " << length);
      const std::vector<Ends> dashes = capsules_of(page.canvas);
      REQUIRE(dashes.size() == expected.size());
      for (std::size_t i = 0; i < dashes.size(); ++i) {
        REQUIRE(dashes[i].from.x() == Approx(expected[i].x()).margin(1e-4));
        REQUIRE(dashes[i].to.x() == Approx(expected[i].y()).margin(1e-4));
      }
    }
  }
}

TEST_CASE_METHOD(Page, "around an outline fits a whole number of dashes") {
  const std::array corners = {Vec2(20, 20), Vec2(60, 20), Vec2(60, 60), Vec2(20, 60)};  // 160 around, 10.67 periods
  canvas.outline(corners, {.width = 1, .dash = {10, 5}});
  const auto capsules = capsules_of(canvas);
  REQUIRE(capsules.back().to.y() == Approx(20 + 160.0 / 11 / 3 + 1));  // a gap and two caps before the start
}

TEST_CASE_METHOD(Page, "dashes finer than half a pixel are a solid line") {
  canvas.line({20, 30}, {80, 30}, {.width = 2, .dash = {0.2, 0.2}});
  REQUIRE(capsules_of(canvas).size() == 1);
}

TEST_CASE_METHOD(Page, "a far-reaching dashed line costs no more than its visible part, and keeps its phase") {
  canvas.line({-12e8, 30}, {12e8, 30}, {.width = 2, .dash = {8, 4}});
  const auto capsules = capsules_of(canvas);
  REQUIRE(capsules.size() >= 200 / 12);
  REQUIRE(capsules.size() <= 200 / 12 + 4);
  for (const Ends& dash : capsules) {
    if (dash.from.x() < 0 || dash.to.x() > 200) continue;
    REQUIRE(std::remainder(dash.from.x(), 12) == Approx(0).margin(1e-3));
  }
}

TEST_CASE_METHOD(Page, "what is not finite is not drawn") {
  for (const double bad : {not_a_number, infinity, -infinity}) {
    const Vec2 p(bad, 10);
    canvas.line({0, 0}, p, {});
    canvas.line({0, 0}, {9, 9}, {.width = std::abs(bad)});
    canvas.arrow(p, {5, 5}, {});
    canvas.disc(p, 3, palette::ink);
    canvas.disc({5, 5}, infinity, palette::ink);
    canvas.circle(p, 3, {});
    canvas.circle({5, 5}, bad, {});
    canvas.circle({5, 5}, bad, {.dash = {3, 3}});
    canvas.polygon(std::array{p, Vec2(1, 1), Vec2(20, 2)}, palette::ink);
    canvas.text(p, "text", {});
  }
  REQUIRE(vertices_of(canvas).empty());
}

TEST_CASE_METHOD(Page, "what lies outside the clip box adds no triangles") {
  canvas.clip({{50, 20}, {150, 80}});
  canvas.line({0, 0}, {200, 10}, {});
  canvas.rectangle({{0, 0}, {40, 100}}, palette::ink);
  REQUIRE(vertices_of(canvas).empty());
  canvas.unclip();
  canvas.line({0, 0}, {200, 10}, {});
  REQUIRE(vertices_of(canvas).size() == 6);
}

TEST_CASE("what is drawn reaches into the clip box with its width and its fading edge, and is left out farther away") {
  constexpr double half = 10;
  const Box clip{{50, 20}, {150, 80}};
  for (const double away : {-0.6, 0.9, 1.1, 1.6}) {  // from the edge of what is drawn to the clip box; it fades over 1
    for (const Box& box : {Box{{60, 5}, {140, 20 - away}}, Box{{60, 80 + away}, {140, 95}},
                           Box{{5, 30}, {50 - away, 70}}, Box{{150 + away, 30}, {195, 70}}}) {
      Page lines, rectangles;
      lines.canvas.clip(clip);
      rectangles.canvas.clip(clip);
      // Along the side of the rectangle that is nearest to the clip box.
      const Vec2 from = clip.center().cwiseMax(box.min).cwiseMin(box.max), out = from - clip.center();
      const Vec2 middle = from + out.normalized() * half, along(out.y() == 0 ? 0 : 40, out.y() == 0 ? 20 : 0);
      lines.canvas.line(middle - along, middle + along, {.width = 2 * half});
      rectangles.canvas.rectangle(box, palette::ink);
      INFO(away << " beside the clip box, from " << box.min.transpose());
      REQUIRE(vertices_of(lines.canvas).empty() == (away > 1));
      if (away < 0.5 || away > 1.5) REQUIRE(vertices_of(rectangles.canvas).empty() == (away > 1.5));
    }
  }
}

TEST_CASE_METHOD(Page, "an arrow without length is nothing, a short one shrinks as a whole") {
  canvas.arrow({10, 10}, {10, 10}, {});
  REQUIRE(vertices_of(canvas).empty());
  canvas.arrow({10, 10}, {16, 10}, {.width = 2});  // half of the 12 units that a whole one needs
  const auto capsules = capsules_of(canvas);
  REQUIRE(capsules.size() == 1);
  REQUIRE(vertices_of(canvas)[0].radius == 0.5f);
  REQUIRE(capsules[0].to.x() == Approx(16 - 4.5 + 0.5));  // inside the head
}

TEST_CASE("letters stand on whole pixels, the nearest to the place that was asked for") {
  const auto first_corner = [](double x, double y) {
    Page page;
    page.canvas.text({x, y}, "H", {.size = 20});
    return Vec2(vertices_of(page.canvas)[0].x, vertices_of(page.canvas)[0].y);
  };
  const Vec2 there = first_corner(40, 50);
  for (const double off : {-0.49, -0.2, 0.2, 0.49}) {
    REQUIRE(first_corner(40 + off, 50) == there);
    REQUIRE(first_corner(40, 50 + off) == there);
  }
  for (const double off : {-0.51, 0.51}) {
    REQUIRE(first_corner(40 + off, 50) == there + Vec2(std::copysign(1, off), 0));
    REQUIRE(first_corner(40, 50 + off) == there + Vec2(0, std::copysign(1, off)));
  }
}

}  // namespace triangles_test
