#include "render/png_chunk.hpp"

#include <libdeflate.h>

#include <algorithm>

namespace render {

std::uint32_t get_32(std::span<const std::uint8_t> bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

std::optional<PngChunk> take_png_chunk(std::span<const std::uint8_t>& png) {
  if (png.size() < around_png_chunk || png.size() - around_png_chunk < get_32(png)) return std::nullopt;
  const std::size_t size = get_32(png);
  const std::uint32_t checksum = get_32(png.subspan(8 + size));
  const PngChunk first{{reinterpret_cast<const char*>(png.data()) + 4, 4},
                       png.subspan(8, size),
                       libdeflate_crc32(0, png.data() + 4, size + 4) == checksum};
  png = png.subspan(size + around_png_chunk);
  return first;
}

void put(Bytes& bytes, std::span<const std::uint8_t> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }
void put(Bytes& bytes, std::string_view text) { bytes.insert(bytes.end(), text.begin(), text.end()); }
void put_32(Bytes& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void put_png_chunk(Bytes& png, std::string_view type, std::span<const std::uint8_t> data) {
  put_32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = png.size();
  put(png, type);
  put(png, data);
  put_32(png, libdeflate_crc32(0, png.data() + begin, png.size() - begin));
}

namespace {

/// ASCII as tEXt, which every reader shows; anything else as iTXt, which is UTF-8.
void put_text(Bytes& png, std::string_view keyword, std::string_view text) {
  if (text.empty()) return;
  const bool is_ascii = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  Bytes data;
  put(data, keyword);
  data.insert(data.end(), is_ascii ? 1 : 5, 0);  // of iTXt: not compressed, no language, no translated keyword
  put(data, text);
  put_png_chunk(png, is_ascii ? "tEXt" : "iTXt", data);
}

}  // namespace

void begin_png(Bytes& png, std::span<const std::uint8_t> header, std::string_view title, std::string_view description) {
  put(png, png_signature);
  put_png_chunk(png, "IHDR", header);
  put_text(png, "Title", title);
  put_text(png, "Description", description);
}

}  // namespace render
