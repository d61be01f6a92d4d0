/// Animated PNG: pictures of one size, each with the time for which it is shown.
///
/// A viewer that knows nothing of animation shows the first picture. The format is that of the PNG specification, third
/// edition: https://www.w3.org/TR/png-3/
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/image.hpp"

namespace render {

/// Keeps the compressed pictures only. After every add() it is a whole file.
class Animation {
 public:
  explicit Animation(PngText text) : text_(std::move(text)) {}

  /// Adds a picture at the end, shown for `seconds`, rounded to milliseconds (above a minute: to hundredths).
  /// Requires: `png` is what encode_png() returned; 0 <= seconds <= 600.
  /// Errors: std::invalid_argument where its size is not that of the first picture.
  void add(std::span<const std::uint8_t> png, double seconds);

  std::size_t frames() const { return frames_; }
  /// Returns: the file: runs through the pictures for ever. Empty before the first add().
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  void begin(std::span<const std::uint8_t> header);

  PngText text_;
  std::vector<std::uint8_t> bytes_;
  std::size_t frames_ = 0, counts_at_ = 0;  // where the chunk that counts the frames begins
  std::uint32_t sequence_ = 0;
};

}  // namespace render
