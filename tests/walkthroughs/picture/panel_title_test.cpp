// The key of a panel: both objects are told apart, however long their names are.

#include "walkthroughs/picture/panel_title.hpp"

#include <algorithm>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

namespace panel_title_test {

using namespace walkthroughs::program;
using render::Vec2;

namespace {

const render::Box frame{{40, 10}, {340, 200}};

/// What was drawn of a key: the places of its signs, and its letters.
struct Drawn {
  std::vector<Vec2> signs;
  double left = 1e9, right = 0;  // of all letters
  double below = 0;              // where the room for the picture begins
  std::vector<double> heights;   // of each letter
};

Drawn drawn(const std::vector<std::string>& texts, bool may_be_shortened, const std::string& title = "",
            const render::Theme& theme = render::themes::report) {
  render::Font font(render::Font::default_directory());
  render::Canvas canvas({400, 220}, {400, 220}, render::palette::white, font);
  Drawn result;
  std::vector<KeyEntry> key;
  for (const std::string& text : texts)
    key.push_back({text, [&](render::Canvas&, const Vec2& at) { result.signs.push_back(at); }, 15, may_be_shortened});
  result.below = draw_panel_title(canvas, frame, title, Style(theme), key).min.y();
  double top = 0;
  int corner = 0;
  for (const render::CanvasVertex& vertex : kit::vertices_of(canvas)) {
    if (vertex.kind != render::CanvasVertex::Kind::glyph) continue;
    result.left = std::min(result.left, static_cast<double>(vertex.x));
    result.right = std::max(result.right, static_cast<double>(vertex.x));
    if (corner % 6 == 0) top = vertex.y;
    if (corner++ % 6 == 2) result.heights.push_back(vertex.y - top);
  }
  return result;
}

}  // namespace

TEST_CASE("Both signs stand in the key however long the names are, with letters of one size inside the panel") {
  for (const std::string& other : {std::string("B"), std::string(25, 'B'), std::string(40, 'M')}) {
    INFO(other);
    const Drawn key = drawn({std::string(40, 'H'), other}, true);
    REQUIRE(key.signs.size() == 2);
    CHECK(key.left >= frame.min.x());
    CHECK(key.right <= frame.max.x());
    CHECK(key.heights.size() > 6);
    const double tallest = *std::ranges::max_element(key.heights);
    CHECK(tallest >= 10);  // letters that can be read
    CHECK(std::ranges::count(key.heights, tallest) > 4);
  }
}

TEST_CASE("Names that fit are not shortened, and a key that does not fit into one line takes more") {
  const Drawn names = drawn({"cube", "ball"}, true);
  CHECK(names.heights.size() == 8);
  const Drawn words = drawn({std::string(12, 'H'), "B", std::string(11, 'H')}, false);
  CHECK(words.heights.size() == 24);
  REQUIRE(words.signs.size() == 3);
  CHECK(words.signs[0].y() == words.signs[1].y());
  CHECK(words.signs[1].y() + 15 < words.signs[2].y());
  CHECK(words.below >= names.below + 15);
  CHECK(words.right <= frame.max.x());
}

TEST_CASE("A key stands beside its title or below it, whole, at every scale of text") {
  for (const double text : {0.75, 1.0, 1.25, 1.5}) {
    INFO(text);
    render::Theme theme = render::themes::report;
    theme.text = text;
    const Drawn alone = drawn({}, false, "a - b", theme), few = drawn({"newest"}, false, "a - b", theme);
    const Drawn many = drawn({"newest", "simplex", "earlier"}, false, "a - b, close up", theme);
    CHECK(few.below == alone.below);
    CHECK(many.below > alone.below);
    CHECK(many.heights.size() == 11 + 20);
    REQUIRE(many.signs.size() == 3);
    CHECK(many.signs.back().y() < many.below);
    CHECK(many.right <= frame.max.x());
    CHECK(*std::ranges::max_element(many.heights) >= 10);
  }
}

TEST_CASE("A title too long for its panel ends in an ellipsis, in letters that can be read") {
  const Drawn title = drawn({}, false, std::string(90, 'H'));
  CHECK(title.right <= frame.max.x());
  CHECK(title.heights.size() > 15);
  CHECK(*std::ranges::max_element(title.heights) >= 10);
}

TEST_CASE("A title that smaller letters make fit is whole, however letters are rounded to pixels") {
  render::Font font(render::Font::default_directory());
  render::Theme theme = render::themes::report;
  theme.text = 1.5;
  const std::string title = "BCD edge-on, hatched: left behind";
  for (int width = 200; width < 1600; width += 50) {
    INFO(width);
    render::Canvas canvas({width, width}, {500, 500}, theme.paper, font);
    const Style style(theme);
    draw_panel_title(canvas, {{40, 10}, {450, 200}}, title, style, {key_of_newest(style)});
    for (const render::Shape& shape : canvas.shapes())
      if (const auto* text = std::get_if<render::shape::Text>(&shape))
        CHECK((text->text == title || text->text == "newest"));
  }
}

TEST_CASE("A name is shortened by whole letters, also of several bytes and of those that markup escapes") {
  std::string accents, underscores;
  for (int i = 0; i < 40; ++i) {
    accents += "É";
    underscores += "\\_";
  }
  const Drawn key = drawn({accents, underscores}, true);
  CHECK(key.signs.size() == 2);
  CHECK(key.right <= frame.max.x());
}

TEST_CASE("A name of two words that is too long for a line goes on in the next, whole") {
  const Drawn key = drawn({std::string(14, 'H') + " " + std::string(13, 'H'), "B"}, true);
  CHECK(key.signs.size() == 2);
  CHECK(key.heights.size() == 28);
  CHECK(key.right <= frame.max.x());
}

}  // namespace panel_title_test
