#include "render/image.hpp"

#include <libdeflate.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>

#include "render/png_chunk.hpp"

namespace render {
namespace {

constexpr std::size_t channels = 3;

bool is_too_large(std::uint32_t width, std::uint32_t height) {
  return std::max(width, height) > std::uint32_t{max_image_side};
}

std::string too_large(std::uint32_t width, std::uint32_t height) {
  return "it is " + std::to_string(width) + "x" + std::to_string(height) + " pixels large, and at most " +
         std::to_string(max_image_side) + " each way can be read";
}

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

// ---------------------------------------------------------------------------------------------- decoding

[[noreturn]] void fail_reading(const std::string& name, const std::string& why,
                               const std::string& what_to_do = "replace it with an undamaged PNG file") {
  throw ReadError("cannot read " + name + ": " + why + "; " + what_to_do);
}

/// Returns: how many bytes the pixels take of a picture with this header, which comes first.
std::uint64_t size_of_pixels(const PngChunk& header, const std::string& name) {
  constexpr std::array<std::uint32_t, 7> samples = {1, 1, 3, 1, 2, 1, 4};  // of a pixel, by kind of colour
  if (header.type != "IHDR" || header.data.size() != 13 || !header.intact || header.data[9] >= samples.size())
    fail_reading(name, "it is damaged: its header is wrong");
  const std::uint32_t width = get_32(header.data), height = get_32(header.data.subspan(4));
  if (is_too_large(width, height)) fail_reading(name, too_large(width, height), "compare smaller pictures");
  return std::uint64_t{width} * height * header.data[8] * samples[header.data[9]] / 8;
}

/// Takes signature and header off the front of `png`. Returns: as size_of_pixels().
std::uint64_t take_header(std::span<const std::uint8_t>& png, const std::string& name) {
  if (png.empty()) fail_reading(name, "it is empty");
  const std::size_t begin = std::min(png.size(), png_signature.size());
  if (!std::ranges::equal(png.first(begin), std::span(png_signature).first(begin)))
    fail_reading(name, "it is not a PNG file");
  png = png.subspan(begin);
  const std::optional<PngChunk> header = take_png_chunk(png);
  if (!header) fail_reading(name, "it is cut off: its end is missing");
  return size_of_pixels(*header, name);
}

/// Looks at the file as a whole, before libpng decodes it, which stops where the last pixel is. A short file must not ask
/// for all of the memory: a byte of compressed data holds at most 1032 others (https://zlib.net/zlib_tech.html).
void expect_whole(std::span<const std::uint8_t> png, const std::string& name) {
  const std::uint64_t needed = take_header(png, name);
  std::size_t compressed = 0;
  while (const std::optional<PngChunk> chunk = take_png_chunk(png)) {
    if (!chunk->intact) fail_reading(name, "it is damaged: a checksum is wrong");
    if (chunk->type == "IDAT") compressed += chunk->data.size();
    if (chunk->type != "IEND") continue;
    if (needed / 1032 <= compressed) return;
    fail_reading(name, "it is damaged: there is not enough data for its pixels");
  }
  fail_reading(name, "it is cut off: its end is missing");
}

/// Copies straight RGBA onto white.
void flatten(const std::vector<std::uint8_t>& rgba, Image& image) {
  const auto over_white = [](unsigned value, unsigned alpha) {
    return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
  };
  std::uint8_t* to = image.row(0);
  for (auto from = rgba.begin(); from != rgba.end(); from += 4)
    for (int channel = 0; channel < 3; ++channel) *to++ = over_white(from[channel], from[3]);
}

}  // namespace

// ---------------------------------------------------------------------------------------------- Image

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
  if (is_too_large(width, height))
    throw FileError("cannot encode a picture: " + too_large(width, height) + "; draw a smaller one");
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

Image decode_png(std::span<const std::uint8_t> png, const std::string& name) {
  expect_whole(png, name);
  // libpng's simplified reader converts every kind of PNG, and returns errors instead of jumping.
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&header, png_image_free);
  const auto damaged = [&] { fail_reading(name, std::string("it cannot be decoded: libpng says: ") + header.message); };
  if (png_image_begin_read_from_memory(&header, png.data(), png.size()) == 0) damaged();

  Image image({static_cast<int>(header.width), static_cast<int>(header.height)});
  const bool transparent = (header.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  header.format = transparent ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  header.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16-bit files are as gamma-encoded as 8-bit ones
  std::vector<std::uint8_t> rgba(transparent ? PNG_IMAGE_SIZE(header) : 0);
  if (png_image_finish_read(&header, nullptr, transparent ? rgba.data() : image.row(0), 0, nullptr) == 0) damaged();
  if (transparent) flatten(rgba, image);
  return image;
}

Image read_png(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> beginning = read_beginning(path, 1 << 16);
  std::span<const std::uint8_t> rest = beginning;
  take_header(rest, path.string());  // before more is read of what is no picture
  return decode_png(read_file(path), path.string());
}

}  // namespace render
