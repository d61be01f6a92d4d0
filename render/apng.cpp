#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/image.hpp"
#include "render/png_chunk.hpp"

namespace render {
namespace {

void put_16(Bytes& bytes, std::uint32_t value) {
  for (const int shift : {8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// How many frames, and how often: 0 is for ever.
void put_counts(Bytes& png, std::size_t frames) {
  Bytes data;
  put_32(data, static_cast<std::uint32_t>(frames));
  put_32(data, 0);
  put_png_chunk(png, "acTL", data);
}

/// Says of the frame that follows: it fills the whole picture, replaces what was there, and how long it is shown.
void put_control(Bytes& png, std::uint32_t sequence, std::span<const std::uint8_t> size, double seconds) {
  constexpr double largest = 65535;
  const int parts = seconds * 1000 <= largest ? 1000 : 100;  // of a second
  Bytes data;
  put_32(data, sequence);
  put(data, size);
  put_32(data, 0);  // x
  put_32(data, 0);  // y
  put_16(data, static_cast<std::uint32_t>(std::lround(seconds * parts)));
  put_16(data, static_cast<std::uint32_t>(parts));
  data.insert(data.end(), {0, 0});  // dispose: leave it; blend: replace
  put_png_chunk(png, "fcTL", data);
}

}  // namespace

std::vector<std::uint8_t> encode_apng(std::size_t count,
                                      const std::function<std::vector<std::uint8_t>(std::size_t index)>& png,
                                      const std::function<double(std::size_t index)>& seconds, const PngText& text) {
  Bytes all, first_header;
  std::uint32_t sequence = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Bytes picture = png(i);
    std::span<const std::uint8_t> rest = std::span(picture).subspan(png_signature.size());
    const std::span<const std::uint8_t> header = take_png_chunk(rest)->data;
    if (i == 0) {
      first_header.assign(header.begin(), header.end());
      begin_png(all, header, text.title, text.description);
      put_counts(all, count);
    }
    if (!std::ranges::equal(header, first_header))
      throw std::invalid_argument("the pictures of an animation are all of one size and kind");
    put_control(all, sequence++, header.first(8), seconds(i));
    Bytes data;
    if (i > 0) put_32(data, sequence++);  // frames after the first one have their number in each chunk
    while (const std::optional<PngChunk> next = take_png_chunk(rest))
      if (next->type == "IDAT") put(data, next->data);
    put_png_chunk(all, i == 0 ? "IDAT" : "fdAT", data);
  }
  put_png_chunk(all, "IEND", {});
  return all;
}

}  // namespace render
