/// Prints what render::Font makes of many texts, to be compared: what is linked with it has its measures of files or of a table.
///
///     measured-by-files FOLDER-OF-FONTS
#include <cstdio>
#include <string>
#include <vector>

#include "render/font.hpp"
#include "render/utf8.hpp"

namespace {

struct Block {
  char32_t first, last;
};

/// Without marks that turn text around, which is not the table's.
constexpr Block blocks[] = {{0x20, 0x24F},    {0x370, 0x4FF},   {0x2010, 0x2027}, {0x2030, 0x205E},
                            {0x2070, 0x209C}, {0x2190, 0x22FF}, {0x25A0, 0x25FF}, {0x2713, 0x2718}};

std::vector<std::string> texts() {
  std::vector<std::string> texts = {"Algorithm 1: w·d < 0", "a_{ij} − b_0 × (c_x, c_y)", "AVATAR To. Ty, “Vo”",
                                    "\xFF?"};
  for (const Block& block : blocks) {
    std::string line;
    for (char32_t code = block.first; code <= block.last; ++code) line += render::utf8_of(code);
    texts.push_back(line);
  }
  std::string line;
  for (char left = '!'; left <= '~'; ++left) {
    for (char right = '!'; right <= '~'; ++right) line += {left, right};
    texts.push_back(line);
    line.clear();
  }
  return texts;
}

void print(const render::TextLine& line) {
  std::printf("%a %a %a %a\n", line.advance, line.ascent, line.descent, line.cap_height);
  for (const render::PlacedGlyph& glyph : line.glyphs)
    std::printf("%x %a %a %d %d %d %d\n", static_cast<unsigned>(glyph.code), glyph.pen.x(), glyph.pen.y(), glyph.x,
                glyph.y, glyph.width, glyph.height);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  render::Font font(arguments[1]);
  for (const std::string& text : texts())
    for (const double size : {1.0, 3.3, 9.0, 13.7, 20.0, 26.2, 64.9, 399.0})
      for (const render::Weight weight : {render::Weight::regular, render::Weight::bold})
        print(font.set(text, size, weight));
  for (const char32_t code : font.missing()) std::printf("%x\n", static_cast<unsigned>(code));
}
