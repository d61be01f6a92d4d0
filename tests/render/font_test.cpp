#include "render/font.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"

namespace font_test {

using namespace render;

namespace {

struct Fixture {
  Font font{Font::default_directory()};
  TextLine set(std::string_view text, double pixels = 40) { return font.set(text, pixels, Weight::regular); }
};

bool same_bitmap(const PlacedGlyph& a, const PlacedGlyph& b) {
  return a.index == b.index && a.weight == b.weight && a.size == b.size && a.width == b.width && a.height == b.height;
}

}  // namespace

TEST_CASE_METHOD(Fixture, "subscripts are smaller and lower, one character or several") {
  const TextLine plain = set("xx"), one = set("x_x"), several = set("x_{xx}y");
  REQUIRE(plain.glyphs.size() == 2);
  REQUIRE(one.glyphs.size() == 2);
  REQUIRE(several.glyphs.size() == 4);
  REQUIRE(one.glyphs[1].height < plain.glyphs[1].height);
  REQUIRE(one.glyphs[1].height == Approx(0.7 * plain.glyphs[1].height).margin(1.5));
  const auto bottom = [](const PlacedGlyph& glyph) { return glyph.y + glyph.height; };
  REQUIRE(bottom(one.glyphs[1]) - bottom(plain.glyphs[1]) == 8);  // 0.2 em
  REQUIRE(same_bitmap(several.glyphs[1], several.glyphs[2]));
  REQUIRE(same_bitmap(several.glyphs[1], one.glyphs[1]));
  REQUIRE(several.glyphs[3].height > several.glyphs[2].height);
}

TEST_CASE_METHOD(Fixture, "markup at its limits: escaped, at the end, not closed, empty") {
  REQUIRE(same_bitmap(set("\\_").glyphs.at(0), set("_").glyphs.at(0)));
  REQUIRE(set("a\\_b").glyphs.size() == 3);
  REQUIRE(set("a_").glyphs.size() == 2);
  REQUIRE(set("a_{bc").glyphs.size() == 3);
  REQUIRE(set("a_{}").glyphs.size() == 1);
  REQUIRE(set("").glyphs.empty());
  REQUIRE(set("").ascent > 30);
}

TEST_CASE_METHOD(Fixture, "a byte that is not UTF-8 becomes U+FFFD and the text goes on") {
  const PlacedGlyph bad = set("\uFFFD").glyphs.at(0);
  for (const std::string text : {"\xFF", "\xC3", "\x80"}) {
    const TextLine line = set(text + "x");
    REQUIRE(line.glyphs.size() == 2);
    REQUIRE(same_bitmap(line.glyphs[0], bad));
    REQUIRE(same_bitmap(line.glyphs[1], set("x").glyphs[0]));
  }
  REQUIRE(set("\xC0\xAF").glyphs.size() == 2);          // an overlong '/'
  REQUIRE(set("\xED\xA0\x80").glyphs.size() == 3);      // a surrogate
  REQUIRE(set("\xF4\x90\x80\x80").glyphs.size() == 4);  // beyond U+10FFFF
  REQUIRE(set("\xE2\x89").glyphs.size() == 2);          // cut off
  REQUIRE(set("_\xE2").glyphs.size() == 1);
}

TEST_CASE_METHOD(Fixture, "the atlas keeps its glyphs while it grows") {
  const PlacedGlyph first = set("A", 60).glyphs.at(0);
  const auto byte_of = [&](int x, int y) {
    const auto [left, top] = font.in_atlas(first);
    return font.atlas().at(static_cast<std::size_t>((top + y) * Font::atlas_width + left + x));
  };
  std::vector<std::uint8_t> before;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) before.push_back(byte_of(x, y));
  }
  REQUIRE(*std::max_element(before.begin(), before.end()) == 255);
  const int height = font.atlas_height();
  for (int size = 50; size < 80; ++size)
    for (const PlacedGlyph& glyph : set("ABCDEFGHIJKLMNOPQRSTUVWXYZ", size).glyphs) font.in_atlas(glyph);
  REQUIRE(font.atlas_height() > height);
  REQUIRE(same_bitmap(set("A", 60).glyphs.at(0), first));
  std::size_t i = 0;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) REQUIRE(byte_of(x, y) == before[i++]);
  }
}

TEST_CASE_METHOD(Fixture, "size and weight change the letters, sizes outside the range are brought into it") {
  REQUIRE(set("x", 40).advance == Approx(2 * set("x", 20).advance).epsilon(0.01));
  REQUIRE(font.set("x", 40, Weight::bold).advance > set("x", 40).advance);
  REQUIRE(set("x", 1e9).advance == set("x", Font::max_pixels).advance);
  REQUIRE(set("x", -5).advance == set("x", 1).advance);
}

TEST_CASE("a font that finds no memory is not called a wrong one") {
  constexpr int lack_of_memory = 40, wrong_font = 41;
  const pid_t child = fork();
  if (child == 0) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit now{pages * static_cast<std::size_t>(getpagesize()), RLIM_INFINITY};
    ::setrlimit(RLIMIT_AS, &now);
    constexpr std::size_t much = 100'000;  // less than the files have, more than FreeType needs besides
    while (void* taken = std::malloc(much)) std::memset(taken, 1, much);
    try {
      const Font font(Font::default_directory());
    } catch (const std::bad_alloc&) {
      ::_exit(lack_of_memory);
    } catch (const FontError&) {
      ::_exit(wrong_font);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WEXITSTATUS(status) != lack_of_memory && WEXITSTATUS(status) != wrong_font)
    WARN("not tried: sanitizers end a program that has no memory left");
  CHECK(WEXITSTATUS(status) != wrong_font);
}

TEST_CASE("a font whose path no system takes is reported as one that cannot be read") {
  const kit::Folder folder;
  std::filesystem::create_symlink("loop", folder / "loop");
  CHECK_THROWS_WITH(Font(folder / "loop"), kit::contains("cannot be read: Too many levels"));
  CHECK_THROWS_WITH(Font(std::string(300, 'x')), kit::contains("cannot be read: File name too long"));
}

TEST_CASE("GJKSTEP_FONT_DIR names the folder of the fonts") {
  const char* set_before = std::getenv("GJKSTEP_FONT_DIR");
  const std::string before = set_before == nullptr ? "" : set_before;
  setenv("GJKSTEP_FONT_DIR", "/some/where", 1);
  REQUIRE(Font::default_directory() == "/some/where");
  setenv("GJKSTEP_FONT_DIR", "", 1);
  REQUIRE(Font::default_directory() == GJKSTEP_FONT_DIR_DEFAULT);
  if (set_before == nullptr) {
    unsetenv("GJKSTEP_FONT_DIR");
  } else {
    setenv("GJKSTEP_FONT_DIR", before.c_str(), 1);
  }
}

TEST_CASE_METHOD(Fixture, "Hebrew runs from right to left, numbers and Latin letters in it from left to right") {
  const auto glyphs = [&](std::string_view text) { return set(text).glyphs; };
  const auto are = [&](std::string_view text, std::vector<std::string_view> letters) {
    const std::vector<PlacedGlyph> found = glyphs(text);
    REQUIRE(found.size() == letters.size());
    for (std::size_t i = 0; i < letters.size(); ++i) REQUIRE(same_bitmap(found[i], glyphs(letters[i]).at(0)));
    for (std::size_t i = 1; i < found.size(); ++i) REQUIRE(found[i].x >= found[i - 1].x);
  };
  are("אבג", {"ג", "ב", "א"});
  are("א12", {"1", "2", "א"});
  are("cube א", {"c", "u", "b", "e", " ", "א"});
  are("(אב)", {"(", "ב", "א", ")"});
  are("א(", {")", "א"});
}

TEST_CASE_METHOD(Fixture, "a subscript stays with its letters where text is turned around") {
  const TextLine line = set("אב_{ג}");
  REQUIRE(line.glyphs.size() == 3);
  REQUIRE(line.glyphs[0].height < line.glyphs[1].height);
}

TEST_CASE_METHOD(Fixture, "Arabic letters are joined, and marks of direction draw nothing") {
  const TextLine joined = set("بب"), alone = set("ب");
  REQUIRE(joined.glyphs.size() == 2);
  REQUIRE_FALSE(same_bitmap(joined.glyphs[0], joined.glyphs[1]));
  REQUIRE_FALSE(same_bitmap(joined.glyphs[0], alone.glyphs[0]));
  REQUIRE(set("\u200Fא\u200F").glyphs.size() == 1);
}

TEST_CASE_METHOD(Fixture, "letters that the font lacks are remembered, each once, and no others") {
  set("cube → ∞, куб, קובייה");
  REQUIRE(font.missing().empty());
  set("漢字漢");
  REQUIRE(font.missing() == std::set<char32_t>{0x5B57, 0x6F22});
}

}  // namespace font_test
