#include "render/image.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

#include "render/png_chunk.hpp"

namespace render {
namespace {

constexpr std::size_t channels = 3;

// ---------------------------------------------------------------------------------------------- encoding

/// The pixels as PNG compresses them: rows, each behind a 0, which says that it is not filtered. Flat colours compress best and
/// fastest so.
Bytes unfiltered_rows(const Image& image) {
  const std::size_t length = channels * static_cast<std::size_t>(image.size().width);
  Bytes rows;
  rows.reserve((length + 1) * static_cast<std::size_t>(image.size().height));
  for (int y = 0; y < image.size().height; ++y) {
    rows.push_back(0);
    put(rows, {image.row(y), length});
  }
  return rows;
}

/// libdeflate takes less than half the time of zlib for the same size.
Bytes compressed(const Bytes& bytes) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(6), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  Bytes packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
  return packed;
}

}  // namespace

// ---------------------------------------------------------------------------------------------- Image

std::string objection_to_size(std::uint32_t width, std::uint32_t height) {
  if (std::max(width, height) <= std::uint32_t{max_image_side}) return "";
  return "it is " + std::to_string(width) + "x" + std::to_string(height) + " pixels large, and at most " +
         std::to_string(max_image_side) + " each way can be read";
}

Image::Image(Size size)
    : size_(size), bytes_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * channels) {}

std::uint8_t* Image::row(int y) {
  return bytes_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) * channels;
}

const std::uint8_t* Image::row(int y) const {
  return bytes_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) * channels;
}

Color Image::pixel(int x, int y) const {
  const std::uint8_t* rgb = row(y) + static_cast<std::size_t>(x) * channels;
  return {rgb[0], rgb[1], rgb[2]};
}

void Image::fill(Color color) {
  for (std::size_t i = 0; i < bytes_.size(); i += channels) {
    bytes_[i] = color.r;
    bytes_[i + 1] = color.g;
    bytes_[i + 2] = color.b;
  }
}

void Image::paste(const Image& other, int x, int y) {
  const std::size_t length = static_cast<std::size_t>(other.size_.width) * channels;
  for (int line = 0; line < other.size_.height; ++line)
    std::copy_n(other.row(line), length, row(y + line) + static_cast<std::size_t>(x) * channels);
}

std::vector<std::uint8_t> encode_png(const Image& image, const PngText& text) {
  const auto width = static_cast<std::uint32_t>(image.size().width),
             height = static_cast<std::uint32_t>(image.size().height);
  if (const std::string no = objection_to_size(width, height); !no.empty())
    throw FileError("cannot encode a picture: " + no + "; draw a smaller one");
  Bytes header;
  put_32(header, width);
  put_32(header, height);
  // Bits a sample; RGB; the only compression and kind of filters that there is; row after row.
  put(header, std::array<std::uint8_t, 5>{8, 2, 0, 0, 0});

  Bytes png;
  begin_png(png, header, text.title, text.description);
  put_png_chunk(png, "IDAT", compressed(unfiltered_rows(image)));
  put_png_chunk(png, "IEND", {});
  return png;
}

}  // namespace render
