/// A font without files: it measures by a table, and draws nothing. Text stays in the order in which it is written: who draws it
/// turns it around.
#include "render/live/font_table.hpp"

#include <algorithm>

#include "render/bidi.hpp"
#include "render/font.hpp"

namespace render {
namespace {

const font_table::Table& table(Weight weight) { return font_table::tables[static_cast<std::size_t>(weight)]; }

/// Returns: 0 for what the table lacks.
unsigned index_of(std::span<const font_table::Range> ranges, char32_t code) {
  const auto range = std::ranges::lower_bound(ranges, code, {}, &font_table::Range::last);
  return range == ranges.end() || code < range->first ? 0 : range->glyph + (code - range->first);
}

GlyphPart part_of(const font_table::Table& table, const font_table::Part& row) {
  const font_table::Box& box = table.boxes[row.box];
  const font_table::Offsets& by = table.offsets[row.offsets];
  return {box.left, box.bottom, box.right, box.top, {{by.x, by.y}, {by.then_x, by.then_y}}};
}

}  // namespace

struct Font::Source {};

Font::Font(const std::string&) {}
Font::~Font() = default;

FaceUnits Font::face(Weight weight) const { return table(weight).face; }

GlyphUnits Font::glyph(Weight weight, char32_t code) const {
  const font_table::Table& all = table(weight);
  GlyphUnits glyph{.index = index_of(all.ranges, code)};
  glyph.advance = all.glyphs[glyph.index].advance;
  for (std::size_t i = all.glyphs[glyph.index].part; i < all.glyphs[glyph.index + 1].part; ++i)
    glyph.parts.push_back(part_of(all, all.parts[i]));
  return glyph;
}

int Font::kerning(Weight weight, unsigned left, unsigned right) const {
  const font_table::Table& all = table(weight);
  const auto row = std::ranges::lower_bound(all.lefts, left, {}, &font_table::Left::glyph);
  if (row->glyph != left) return 0;  // the last row is of no glyph
  const auto pairs = all.pairs.subspan(row->pair, row[1].pair - row->pair);
  const auto pair = std::ranges::lower_bound(pairs, right, {}, &font_table::Pair::right);
  return pair == pairs.end() || pair->right != right ? 0 : pair->kerning;
}

std::vector<Character> in_visual_order(const std::vector<Character>& characters) { return characters; }

}  // namespace render
