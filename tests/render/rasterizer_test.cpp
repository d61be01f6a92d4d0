#include "render/rasterizer.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "render/gl.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

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

TEST_CASE_METHOD(Studio, "the background fills the picture") {
  Canvas empty({40, 30}, {10, 10}, palette::sky, font);
  const Image image = rasterizer.draw(empty);
  REQUIRE(image.size() == Size{40, 30});
  for (const auto& [x, y] : {std::pair{0, 0}, {39, 0}, {0, 29}, {39, 29}, {20, 15}}) {
    REQUIRE(image.pixel(x, y) == palette::sky);
  }
}

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

TEST_CASE_METHOD(Studio, "a polygon has its colour inside, half of it on an edge through pixel middles, none outside") {
  canvas.rectangle({{20, 10.5}, {60, 40}}, palette::blue);
  const Image image = draw();
  REQUIRE(image.pixel(40, 25) == palette::blue);
  REQUIRE(image.pixel(20, 39) == palette::blue);
  REQUIRE(image.pixel(59, 39) == palette::blue);
  REQUIRE(image.pixel(19, 25) == palette::white);
  REQUIRE(image.pixel(60, 25) == palette::white);
  REQUIRE(image.pixel(40, 9) == palette::white);
  REQUIRE(image.pixel(40, 40) == palette::white);
  REQUIRE(image.pixel(40, 10).r == Approx(127.5).margin(1));
  REQUIRE(image.pixel(40, 10).b == Approx((255 + 178) / 2.0).margin(1));
}

TEST_CASE_METHOD(Studio, "the top of the page is the top of the image") {
  canvas.rectangle({{0, 0}, {200, 20}}, palette::black);
  const Image image = draw();
  REQUIRE(image.pixel(100, 5) == palette::black);
  REQUIRE(image.pixel(100, 95) == palette::white);
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

TEST_CASE_METHOD(Studio, "alpha blends on the sRGB values") {
  canvas.rectangle({{0, 0}, {100, 100}}, palette::black);
  canvas.rectangle({{50, 0}, {150, 100}}, Color{255, 0, 0, 51});
  const Image image = draw();
  REQUIRE(image.pixel(75, 50) == Color{51, 0, 0});
  REQUIRE(image.pixel(125, 50) == Color{255, 204, 204});
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

TEST_CASE_METHOD(Studio, "joins are round, without notches") {
  canvas.polyline(std::array{Vec2(50, 80), Vec2(100, 20), Vec2(150, 80)}, {.color = palette::black, .width = 16});
  const Image image = draw();
  REQUIRE(darkness(image, 100, 13) == 1);
  REQUIRE(darkness(image, 100, 10) == 0);
  REQUIRE(darkness(image, 95, 14) == 1);
  REQUIRE(darkness(image, 104, 14) == 1);
}

TEST_CASE_METHOD(Studio, "dashes have gaps") {
  canvas.line({20, 50}, {180, 50}, {.color = palette::black, .width = 4, .dash = {12, 8}});
  const Image image = draw();
  // Dashes start at 18 (a cap before the line) and every 20 pixels, 12 long.
  for (const int start : {18, 38, 58, 138}) {
    REQUIRE(darkness(image, start + 6, 50) == 1);
    REQUIRE(darkness(image, start + 16, 50) == 0);
  }
}

TEST_CASE_METHOD(Studio, "discs and circles have their area") {
  canvas.disc({50, 50}, 20, palette::black);
  canvas.circle({140, 50}, 30, {.color = palette::black, .width = 6});
  const Image image = draw();
  REQUIRE(darkness(image, {{0, 0}, {100, 100}}) == Approx(3.14159 * 400).epsilon(0.002));
  REQUIRE(darkness(image, {{100, 0}, {200, 100}}) == Approx(2 * 3.14159 * 30 * 6).epsilon(0.002));
  REQUIRE(darkness(image, 140, 50) == 0);
  REQUIRE(darkness(image, 169, 50) == 1);
}

TEST_CASE_METHOD(Studio, "an arrow is pointed, ends at its tip, and is widest at the base of the head") {
  canvas.arrow({20, 50.5}, {150, 50.5}, {.color = palette::black, .width = 8});
  const Image image = draw();
  const auto column = [&](int x) { return darkness(image, {{static_cast<double>(x), 0}, {x + 1.0, 100}}); };
  REQUIRE(column(151) == 0);
  REQUIRE(column(149) > 0);
  REQUIRE(column(149) < 1.1);  // the shaft's cap does not stick out
  REQUIRE(column(140) == Approx(2 * 14.4 * (9.5 / 36)).margin(0.3));
  REQUIRE(column(116) == Approx(2 * 14.4 * (33.5 / 36)).margin(0.3));
  REQUIRE(column(100) == Approx(8).margin(0.01));
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

TEST_CASE_METHOD(Studio, "a halo surrounds the letters by two page units and leaves them as they are") {
  canvas.rectangle({{0, 0}, {200, 100}}, palette::black);
  canvas.text({100, 60}, "l", {.size = 40, .color = palette::black, .halo = palette::white});
  const Box ink = canvas.ink_box({100, 60}, "l", {.size = 40});
  const Image image = draw();
  const int y = static_cast<int>(ink.center().y()), left = static_cast<int>(ink.min.x());
  REQUIRE(darkness(image, left - 1, y) < 0.2);
  REQUIRE(darkness(image, left - 3, y) == 1);
  REQUIRE(darkness(image, static_cast<int>(ink.center().x()), y) == 1);
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

TEST_CASE_METHOD(Studio, "a picture of 4K is drawn") {
  Canvas large({3840, 2160}, {1280, 720}, palette::white, font);
  large.rectangle({{1270, 710}, {1280, 720}}, palette::blue);
  REQUIRE(rasterizer.draw(large).pixel(3839, 2159) == palette::blue);
}

TEST_CASE_METHOD(Studio, "what OpenGL finds wrong while it draws is told once, and not drawn over") {
  const GlLoader load{context};
  const PFNGLENABLEPROC enable = load("glEnable");
  enable(GL_TEXTURE_2D);  // which this profile of OpenGL does not know
  try {
    draw();
    FAIL("the error is not told");
  } catch (const ContextError& error) {
    CHECK_THAT(error.what(), kit::starts_with("OpenGL reports GL_INVALID_ENUM on drawing"));
  }
  CHECK_NOTHROW(draw());
}
