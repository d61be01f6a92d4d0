#include "render/canvas.hpp"

#include <array>
#include <cmath>

#include "tests/kit/catch.hpp"

namespace canvas_test {

using namespace render;

namespace {

struct Page {
  Font font{Font::default_directory()};
  Canvas canvas{{200, 100}, {200, 100}, palette::white, font};
};

template <class Kind>
const Kind& last_of(const Canvas& canvas) {
  return std::get<Kind>(canvas.shapes().back());
}

}  // namespace

TEST_CASE("a canvas keeps shapes in the order and in the units of its page, however few its pixels are") {
  Font font(Font::default_directory());
  Canvas canvas({20, 10}, {200, 100}, palette::white, font);
  canvas.polygon(std::array{Vec2(1, 2), Vec2(30, 4), Vec2(5, 60)}, palette::sky);
  CHECK(last_of<shape::Polygon>(canvas).corners[1] == Vec2(30, 4));
  canvas.line({7, 8}, {9, 10}, {.width = 30});
  CHECK(last_of<shape::Polyline>(canvas).corners[1] == Vec2(9, 10));
  CHECK(last_of<shape::Polyline>(canvas).stroke.width == 30);
  canvas.circle({50, 50}, 20, {});
  CHECK(last_of<shape::Ring>(canvas).radius == 20);
  canvas.text({11, 12}, "word", {.size = 13});
  CHECK(last_of<shape::Text>(canvas).text == "word");
  canvas.clip({{1, 1}, {2, 2}});
  CHECK(last_of<shape::Clip>(canvas).box.max == Vec2(2, 2));
  CHECK(canvas.shapes().size() == 6);  // with the whole page, to which it was clipped before
}

TEST_CASE("lines and discs are kept a pixel wide, and dashes too fine to be seen as a solid line") {
  Font font(Font::default_directory());
  Canvas canvas({20, 10}, {200, 100}, palette::white, font);
  canvas.line({7, 8}, {90, 10}, {.width = 2, .dash = {2, 2}});
  CHECK(last_of<shape::Polyline>(canvas).stroke.width == 10);
  CHECK(last_of<shape::Polyline>(canvas).stroke.dash.gap == 0);
  canvas.line({7, 8}, {90, 10}, {.width = 20, .dash = {3, 2}});
  CHECK(last_of<shape::Polyline>(canvas).stroke.dash.gap == 2);
  canvas.disc({7, 8}, 1, palette::ink);
  CHECK(last_of<shape::Disc>(canvas).radius == 5);
}

TEST_CASE_METHOD(Page, "a dashed circle is an outline of many corners, so that whole dashes fit around") {
  canvas.circle({50, 50}, 20, {.dash = {6, 4}});
  const shape::Polyline& around = last_of<shape::Polyline>(canvas);
  for (const Vec2& corner : around.corners) CHECK((corner - Vec2(50, 50)).norm() == Approx(20));
  CHECK(around.corners.front() == around.corners.back());
  CHECK(around.stroke.dash.length / around.stroke.dash.gap == Approx(1.5));
}

TEST_CASE_METHOD(Page, "text boxes: alignment, and letters inside the box of the line") {
  TextStyle style{.size = 20};
  const Box left = canvas.text_box({100, 50}, "Hxg", style);
  style.align = Align::right;
  const Box right = canvas.text_box({100, 50}, "Hxg", style);
  style.align = Align::center;
  const Box center = canvas.text_box({100, 50}, "Hxg", style);
  REQUIRE(left.min.x() == 100);
  REQUIRE(right.max.x() == Approx(100).margin(0.5));
  REQUIRE(center.center().x() == Approx(100).margin(0.5));

  const Box ink = canvas.ink_box({100, 50}, "Hxg", style);
  REQUIRE(ink.width() > 20);
  REQUIRE(ink.min.y() > center.min.y());
  REQUIRE(ink.max.y() < center.max.y() + 1);
  REQUIRE(50 - ink.min.y() == Approx(canvas.cap_height(style)).margin(1));
  REQUIRE(ink.max.y() > 53);  // the g reaches below the baseline
  REQUIRE(canvas.ink_box({100, 50}, " ", style).width() == 0);
}

}  // namespace canvas_test
