/// Pictures as the pages of one PDF file.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/image.hpp"

namespace render {

/// In points, of which an inch has 72.
struct PaperSize {
  double width, height;
};

/// Keeps the compressed pages only. There is no date in it: same pictures, same file.
class Pdf {
 public:
  explicit Pdf(const PngText& text);
  ~Pdf();
  Pdf(const Pdf&) = delete;
  Pdf& operator=(const Pdf&) = delete;

  /// Adds a page of that size, which `image` fills, pixel by pixel and without loss. Requires: the same proportions, nearly.
  /// Errors: FileError where there is no memory for it.
  void add(const Image& image, const PaperSize& paper);

  /// Returns: the file. Call once, after the last add(). Errors: FileError where there was no memory for it.
  std::vector<std::uint8_t> finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
