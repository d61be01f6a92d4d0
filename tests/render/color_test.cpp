#include "render/color.hpp"

#include <algorithm>
#include <cmath>

#include "tests/kit/catch.hpp"

using namespace render;

namespace {

/// The contrast ratio of WCAG 2: 1 for equal colours, 21 for black on white.
double contrast(Color one, Color other) {
  const auto linear = [](std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  const auto luminance = [&](Color c) { return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b); };
  const auto [darker, lighter] = std::minmax({luminance(one), luminance(other)});
  return (lighter + 0.05) / (darker + 0.05);
}

constexpr double any_text = 4.5, large_text_and_lines = 3;

}  // namespace

TEST_CASE("the palette is that of Okabe and Ito, channel by channel") {
  CHECK(palette::orange == Color{230, 159, 0});
  CHECK(palette::sky == Color{86, 180, 233});
  CHECK(palette::green == Color{0, 158, 115});
  CHECK(palette::blue == Color{0, 114, 178});
  CHECK(palette::vermillion == Color{213, 94, 0});
  CHECK(palette::black == Color{0, 0, 0});
}

// Golden pictures allow a channel to be a little off.
TEST_CASE("the colours of the themes for slides and on a dark ground, channel by channel") {
  CHECK(themes::slides.ink == palette::black);
  CHECK(themes::slides.grey == Color{80, 80, 80});
  CHECK(themes::slides.faint == Color{205, 205, 205});
  CHECK(themes::dark.paper == Color{22, 25, 31});
  CHECK(themes::dark.ink == Color{240, 240, 240});
  CHECK(themes::dark.grey == Color{170, 175, 182});
  CHECK(themes::dark.faint == Color{58, 63, 72});
  CHECK(themes::dark.blue == Color{98, 182, 240});
  CHECK(themes::dark.vermillion == Color{255, 138, 76});
  CHECK(themes::dark.green == Color{52, 205, 158});
  CHECK(themes::dark.orange == Color{240, 180, 60});
  CHECK(themes::dark.sky == Color{86, 180, 233});
}

TEST_CASE("what is written and drawn can be seen on the paper of every theme") {
  for (const auto& [theme, of_colors] : {std::pair{themes::report, large_text_and_lines},
                                         {themes::slides, large_text_and_lines},
                                         {themes::dark, any_text}}) {
    const auto on_paper = [&, paper = theme.paper](Color color) { return contrast(color, paper); };
    for (const Color color : {theme.ink, theme.grey, theme.blue}) CHECK(on_paper(color) >= any_text);
    for (const Color color : {theme.vermillion, theme.green}) CHECK(on_paper(color) >= of_colors);
    CHECK(on_paper(theme.faint) >= 1.3);
    CHECK(on_paper(theme.faint) < on_paper(theme.grey) / 2);  // grid lines stand back
  }
  for (const Color color : {themes::dark.orange, themes::dark.sky})  // which need no outline there
    CHECK(contrast(color, themes::dark.paper) >= large_text_and_lines);
}

TEST_CASE("the theme for slides has stronger lines and larger text than the one for reports") {
  CHECK(themes::slides.line > themes::report.line);
  CHECK(themes::slides.text > themes::report.text);
}
