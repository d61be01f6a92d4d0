#include "render/svg_text.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"

namespace svg_text_test {

using namespace render;

namespace {

std::string svg_of(const std::function<void(Canvas&)>& draw) {
  static Font font(Font::default_directory());
  Canvas canvas({100, 50}, {100, 50}, palette::white, font);
  draw(canvas);
  return svg_text(canvas, {{0, 0}, {100, 50}});
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("Each shape is an element, places to a hundredth") {
  const std::string svg = svg_of([](Canvas& canvas) {
    canvas.polygon(std::array<Vec2, 3>{Vec2(0, 0), Vec2(1.234, -5.5), Vec2(10, 20.009)}, {1, 2, 3, 4});
    canvas.line({1, 2}, {3, 4}, {.color = palette::black, .width = 2, .dash = {5, 6}});
    canvas.disc({7, 8}, 1.5, palette::black);
    canvas.circle({9, 10}, 4, {.color = palette::black, .width = 2});
  });
  CHECK(has(svg, "<path d='M0 0L1.23 -5.5L10 20.01Z' fill='#01020304'/>"));
  CHECK(has(svg, "<path d='M1 2L3 4' stroke='#000000' stroke-width='2' stroke-dasharray='3 8'/>"));
  CHECK(has(svg, "<circle cx='7' cy='8' r='1.5' fill='#000000'/>"));
  CHECK(has(svg, "<circle cx='9' cy='10' r='4' stroke='#000000' stroke-width='2'/>"));
}

TEST_CASE("Letters are text as wide as the font has them, subscripts apart, and nothing in them is read as SVG") {
  const std::string svg = svg_of([](Canvas& canvas) {
    canvas.text({10, 20}, "AB_n <i>&", {.size = 10, .halo = palette::white});
  });
  CHECK(has(svg, ">AB</text>"));
  CHECK(has(svg, "font-size='7'"));
  CHECK(has(svg, ">n</text>"));
  CHECK(has(svg, "&lt;i&gt;&amp;</text>"));
  CHECK(has(svg, "textLength="));
  CHECK(has(svg, "stroke='#ffffff' stroke-width='4'"));
}

TEST_CASE("What is clipped lies in an element of its own, which ends with the picture or the next") {
  const std::string svg = svg_of([](Canvas& canvas) {
    canvas.clip({{10, 5}, {40, 30}});
    canvas.disc({7, 8}, 1.5, palette::black);
    canvas.unclip();
  });
  CHECK(has(svg, "<svg x='10' y='5' width='30' height='25' viewBox='10 5 30 25'><circle"));
  const auto count = [&](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++found;
    return found;
  };
  CHECK(count("<svg ") == count("</svg>"));
}

}  // namespace svg_text_test
