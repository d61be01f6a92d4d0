/// Are two pictures the same? Decoded pixels are compared, never the bytes of files.
///
/// Renderers of other processor classes round differently: a few scattered samples flip, and nothing else. A mistake
/// moves something that can be seen, and that is a group of neighbouring pixels. So it is counted how many pixels are
/// off, and how many of them hang together. There is no percentage and no average over the picture: either would let a
/// small thing, such as a missing letter, disappear in a large white page.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "render/image.hpp"

namespace render {

/// How far two pictures of the same thing may differ. Measured with Mesa's llvmpipe on other processor classes: without
/// AVX and FMA 18 of 921,600 pixels differ, scattered, two of them by a whole step of multisampling.
/// The tests of render/compare.cpp pin both sides of each number.
struct Tolerance {
  int channel = 2;                  ///< a pixel is off when one of its channels differs by more
  std::int64_t few = 8;             ///< so many pixels may be off,
  std::int64_t one_in = 50'000;     ///< in a large picture that part of all of them, 2e-5,
  std::int64_t small_one_in = 100;  ///< and in a small one no more than that part
  std::int64_t group = 4;           ///< so many pixels that are off may hang together, by an edge or a corner
  std::string reason = {};          ///< why not the numbers above; required with others

  /// Returns: how many pixels of a picture of that size may be off.
  std::int64_t allowed(Size size) const;
  friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

/// compare() gives the first four of two pictures; the others are about files (render/compare_files.hpp).
enum class Verdict { same, within_tolerance, different, other_size, missing, extra, unreadable };

/// Returns: whether the comparison is passed.
constexpr bool passes(Verdict verdict) { return verdict == Verdict::same || verdict == Verdict::within_tolerance; }

/// "same", "within the tolerance", "different", "another size", "missing", "extra" or "unreadable".
const char* name(Verdict verdict);

/// The pixels with min <= (x,y) <= max; (0,0) is the top left pixel of the picture.
struct PixelBox {
  int min_x = 0, min_y = 0, max_x = 0, max_y = 0;

  int width() const { return max_x - min_x + 1; }
  int height() const { return max_y - min_y + 1; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// What compare() found. Everything below `actual` is 0 where the sizes differ.
struct Comparison {
  Verdict verdict = Verdict::same;
  Tolerance tolerance = {};
  Size expected = {}, actual = {};
  std::int64_t off = 0, allowed = 0;             ///< pixels that are off, and that may be
  std::int64_t largest_group = 0;                ///< the most pixels that are off and hang together
  PixelBox box = {};                             ///< around all pixels that are off; invalid where off is 0
  std::array<std::int64_t, 256> histogram = {};  ///< [d]: pixels whose most different channel differs by d

  /// Returns: the largest difference of any channel.
  int largest_difference() const;
};

/// Passes where at most `tolerance.allowed()` pixels are off and no 8-connected group of them is larger than
/// `tolerance.group`. Memory: besides the pictures, a few words for each pixel of a row and for each group.
/// Errors: std::invalid_argument where `tolerance` is not the usual one and gives no reason.
Comparison compare(const Image& expected, const Image& actual, const Tolerance& tolerance = {});

/// Returns: one line of plain text, such as "15 pixels are off (8 may be); the largest group is 3 pixels (4 may be); …".
std::string in_words(const Comparison& comparison);

inline constexpr int difference_gain = 16;

/// Returns: a picture of the differences of the channels, `difference_gain` times as large, on black.
/// Requires: pictures of the same size.
Image difference(const Image& expected, const Image& actual);

}  // namespace render
