#include "render/apng.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "render/png_chunk.hpp"

namespace render {
namespace {

using View = std::span<const std::uint8_t>;

constexpr std::size_t end_size = around_png_chunk;

void put_16(Bytes& bytes, std::uint32_t value) {
  for (const int shift : {8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

Bytes chunk(std::string_view type, View data) {
  Bytes bytes;
  put_png_chunk(bytes, type, data);
  return bytes;
}

/// How many frames, and how often: 0 is for ever.
Bytes counts_chunk(std::size_t frames) {
  Bytes data;
  put_32(data, static_cast<std::uint32_t>(frames));
  put_32(data, 0);
  return chunk("acTL", data);
}

/// Says of the frame that follows: it fills the whole picture, replaces what was there, and how long it is shown.
Bytes control_chunk(std::uint32_t sequence, View size, double seconds) {
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
  return chunk("fcTL", data);
}

}  // namespace

void Animation::begin(View header) {
  put(bytes_, png_signature);
  put(bytes_, chunk("IHDR", header));
  put_png_text(bytes_, "Title", text_.title);
  put_png_text(bytes_, "Description", text_.description);
  counts_at_ = bytes_.size();
  put(bytes_, counts_chunk(0));
  put(bytes_, chunk("IEND", {}));
}

void Animation::add(View png, double seconds) {
  View rest = png.subspan(png_signature.size());
  const View header = take_png_chunk(rest)->data;
  if (bytes_.empty()) begin(header);
  const View first_header = View(bytes_).subspan(png_signature.size() + 8, header.size());
  if (!std::ranges::equal(header, first_header))
    throw std::invalid_argument("the pictures of an animation are all of one size and kind");

  bytes_.resize(bytes_.size() - end_size);
  put(bytes_, control_chunk(sequence_++, header.first(8), seconds));
  Bytes data;
  if (frames_ > 0) put_32(data, sequence_++);  // frames after the first one have their number in each chunk
  while (const std::optional<PngChunk> next = take_png_chunk(rest))
    if (next->type == "IDAT") put(data, next->data);
  put(bytes_, chunk(frames_ == 0 ? "IDAT" : "fdAT", data));
  put(bytes_, chunk("IEND", {}));
  std::ranges::copy(counts_chunk(++frames_), bytes_.begin() + static_cast<std::ptrdiff_t>(counts_at_));
}

}  // namespace render
