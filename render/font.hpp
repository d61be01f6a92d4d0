/// Text: FreeType glyphs of DejaVu Sans, with subscripts.
///
/// Markup: `_x` sets the next character as a subscript, `_{xyz}` several; `\_` is an underscore. Text is UTF-8.
/// A character that the font lacks is drawn as the font's own box, a byte that is not UTF-8 as U+FFFD. Hebrew and Arabic run
/// from right to left.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
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
  char32_t code = 0;          ///< the letter, shaped
  unsigned index = 0;         ///< in the font
  double size = 0;            ///< of its em
  Vec2 pen = Vec2::Zero();    ///< where its outline begins; the bitmap stands on whole pixels
  int x = 0, y = 0;           ///< top left corner of the bitmap
  int width = 0, height = 0;  ///< size of the bitmap; 0 for a space
  int atlas_x = 0, atlas_y = 0;
};

/// A line of text set in glyphs, all numbers in pixels.
struct TextLine {
  std::vector<PlacedGlyph> glyphs;
  double advance = 0;              ///< width of the line, to where the next line's text would begin
  double ascent = 0, descent = 0;  ///< of the font at this size (not of the letters used): both positive
  double cap_height = 0;           ///< of an H, above the baseline
};

/// Returns: the version of FreeType that runs, such as "2.12.1".
std::string freetype_version();

/// The faces that the pictures use and a cache of their glyph bitmaps (8-bit coverage, in one growing atlas).
class Font {
 public:
  /// Loads DejaVuSans.ttf and DejaVuSans-Bold.ttf.
  /// Errors: FontError; std::bad_alloc where memory is lacking.
  explicit Font(const std::filesystem::path& directory);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Returns: the folder that the environment variable GJKSTEP_FONT_DIR names, else the one known to the build.
  static std::filesystem::path default_directory();

  /// Requires: 1 <= pixels <= max_pixels, the em size; sizes outside are drawn at the nearest one. Glyphs are placed on
  /// whole pixels, unhinted, so that text is the same wherever it stands.
  static constexpr double max_pixels = 400;
  TextLine set(std::string_view text, double pixels, Weight weight);

  /// Returns: where the outlines are.
  const std::filesystem::path& file(Weight weight) const;

  /// Returns: the characters that it was asked for and does not have.
  const std::set<char32_t>& missing() const;

  /// The atlas: `atlas_width` bytes a row; grows downwards only, so old glyph positions stay valid.
  static constexpr int atlas_width = 1024;
  int atlas_height() const;
  const std::vector<std::uint8_t>& atlas() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
