/// Are two pictures the same? Decoded pixels are compared, never the bytes of files.
///
/// Renderers of other processor classes round differently: a few scattered samples flip, and nothing else. A mistake
/// moves something that can be seen, and that is a group of neighbouring pixels. So it is counted how many pixels are
/// off, and how many of them hang together. There is no percentage and no average over the picture: either would let a
/// small thing, such as a missing letter, disappear in a large white page.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/image.hpp"

namespace render {

/// How far two pictures of the same thing may differ. Measured in 386 frames of 320x180 pixels and 83 of 1280x720
/// (`gjkstep render`, then `gjkstep compare`):
///  - Mesa's llvmpipe without AVX and FMA (GALLIUM_OVERRIDE_CPU_CAPS=sse2, ssse3 or sse4.1): channels differ by 1, in three
///    frames by 2. No pixel is off.
///  - Mesa 25.0 with LLVM 19 in place of Mesa 22.3 with LLVM 15: all pixels are equal.
/// What may be off beside that is room for processors that nobody has tried, far less than a letter takes: at 640x360 a
/// comma in place of a point takes 3 pixels. In small pictures, where it takes one, nothing may be off.
/// The tests of render/compare.cpp pin both sides of each number.
namespace tolerance {
inline constexpr int channel = 2;                ///< a pixel is off when one of its channels differs by more
inline constexpr std::int64_t one_in = 100'000;  ///< that part of all pixels may be off, rounded down,
inline constexpr std::int64_t group = 4;         ///< and so many of them may hang together, by an edge or a corner

/// Returns: how many pixels of a picture of that size may be off.
std::int64_t allowed(Size size);
}  // namespace tolerance

/// compare() gives the first four of two pictures; the others are about files.
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
  Size expected = {}, actual = {};
  std::int64_t off = 0, allowed = 0;             ///< pixels that are off, and that may be
  std::int64_t largest_group = 0;                ///< the most pixels that are off and hang together
  PixelBox box = {};                             ///< around all pixels that are off; invalid where off is 0
  std::array<std::int64_t, 256> histogram = {};  ///< [d]: pixels whose most different channel differs by d

  /// Returns: the largest difference of any channel.
  int largest_difference() const;
};

/// Passes where at most tolerance::allowed() pixels are off and no 8-connected group of them is larger than
/// tolerance::group. Memory: besides the pictures, a few words for each pixel of a row and for each group.
Comparison compare(const Image& expected, const Image& actual);

/// Returns: one line of plain text, such as "15 pixels are off (allowed: 8); the largest connected group is 3 pixels (allowed: 4); …".
std::string in_words(const Comparison& comparison);

inline constexpr int difference_gain = 16;

/// Returns: a picture of the differences of the channels, `difference_gain` times as large, on black.
/// Requires: pictures of the same size.
Image difference(const Image& expected, const Image& actual);

// -- PNG files, and folders of them --

enum class Sides { both, only_expected, only_actual };

/// One picture and where each side has it, or would have it.
struct FilePair {
  std::string name;  ///< relative to both folders, with / between folders
  std::filesystem::path expected, actual;
  Sides sides = Sides::both;
};

/// Returns: the names of all *.png (or *.PNG) in `folder` and below, relative to it, sorted. Links are followed. Nothing
/// that may hold pictures is left out: whatever else has such a name, a folder that cannot be read, a link that leads back
/// to a folder around it, and one that leads nowhere, which may have led to a folder, are listed, and found unreadable when
/// they are compared.
/// Errors: ReadError where `folder` itself cannot be read, or where it takes more than 1,000 links, as folders of links
/// to folders of links do.
std::vector<std::string> pictures_in(const std::filesystem::path& folder);

/// Returns: every name that either folder has, sorted. Errors: as pictures_in().
std::vector<FilePair> file_pairs(const std::filesystem::path& expected, const std::filesystem::path& actual);

/// One pair of files with what was found. `comparison` is of use where both pictures are there.
struct ComparedFiles {
  FilePair files;
  Verdict verdict = Verdict::same;
  std::string words;                      ///< one line of plain text about the verdict
  std::optional<Image> expected, actual;  ///< empty: no such file, or unreadable
  std::vector<std::string> notes = {};    ///< what is no difference, and should be known: clauses
  Comparison comparison = {};
};

/// Reads both files, as far as there are, and compares them. A file that cannot be read is the verdict `unreadable`.
ComparedFiles compare_files(const FilePair& files);

}  // namespace render
