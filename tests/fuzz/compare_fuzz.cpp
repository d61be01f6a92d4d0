/// Whatever two PNG files hold: each is read or turned away with a sentence, and what is said of the pair agrees with what a
/// slower and simpler look at the pixels finds. The input: two bytes that say how long the first file is, and both files.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz compare-fuzz
///     mkdir -p build/fuzz/found-pairs
///     build/fuzz/compare-fuzz -max_len=4096 -timeout=10 -rss_limit_mb=512 build/fuzz/found-pairs tests/fuzz/pairs
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "render/compare_report.hpp"
#include "render/png_chunk.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace render;
using Bytes = std::vector<std::uint8_t>;
using View = std::span<const std::uint8_t>;

constexpr std::int64_t few_pixels = 1 << 12, many_pixels = 1 << 16;

void require(bool holds) {
  if (!holds) std::abort();
}

struct Pair {
  View expected, actual;
};

Pair split(View input) {
  if (input.size() < 2) return {};
  const std::size_t first = std::min(std::size_t{input[0]} << 8 | input[1], input.size() - 2);
  return {input.subspan(2, first), input.subspan(2 + first)};
}

Bytes joined(View expected, View actual) {
  Bytes input = {static_cast<std::uint8_t>(expected.size() >> 8), static_cast<std::uint8_t>(expected.size())};
  input.insert(input.end(), expected.begin(), expected.end());
  input.insert(input.end(), actual.begin(), actual.end());
  return input;
}

std::int64_t pixels_of(const Image& image) { return std::int64_t{image.size().width} * image.size().height; }

std::optional<Image> decoded(View png) {
  try {
    return decode_png(png, "it").image;
  } catch (const ReadError& error) {
    const std::string_view said = error.what();
    require(said.starts_with("cannot read it: it ") && said.find(';') != said.npos && said.find("png_") == said.npos);
    return std::nullopt;
  }
}

// ------------------------------------------------------------------------------------------- what is said of a pair

/// Pixels that are off.
struct Off {
  Size size;
  std::vector<char> at;

  Off(const Image& expected, const Image& actual, int most) : size(expected.size()) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const Color e = expected.pixel(x, y), a = actual.pixel(x, y);
        at.push_back(std::abs(e.r - a.r) > most || std::abs(e.g - a.g) > most || std::abs(e.b - a.b) > most);
      }
  }
  /// Takes the group around (x,y) away. Returns: its size.
  std::int64_t take_group(int x, int y) {
    std::int64_t count = 0;
    std::vector<std::pair<int, int>> open = {{x, y}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (i < 0 || j < 0 || i >= size.width || j >= size.height) continue;
      char& off = at[static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i)];
      if (!std::exchange(off, false)) continue;
      ++count;
      for (const int dy : {-1, 0, 1})
        for (const int dx : {-1, 0, 1}) open.emplace_back(i + dx, j + dy);
    }
    return count;
  }
};

void require_counts(const Image& expected, const Image& actual, const Comparison& found) {
  Off off(expected, actual, tolerance::channel);
  require(std::ranges::count(off.at, true) == found.off);
  std::int64_t largest = 0;
  for (int y = 0; y < off.size.height; ++y)
    for (int x = 0; x < off.size.width; ++x) largest = std::max(largest, off.take_group(x, y));
  require(largest == found.largest_group);
}

void require_page(const ComparedFiles& pair) {
  CompareReport report({.expected = "expected", .actual = "actual"});
  report.add(pair, "cp");
  require(report.html().ends_with("</html>\n"));
  require(decoded(encode_png(*pair.expected, {})) == pair.expected);
}

void require_sense(const ComparedFiles& pair) {
  const Image &expected = *pair.expected, &actual = *pair.actual;
  const Comparison& found = pair.comparison;
  require(!pair.words.empty() && compare(expected, expected).verdict == Verdict::same);
  require((found.verdict == Verdict::same) == (expected == actual));
  require((found.verdict == Verdict::other_size) == (expected.size() != actual.size()));
  require(compare(actual, expected).verdict == found.verdict);
  if (found.verdict == Verdict::other_size) return;
  require(found.off < pixels_of(expected) || found.verdict == Verdict::different);
  if (pixels_of(expected) <= few_pixels) require_counts(expected, actual, found);
}

// --------------------------------------------------------------------------------------------- how inputs are changed

/// Makes the checksums right, as far as there are chunks: a wrong one would be all that is ever found.
void mend_checksums(std::span<std::uint8_t> png) {
  if (png.size() < png_signature.size()) return;
  View rest = View(png).subspan(png_signature.size());
  for (View before = rest; take_png_chunk(rest); before = rest) {
    std::uint8_t* const chunk = png.data() + (before.data() - png.data());
    const std::size_t size = before.size() - rest.size();
    const auto sum = static_cast<std::uint32_t>(crc32_z(0, chunk + 4, size - 8));
    for (const int byte : {0, 1, 2, 3})
      chunk[size - 4 + static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(sum >> (24 - 8 * byte));
  }
}

/// Returns: the same pair with other pixels on the actual side; nothing where there are none.
std::optional<Bytes> with_other_pixels(const Pair& pair) {
  std::optional<Image> image = decoded(pair.actual);
  if (!image || pixels_of(*image) > few_pixels) return std::nullopt;
  const auto size = static_cast<std::size_t>(3 * pixels_of(*image));
  LLVMFuzzerMutate(image->row(0), size, size);
  return joined(pair.expected, encode_png(*image, {}));
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (seed % 2 == 0)
    if (const auto changed = with_other_pixels(split({data, size})); changed && changed->size() <= most) {
      std::ranges::copy(*changed, data);
      return changed->size();
    }
  size = LLVMFuzzerMutate(data, size, most);
  const Pair pair = split({data, size});
  for (const View png : {pair.expected, pair.actual})
    if (!png.empty()) mend_checksums({data + (png.data() - data), png.size()});
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Pair input = split({data, size});
  ComparedFiles pair{
      .files = {"it.png", "expected/it.png", "actual/it.png"}, .words = {}, .expected = {}, .actual = {}};
  pair.expected = decoded(input.expected);
  if (!pair.expected || pixels_of(*pair.expected) > many_pixels) return 0;
  pair.actual = decoded(input.actual);
  if (!pair.actual) return 0;
  pair.comparison = compare(*pair.expected, *pair.actual);
  pair.verdict = pair.comparison.verdict;
  pair.words = in_words(pair.comparison);
  require_sense(pair);
  if (std::max(pixels_of(*pair.expected), pixels_of(*pair.actual)) <= few_pixels) require_page(pair);
  return 0;
}
