#include "render/color.hpp"

#include <algorithm>
#include <cmath>

#include "tests/kit/catch.hpp"

namespace color_test {

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

}  // namespace color_test
