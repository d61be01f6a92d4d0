/// What set() computes of font units is what FreeType would draw, to the pixel.
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "render/font.hpp"
#include "render/utf8.hpp"
#include "tests/kit/catch.hpp"

namespace font_measures_test {

using namespace render;

namespace {

constexpr Weight weights[] = {Weight::regular, Weight::bold};

/// FreeType itself.
class Drawn {
 public:
  explicit Drawn(const std::string& file) {
    REQUIRE(FT_Init_FreeType(&library_) == 0);
    REQUIRE(FT_New_Face(library_, file.c_str(), 0, &face_) == 0);
  }
  ~Drawn() { FT_Done_FreeType(library_); }
  Drawn(const Drawn&) = delete;
  Drawn& operator=(const Drawn&) = delete;

  void resize(double pixels) { REQUIRE(FT_Set_Char_Size(face_, 0, std::lround(pixels * 64), 72, 72) == 0); }
  FT_GlyphSlot load(unsigned index, FT_Int32 also = 0) {
    REQUIRE(FT_Load_Glyph(face_, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | also) == 0);
    return face_->glyph;
  }
  double kerning(char32_t left, char32_t right) {
    FT_Vector kerning;
    FT_Get_Kerning(face_, FT_Get_Char_Index(face_, left), FT_Get_Char_Index(face_, right), FT_KERNING_UNFITTED,
                   &kerning);
    return static_cast<double>(kerning.x) / 64;
  }
  std::vector<char32_t> codes() {
    std::vector<char32_t> codes;
    FT_UInt index = 0;
    for (FT_ULong code = FT_Get_First_Char(face_, &index); index != 0; code = FT_Get_Next_Char(face_, code, &index))
      codes.push_back(static_cast<char32_t>(code));
    return codes;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

/// Sizes of no pattern, from `smallest` to the largest, each some `step` times the one before it.
std::vector<double> sizes(double smallest, double step) {
  std::vector<double> sizes;
  for (double size = smallest; size < Font::max_pixels; size = size * step + 0.137) sizes.push_back(size);
  sizes.push_back(Font::max_pixels);
  return sizes;
}

std::string told(const PlacedGlyph& g) {
  return std::to_string(g.width) + "x" + std::to_string(g.height) + " at " + std::to_string(g.x) + "," +
         std::to_string(g.y);
}

}  // namespace

TEST_CASE("boxes and advances of all glyphs are those of FreeType's outlines at all sizes") {
  Font font(Font::default_directory());
  for (const Weight weight : weights) {
    Drawn drawn(font.file(weight));
    const std::vector<char32_t> codes = drawn.codes();
    REQUIRE(codes.size() > 5000);
    std::string wrong;
    for (const double size : sizes(1, 1.2)) {
      drawn.resize(size);
      for (const char32_t code : codes) {
        const TextLine line = font.set(code == U'_' ? "\\_" : utf8_of(code), size, weight);
        if (line.glyphs.empty()) continue;  // a mark of direction
        const PlacedGlyph& glyph = line.glyphs[0];
        const FT_GlyphSlot slot = drawn.load(glyph.index);
        FT_BBox box;
        FT_Outline_Get_CBox(&slot->outline, &box);
        PlacedGlyph right{.x = static_cast<int>(box.xMin >> 6), .y = -static_cast<int>((box.yMax + 63) >> 6)};
        right.width = std::min(static_cast<int>((box.xMax + 63) >> 6) - right.x, Font::atlas_width);
        right.height = -static_cast<int>(box.yMin >> 6) - right.y;
        const double advance = static_cast<double>(slot->advance.x) / 64;
        if (told(glyph) != told(right) || line.advance != advance)
          wrong += std::to_string(static_cast<unsigned>(code)) + " at " + std::to_string(size) + ": " + told(glyph) +
                   ", not " + told(right) + "\n";
      }
    }
    INFO(wrong.substr(0, 1000));
    CHECK(wrong.empty());
  }
}

TEST_CASE("boxes are those of the bitmaps that FreeType draws") {
  Font font(Font::default_directory());
  for (const Weight weight : weights) {
    Drawn drawn(font.file(weight));
    for (const double size : sizes(1.5, 1.7)) {
      drawn.resize(size);
      for (const char32_t code : drawn.codes()) {
        if (code % 7 != 0 && code > 0x180) continue;
        const TextLine line = font.set(code == U'_' ? "\\_" : utf8_of(code), size, weight);
        if (line.glyphs.empty() || line.glyphs[0].width == 0) continue;
        const PlacedGlyph& glyph = line.glyphs[0];
        const FT_GlyphSlot slot = drawn.load(glyph.index, FT_LOAD_RENDER);
        INFO(static_cast<unsigned>(code) << " at " << size);
        REQUIRE(told(glyph) == told({.x = slot->bitmap_left,
                                     .y = -slot->bitmap_top,
                                     .width = std::min(static_cast<int>(slot->bitmap.width), Font::atlas_width),
                                     .height = static_cast<int>(slot->bitmap.rows)}));
      }
    }
  }
}

TEST_CASE("pairs of letters are as near to each other as FreeType says") {
  Font font(Font::default_directory());
  int pairs = 0;
  for (const Weight weight : weights) {
    Drawn drawn(font.file(weight));
    for (const double size : {7.3, 20.0, 111.1}) {
      drawn.resize(size);
      for (char left = 'A'; left <= 'z'; ++left)
        for (const char right : std::string("AVTLYavyo-.,")) {
          if (left == '_' || left == '\\') continue;
          const auto width = [&](const std::string& text) { return font.set(text, size, weight).advance; };
          const double kerning = drawn.kerning(static_cast<char32_t>(left), static_cast<char32_t>(right));
          const std::string first(1, left), second(1, right);
          REQUIRE(width(first + second) == width(first) + width(second) + kerning);
          pairs += kerning != 0;
        }
    }
  }
  CHECK(pairs > 300);
}

}  // namespace font_measures_test
