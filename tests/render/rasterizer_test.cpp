#include "render/rasterizer.hpp"

#include <GL/glcorearb.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

namespace rasterizer_test {

using namespace render;
using kit::darkness;

namespace {

constexpr Size size{200, 100};

struct Studio {
  Font font{Font::default_directory()};
  OffscreenContext context;
  Rasterizer rasterizer{context};
  Canvas canvas{size, size, palette::white, font};

  Image draw() { return rasterizer.draw(canvas); }
};

}  // namespace

TEST_CASE_METHOD(Studio, "rows of any number of bytes follow each other without a gap") {
  for (const int width : {33, 34, 35, 36}) {
    const Size narrow_size{width, 16};
    Canvas narrow(narrow_size, narrow_size, palette::sky, font);
    narrow.rectangle({{0, 0}, {1, 16}}, palette::black);
    const Image image = rasterizer.draw(narrow);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < width; ++x) CHECK(image.pixel(x, y) == (x == 0 ? palette::black : palette::sky));
  }
}

TEST_CASE_METHOD(Studio, "a polygon has no cracks between its cells") {
  std::vector<Vec2> corners;
  for (int i = 0; i < 23; ++i) corners.push_back(Vec2(100, 50) + 45 * Vec2(std::cos(i * 0.2731), std::sin(i * 0.2731)));
  canvas.polygon(corners, palette::black.with_alpha(128));
  const Image image = draw();
  const Color inside = image.pixel(100, 50);
  for (int y = 10; y < 90; ++y) {
    for (int x = 60; x < 140; ++x) {
      if (std::hypot(x + 0.5 - 100, y + 0.5 - 50) > 42) continue;
      REQUIRE(image.pixel(x, y) == inside);
    }
  }
}

TEST_CASE_METHOD(Studio, "lines have round caps and the asked width") {
  canvas.line({50, 50}, {150, 50}, {.color = palette::black, .width = 20});
  const Image image = draw();
  REQUIRE(darkness(image, 100, 40) == 1);
  REQUIRE(darkness(image, 100, 59) == 1);
  REQUIRE(darkness(image, 100, 39) == 0);
  REQUIRE(darkness(image, 100, 60) == 0);
  REQUIRE(darkness(image, 41, 50) == 1);  // the cap reaches 10 pixels beyond the end,
  REQUIRE(darkness(image, 38, 50) == 0);
  REQUIRE(darkness(image, 42, 42) == 0);  // but not into the corners
  REQUIRE(darkness(image, 157, 42) == 0);
  REQUIRE(darkness(image, {{0, 0}, {200, 100}}) == Approx(100 * 20 + 314.16).epsilon(0.002));
}

TEST_CASE_METHOD(Studio, "text is drawn where its ink box says, and nowhere else") {
  const TextStyle style{.size = 30, .color = palette::black, .align = Align::center};
  canvas.text({100, 60}, "a_1−b", style);
  const Box ink = canvas.ink_box({100, 60}, "a_1−b", style);
  const Image image = draw();
  const double inside = darkness(image, ink);
  REQUIRE(inside > 100);
  REQUIRE(darkness(image, {{0, 0}, {200, 100}}) == Approx(inside));
  for (const double x : {ink.min.x(), ink.max.x() - 1}) {  // the box is tight
    REQUIRE(darkness(image, {{x, ink.min.y()}, {x + 1, ink.max.y()}}) > 0);
  }
}

TEST_CASE_METHOD(Studio, "nothing is drawn outside the clip box until unclip") {
  canvas.clip({{50, 20}, {150, 80}});
  canvas.rectangle({{0, 0}, {200, 100}}, palette::blue);
  canvas.line({0, 0}, {200, 100}, {.width = 9});
  canvas.unclip();
  canvas.disc({10, 10}, 5, palette::green);
  const Image image = draw();
  REQUIRE(image.pixel(50, 79) == palette::blue);
  REQUIRE(image.pixel(149, 20) == palette::blue);
  REQUIRE(image.pixel(49, 50) == palette::white);
  REQUIRE(image.pixel(150, 50) == palette::white);
  REQUIRE(image.pixel(100, 19) == palette::white);
  REQUIRE(image.pixel(100, 80) == palette::white);
  REQUIRE(image.pixel(10, 10) == palette::green);
}

TEST_CASE_METHOD(Studio, "the same canvas gives the same image, whatever was drawn between") {
  canvas.text({20, 60}, "a_1 × b_{12}", {.size = 24, .halo = palette::white});
  const Image first = draw();
  for (const Size other_size : {Size{64, 48}, Size{400, 300}}) {
    Canvas other(other_size, other_size, palette::sky, font);
    other.text({20, 40}, "another", {.size = 30});
    REQUIRE(rasterizer.draw(other).size() == other_size);
    REQUIRE(draw() == first);
  }
}

TEST_CASE_METHOD(Studio, "sizes out of range are refused and leave the rasterizer usable") {
  for (const Size bad : {Size{max_pixels + 1, 100}, Size{100, max_pixels + 1}, Size{min_pixels - 1, 100}}) {
    const Canvas wrong(bad, {100, 100}, palette::white, font);
    REQUIRE_THROWS_AS(rasterizer.draw(wrong), ContextError);
  }
  REQUIRE(draw().pixel(0, 0) == palette::white);
}

TEST_CASE_METHOD(Studio, "what OpenGL finds wrong while it draws is told once, and not drawn over") {
  const auto enable = reinterpret_cast<PFNGLENABLEPROC>(context.function("glEnable"));
  enable(GL_TEXTURE_2D);  // which this profile of OpenGL does not know
  try {
    draw();
    FAIL("the error is not told");
  } catch (const ContextError& error) {
    CHECK_THAT(error.what(), kit::starts_with("OpenGL reports GL_INVALID_ENUM on drawing"));
  }
  CHECK_NOTHROW(draw());
}

}  // namespace rasterizer_test
