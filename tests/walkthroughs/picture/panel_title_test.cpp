// The key of a panel: both objects are told apart, however long their names are.

#include "walkthroughs/picture/panel_title.hpp"

#include <algorithm>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

using namespace walkthroughs::program;
using render::Vec2;

namespace {

const render::Box frame{{40, 10}, {340, 200}};

/// What was drawn of a key: the places of its signs, and its letters.
struct Drawn {
  std::vector<double> signs;
  double left = 1e9, right = 0;  // of all letters
  std::vector<double> heights;   // of each letter
};

Drawn drawn(const std::vector<std::string>& texts, bool may_be_shortened) {
  render::Font font(render::Font::default_directory());
  render::Canvas canvas({400, 220}, {400, 220}, render::palette::white, font);
  Drawn result;
  std::vector<KeyEntry> key;
  for (const std::string& text : texts)
    key.push_back(
        {text, [&](render::Canvas&, const Vec2& at) { result.signs.push_back(at.x()); }, 15, may_be_shortened});
  draw_panel_title(canvas, frame, "", Style(render::themes::report), key);
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

TEST_CASE("Names that fit are not shortened, and other words are left out from the end") {
  CHECK(drawn({"cube", "ball"}, true).heights.size() == 8);
  CHECK(drawn({std::string(40, 'H'), "B"}, false).signs.empty());
  CHECK(drawn({"B", std::string(40, 'H')}, false).signs.size() == 1);
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
