/// Text: glyphs of DejaVu Sans, with subscripts, where FreeType draws them.
///
/// Markup: `_x` sets the next character as a subscript, `_{xyz}` several; `\_` is an underscore. Text is UTF-8.
/// A character that the font lacks is drawn as the font's own box, a byte that is not UTF-8 as U+FFFD. Hebrew and Arabic run
/// from right to left.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/geometry.hpp"

namespace render {

/// A font file is missing or unreadable; what() names the file and the package that brings it.
struct FontError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Weight { regular, bold };

/// One glyph of a line of text, in pixels relative to the line's start: x to the right, y down from the baseline.
struct PlacedGlyph {
  char32_t code = 0;   ///< the letter, shaped
  unsigned index = 0;  ///< in the font
  Weight weight = Weight::regular;
  double size = 0;            ///< of its em
  Vec2 pen = Vec2::Zero();    ///< where its outline begins; the bitmap stands on whole pixels
  int x = 0, y = 0;           ///< top left corner of the bitmap
  int width = 0, height = 0;  ///< size of the bitmap; 0 for a space
};

/// A line of text set in glyphs, all numbers in pixels.
struct TextLine {
  std::vector<PlacedGlyph> glyphs;
  double advance = 0;              ///< width of the line, to where the next line's text would begin
  double ascent = 0, descent = 0;  ///< of the font at this size (not of the letters used): both positive
  double cap_height = 0;           ///< of an H, above the baseline
};

// What a font measures, in its own units, of which an em has some 2000; y up.

struct FaceUnits {
  int em, ascender, descender;
  int cap_height;  ///< of an H
};

/// An outline that a glyph is made of, by its control box. It may be that of another glyph, moved, and that a part of another.
struct GlyphPart {
  struct Offset {
    int x = 0, y = 0;
    friend bool operator==(const Offset&, const Offset&) = default;
  };
  int left, bottom, right, top;
  std::vector<Offset> offsets = {};
};

struct GlyphUnits {
  unsigned index = 0;  ///< in the font; 0: the box that stands for what it lacks
  int advance = 0;
  int origin = 0;                     ///< of the pen, in the units of the parts; mostly 0
  std::vector<GlyphPart> parts = {};  ///< none for a space
};

/// Returns: the version of FreeType that runs, such as "2.12.1".
std::string freetype_version();

/// The faces that the pictures use: set() lays out text by plain arithmetic on what they measure. That comes from files
/// (font_files.cpp), which are also what glyphs are drawn from, or from a table (live/font_table.cpp) where nothing is drawn.
class Font {
 public:
  /// Loads DejaVuSans.ttf and DejaVuSans-Bold.ttf.
  /// Errors: FontError; std::bad_alloc where memory is lacking.
  explicit Font(const std::string& directory);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Requires: 1 <= pixels <= max_pixels, the em size; sizes outside are drawn at the nearest one. Glyphs are placed on
  /// whole pixels, unhinted, so that text is the same wherever it stands.
  static constexpr double max_pixels = 400;
  TextLine set(std::string_view text, double pixels, Weight weight);

  /// Returns: the characters that it was asked for and does not have.
  const std::set<char32_t>& missing() const { return missing_; }

  FaceUnits face(Weight weight) const;
  GlyphUnits glyph(Weight weight, char32_t code) const;
  /// Returns: what is added between two glyphs, given by their indices.
  int kerning(Weight weight, unsigned left, unsigned right) const;

  // From here on only where there are files.

  /// Returns: the folder that the environment variable GJKSTEP_FONT_DIR names, else the one known to the build.
  static std::string default_directory();

  /// Returns: where the outlines are.
  const std::string& file(Weight weight) const;

  /// The atlas holds bitmaps of glyphs, 8-bit coverage, `atlas_width` bytes a row; it grows downwards only, so old places stay
  /// valid.
  static constexpr int atlas_width = 1024;
  int atlas_height() const;
  const std::vector<std::uint8_t>& atlas() const;
  struct Texel {
    int x = 0, y = 0;
  };
  /// Returns: the top left corner of the bitmap of a glyph, which is drawn when it is first asked for.
  /// Requires: it comes from set() and has a width.
  Texel in_atlas(const PlacedGlyph& glyph);

 private:
  const GlyphUnits& known(Weight weight, char32_t code);

  struct Source;
  std::unique_ptr<Source> source_;
  std::map<std::pair<Weight, char32_t>, GlyphUnits> known_;
  std::set<char32_t> missing_;
};

}  // namespace render
