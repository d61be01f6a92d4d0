#include "render/font.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/bidi.hpp"
#include "render/utf8.hpp"

namespace render {
namespace {

// ---------------------------------------------------------------------------------------------- markup

/// Takes `prefix` off the front of `text` where it stands there.
bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::vector<Character> parse_markup(std::string_view text) {
  std::vector<Character> characters;
  while (!text.empty()) {
    if (skip(text, "\\_")) {
      characters.push_back({U'_', Level::baseline});
    } else if (skip(text, "_{")) {
      while (!text.empty() && !skip(text, "}")) characters.push_back({next_code_point(text), Level::subscript});
    } else if (text.size() > 1 && skip(text, "_")) {
      characters.push_back({next_code_point(text), Level::subscript});
    } else {
      characters.push_back({next_code_point(text), Level::baseline});
    }
  }
  return characters;
}

constexpr double subscript_size = 0.7;  // ems, as is the next
constexpr double subscript_drop = 0.2;

// ---------------------------------------------------------------------------------------------- font units to pixels

// FreeType's fixed-point numbers with 6 fractional bits.
int to_26_6(double pixels) { return static_cast<int>(std::lround(pixels * 64)); }
double from_26_6(int value) { return static_cast<double>(value) / 64; }
int rounded_26_6(int value) { return (value + 32) >> 6; }
int floor_26_6(int value) { return value >> 6; }
int ceil_26_6(int value) { return (value + 63) >> 6; }

/// Font units to 26.6, rounded as FreeType does it, so that boxes are those of its bitmaps: FT_DivFix() gives a factor with 16
/// fractional bits, FT_MulFix() rounds halves away from 0.
class Scale {
 public:
  Scale(int size, int em) : factor_(((std::int64_t{std::max(size, smallest)} << 16) + em / 2) / em) {}

  int operator()(int units) const {
    const std::int64_t product = units * factor_;
    return static_cast<int>((product + 0x8000 - (product < 0 ? 1 : 0)) >> 16);
  }

 private:
  static constexpr int smallest = 64;  // FreeType sets no size below a pixel
  std::int64_t factor_;
};

/// Each number is scaled by itself, as FreeType scales points and offsets before it adds them.
/// Returns: the box of the bitmap, its pen at (0,0).
PlacedGlyph box_of(const GlyphUnits& glyph, const Scale& scale) {
  if (glyph.parts.empty()) return {};
  int left = std::numeric_limits<int>::max(), bottom = left, right = std::numeric_limits<int>::min(), top = right;
  for (const GlyphPart& part : glyph.parts) {
    int x = -scale(glyph.origin), y = 0;
    for (const GlyphPart::Offset& offset : part.offsets) {
      x += scale(offset.x);
      y += scale(offset.y);
    }
    left = std::min(left, x + scale(part.left));
    bottom = std::min(bottom, y + scale(part.bottom));
    right = std::max(right, x + scale(part.right));
    top = std::max(top, y + scale(part.top));
  }
  PlacedGlyph box{.x = floor_26_6(left), .y = -ceil_26_6(top)};
  box.width = std::min(ceil_26_6(right) - box.x, Font::atlas_width);
  box.height = -floor_26_6(bottom) - box.y;
  return box;
}

}  // namespace

// ---------------------------------------------------------------------------------------------- Font

const GlyphUnits& Font::known(Weight weight, char32_t code) {
  const auto found = known_.find({weight, code});
  return found != known_.end() ? found->second
                               : known_.emplace(std::pair(weight, code), glyph(weight, code)).first->second;
}

TextLine Font::set(std::string_view text, double pixels, Weight weight) {
  const double em = std::clamp(pixels, 1.0, max_pixels);
  const FaceUnits units = face(weight);
  TextLine line;
  int pen = 0;  // 26.6
  unsigned previous = 0;
  Level previous_level = Level::baseline;
  for (const auto& [code, level] : in_visual_order(parse_markup(text))) {
    const int size = to_26_6(level == Level::subscript ? subscript_size * em : em);
    const Scale scale(size, units.em);
    const GlyphUnits& glyph = known(weight, code);
    if (glyph.index == 0) missing_.insert(code);
    if (level == previous_level) pen += scale(kerning(weight, previous, glyph.index));

    PlacedGlyph& placed = line.glyphs.emplace_back(box_of(glyph, scale));
    const double drop = level == Level::subscript ? subscript_drop * em : 0;
    placed.x += rounded_26_6(pen);
    placed.y += static_cast<int>(std::lround(drop));
    placed.code = code;
    placed.index = glyph.index;
    placed.weight = weight;
    placed.size = from_26_6(size);
    placed.pen = {from_26_6(pen), drop};
    pen += scale(glyph.origin + glyph.advance) - scale(glyph.origin);
    previous = glyph.index;
    previous_level = level;
  }
  line.advance = from_26_6(pen);

  const double pixels_per_unit = em / units.em;
  line.ascent = units.ascender * pixels_per_unit;
  line.descent = -units.descender * pixels_per_unit;
  line.cap_height = units.cap_height * pixels_per_unit;
  return line;
}

}  // namespace render
