#include "render/png_chunk.hpp"

#include <zlib.h>

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
                       crc32_z(0, png.data() + 4, size + 4) == checksum};
  png = png.subspan(size + around_png_chunk);
  return first;
}

}  // namespace render
