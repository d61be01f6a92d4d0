/// What DejaVu measures, as a table of whole numbers, for programs that have no font files.
#pragma once

#include <cstdint>
#include <span>

#include "render/font.hpp"

namespace render::font_table {

/// Letters without a gap, in the order of their codes.
struct Range {
  std::uint16_t first, last;
  std::uint16_t glyph;  ///< of the first
};

/// Of the glyph of that index.
struct Glyph {
  std::int16_t advance;
  std::uint16_t part;  ///< its first one; they end where those of the next glyph begin
};

/// A box and its offsets, by their places among all that differ.
struct Part {
  std::uint16_t box, offsets;
};

/// By which a part is moved, 0 where it is not.
struct Offsets {
  std::int16_t x, y, then_x, then_y;
};

struct Box {
  std::int16_t left, bottom, right, top;
};

/// What stands before glyphs that are nearer to it or farther from it than usual.
struct Left {
  std::uint16_t glyph;
  std::uint16_t pair;  ///< its first one; they end where those of the next begin
};

struct Pair {
  std::uint16_t right;
  std::int16_t kerning;
};

/// Glyph 0 is the box that stands for what is lacking. Glyphs and lefts end with one more that says where the parts and pairs end.
struct Table {
  FaceUnits face;
  std::span<const Range> ranges;
  std::span<const Glyph> glyphs;
  std::span<const Part> parts;
  std::span<const Box> boxes;
  std::span<const Offsets> offsets;
  std::span<const Left> lefts;
  std::span<const Pair> pairs;
};

/// Indexed by Weight. Written by write_font_table.cpp.
extern const Table tables[2];

}  // namespace render::font_table
