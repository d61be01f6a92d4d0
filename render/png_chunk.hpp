/// What a PNG file consists of: a signature, and chunks up to an end chunk.
/// https://www.w3.org/TR/png-3/
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace render {

inline constexpr std::array<std::uint8_t, 8> png_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
inline constexpr std::size_t around_png_chunk = 12;  ///< bytes: length, type and checksum

/// Requires: four bytes. Returns: their number; PNG keeps the most significant byte first.
std::uint32_t get_32(std::span<const std::uint8_t> bytes);

/// Views of the file's bytes.
struct PngChunk {
  std::string_view type;
  std::span<const std::uint8_t> data;
  bool intact;  ///< whether the checksum is right
};

/// Takes the first chunk off the front of `png`, a file after its signature.
/// Returns: nothing where `png` ends before the chunk does.
std::optional<PngChunk> take_png_chunk(std::span<const std::uint8_t>& png);

using Bytes = std::vector<std::uint8_t>;

void put(Bytes& bytes, std::span<const std::uint8_t> more);
void put(Bytes& bytes, std::string_view text);
void put_32(Bytes& bytes, std::uint32_t value);

/// Appends a chunk: length, type, data, and the checksum of type and data.
void put_png_chunk(Bytes& png, std::string_view type, std::span<const std::uint8_t> data);

/// Appends what comes first: signature, header and texts, which are not stored where they are empty.
void begin_png(Bytes& png, std::span<const std::uint8_t> header, std::string_view title, std::string_view description);

}  // namespace render
