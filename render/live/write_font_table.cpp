/// Writes the table of font_table.hpp as C++, for the letters that pictures have and those that names commonly have.
///
///     write-font-table font_tables.cpp
#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/font.hpp"
#include "render/live/font_table.hpp"

using namespace render;

namespace {

struct Block {
  char32_t first, last;
};

constexpr Block blocks[] = {{0x20, 0x24F},      // Latin
                            {0x370, 0x4FF},     // Greek, Cyrillic
                            {0x2000, 0x209F},   // punctuation, superscripts and subscripts
                            {0x2190, 0x22FF},   // arrows, mathematical operators
                            {0x25A0, 0x25FF},   // geometric shapes
                            {0x2713, 0x2718},   // ticks and crosses
                            {0xFFFD, 0xFFFD}};  // for bytes that are not UTF-8

template <class Small>
Small fitted(long value) {
  if (value != static_cast<Small>(value)) throw std::range_error("a number of the font does not fit the table");
  return static_cast<Small>(value);
}

using Four = std::array<std::int16_t, 4>;

Four fitted(int a, int b, int c, int d) {
  return {fitted<std::int16_t>(a), fitted<std::int16_t>(b), fitted<std::int16_t>(c), fitted<std::int16_t>(d)};
}

/// What a table points to, as it grows.
struct Rows {
  std::vector<font_table::Range> ranges;
  std::vector<font_table::Glyph> glyphs;
  std::vector<font_table::Part> parts;
  std::vector<font_table::Box> boxes;
  std::vector<font_table::Offsets> offsets;
  std::vector<font_table::Left> lefts;
  std::vector<font_table::Pair> pairs;
  std::vector<unsigned> in_font = {};  ///< index in the font, of each glyph
  std::map<Four, std::uint16_t> known_boxes = {}, known_offsets = {};
};

std::uint16_t size_of(const auto& rows) { return fitted<std::uint16_t>(static_cast<long>(rows.size())); }

/// Returns: where these numbers are among the rows, to which they are added where they are new.
template <class Row>
std::uint16_t place_of(const Four& numbers, std::vector<Row>& rows, std::map<Four, std::uint16_t>& known) {
  const auto [found, is_new] = known.emplace(numbers, size_of(rows));
  if (is_new) rows.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
  return found->second;
}

void add_part(Rows& rows, const GlyphPart& part) {
  std::vector<GlyphPart::Offset> by = part.offsets;
  if (by.size() > 2) throw std::range_error("a part of a glyph is moved more than twice");
  by.resize(2);
  rows.parts.push_back({place_of(fitted(part.left, part.bottom, part.right, part.top), rows.boxes, rows.known_boxes),
                        place_of(fitted(by[0].x, by[0].y, by[1].x, by[1].y), rows.offsets, rows.known_offsets)});
}

void add_glyph(Rows& rows, const GlyphUnits& glyph) {
  if (glyph.origin != 0) throw std::range_error("the table knows no glyph whose origin is not 0");
  rows.glyphs.push_back({fitted<std::int16_t>(glyph.advance), size_of(rows.parts)});
  rows.in_font.push_back(glyph.index);
  for (const GlyphPart& part : glyph.parts) add_part(rows, part);
}

void add_letter(Rows& rows, char32_t code, const GlyphUnits& glyph) {
  const auto last = fitted<std::uint16_t>(static_cast<long>(code));
  if (rows.ranges.empty() || rows.ranges.back().last + 1 != last)
    rows.ranges.push_back({last, last, size_of(rows.glyphs)});
  rows.ranges.back().last = last;
  add_glyph(rows, glyph);
}

void add_kerning(Rows& rows, const Font& font, Weight weight) {
  for (std::size_t left = 0; left < rows.in_font.size(); ++left) {
    const std::size_t before = rows.pairs.size();
    for (std::size_t right = 0; right < rows.in_font.size(); ++right)
      if (const int kerning = font.kerning(weight, rows.in_font[left], rows.in_font[right]); kerning != 0)
        rows.pairs.push_back({static_cast<std::uint16_t>(right), fitted<std::int16_t>(kerning)});
    if (rows.pairs.size() != before)
      rows.lefts.push_back({static_cast<std::uint16_t>(left), fitted<std::uint16_t>(static_cast<long>(before))});
  }
  rows.lefts.push_back({0xFFFF, size_of(rows.pairs)});
}

Rows rows_of(const Font& font, Weight weight) {
  Rows rows;
  add_glyph(rows, font.glyph(weight, U'\uFFFF'));  // no letter
  for (const Block& block : blocks)
    for (char32_t code = block.first; code <= block.last; ++code)
      if (const GlyphUnits glyph = font.glyph(weight, code); glyph.index != 0) add_letter(rows, code, glyph);
  rows.glyphs.push_back({0, size_of(rows.parts)});
  add_kerning(rows, font, weight);
  return rows;
}

// ---------------------------------------------------------------------------------------------- as C++

std::string numbers(const font_table::Range& r) {
  return std::to_string(r.first) + "," + std::to_string(r.last) + "," + std::to_string(r.glyph);
}
std::string numbers(const font_table::Glyph& g) { return std::to_string(g.advance) + "," + std::to_string(g.part); }
std::string numbers(const font_table::Part& p) { return std::to_string(p.box) + "," + std::to_string(p.offsets); }
std::string numbers(const font_table::Offsets& o) {
  return std::to_string(o.x) + "," + std::to_string(o.y) + "," + std::to_string(o.then_x) + "," +
         std::to_string(o.then_y);
}
std::string numbers(const font_table::Box& b) {
  return std::to_string(b.left) + "," + std::to_string(b.bottom) + "," + std::to_string(b.right) + "," +
         std::to_string(b.top);
}
std::string numbers(const font_table::Left& l) { return std::to_string(l.glyph) + "," + std::to_string(l.pair); }
std::string numbers(const font_table::Pair& p) { return std::to_string(p.right) + "," + std::to_string(p.kerning); }

template <class Row>
void write(const char* type, const std::string& name, const std::vector<Row>& rows) {
  std::printf("constexpr %s %s[] = {", type, name.c_str());
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::printf("%s{%s},", i % 8 == 0 ? "\n" : "", numbers(rows[i]).c_str());
  std::printf("};\n");
}

/// Returns: the table that is made of them.
std::string write(const Rows& rows, const FaceUnits& face, const std::string& suffix) {
  write("Range", "ranges" + suffix, rows.ranges);
  write("Glyph", "glyphs" + suffix, rows.glyphs);
  write("Part", "parts" + suffix, rows.parts);
  write("Box", "boxes" + suffix, rows.boxes);
  write("Offsets", "offsets" + suffix, rows.offsets);
  write("Left", "lefts" + suffix, rows.lefts);
  write("Pair", "pairs" + suffix, rows.pairs);
  std::string table = "{{" + std::to_string(face.em) + "," + std::to_string(face.ascender) + "," +
                      std::to_string(face.descender) + "," + std::to_string(face.cap_height) + "}";
  for (const char* name : {"ranges", "glyphs", "parts", "boxes", "offsets", "lefts", "pairs"})
    table += "," + (name + suffix);
  return table + "}";
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 || std::freopen(arguments[1], "w", stdout) == nullptr) return 1;
  try {
    const Font font(Font::default_directory());
    std::printf("#include \"render/live/font_table.hpp\"\nnamespace render::font_table {\nnamespace {\n");
    const std::string regular = write(rows_of(font, Weight::regular), font.face(Weight::regular), "_regular");
    const std::string bold = write(rows_of(font, Weight::bold), font.face(Weight::bold), "_bold");
    std::printf("}\nconst Table tables[2] = {%s,\n%s};\n}\n", regular.c_str(), bold.c_str());
    return std::fflush(stdout) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write-font-table: %s\n", error.what());
    return 1;
  }
}
