/// 8-bit RGB pictures in memory and as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "render/color.hpp"
#include "render/file.hpp"
#include "render/geometry.hpp"

namespace render {

/// The largest picture that is written or read, each way.
inline constexpr int max_image_side = 16384;
/// Returns: what speaks against such a picture: that it is larger. Empty where nothing does.
std::string objection_to_size(std::uint32_t width, std::uint32_t height);

/// Rows from top to bottom, three bytes a pixel, no padding.
class Image {
 public:
  /// Requires: width and height >= 1. Black.
  explicit Image(Size size);

  Size size() const { return size_; }
  /// Requires: 0 <= x < width, 0 <= y < height; (0,0) is the top left pixel. Alpha is 255.
  Color pixel(int x, int y) const;
  /// Returns: the first byte of row `y`, counted from the top.
  std::uint8_t* row(int y);
  const std::uint8_t* row(int y) const;

  /// Makes every pixel `color`; its alpha is not looked at.
  void fill(Color color);
  /// Copies `other` into this image, its top left pixel to (x,y). Requires: it fits.
  void paste(const Image& other, int x, int y);

  friend bool operator==(const Image&, const Image&) = default;

 private:
  Size size_;
  std::vector<std::uint8_t> bytes_;
};

/// Text stored inside a PNG, in UTF-8 (ASCII as tEXt, anything else as iTXt). There is no time stamp: same picture, same file.
struct PngText {
  std::string title;
  std::string description;
};

/// Returns: `image` as a PNG file. 8-bit RGB, compression level 6, no filter: of the settings that were tried the
/// smallest files for pictures of lines and flat areas (see tests/bench/render_bench.cpp).
/// Errors: FileError, also where the picture is larger than max_image_side.
std::vector<std::uint8_t> encode_png(const Image& image, const PngText& text);

/// Animated PNG, https://www.w3.org/TR/png-3/: pictures of one size, each with the time for which it is shown. A viewer that
/// knows nothing of animation shows the first picture.
/// Returns: a file that runs through `count` pictures for ever. `png` is asked once for each, in order, for what encode_png()
/// returned; `seconds` for how long it is shown, rounded to milliseconds (above a minute: to hundredths).
/// Requires: count >= 1; 0 <= seconds <= 600.
/// Errors: std::invalid_argument where a picture has not the size of the first one.
std::vector<std::uint8_t> encode_apng(std::size_t count,
                                      const std::function<std::vector<std::uint8_t>(std::size_t index)>& png,
                                      const std::function<double(std::size_t index)>& seconds, const PngText& text);

/// A PNG file as it is read.
struct PngPicture {
  Image image;                             ///< of an animation the first picture
  std::vector<std::string> warnings = {};  ///< what is wrong with it and does not touch the pixels: clauses
  std::map<std::string, std::string> colours =
      {};                      ///< its chunks gAMA, cHRM, sRGB, iCCP and cICP, which say how to show samples
  std::uint32_t pictures = 1;  ///< of the animation
};

/// Returns: the decoded picture: the samples that are stored, of 16 bits the upper 8, rounded. Grey, palette and alpha are
/// converted to RGB; alpha over white. What comes after the end chunk is no part of the picture and not looked at. `name`
/// is what errors call it.
/// Errors: ReadError where that is no PNG, damaged anywhere but in a chunk that holds no pixels, cut off, or larger than
/// max_image_side.
PngPicture decode_png(std::span<const std::uint8_t> png, const std::string& name);

/// Returns: the picture in the file, as decode_png(); what is no picture is not read as a whole. Errors: ReadError, as
/// read_file() and decode_png().
PngPicture read_png(const std::filesystem::path& path);

}  // namespace render
