#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "render/image.hpp"
#include "render/png_chunk.hpp"

namespace render {
namespace {

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
  if (const std::string no = objection_to_size(width, height); !no.empty())
    fail_reading(name, no, "compare smaller pictures");
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

/// Whether the pixels depend on it: what readers must know, and the transparency of colours.
bool holds_pixels(std::string_view type) { return ('A' <= type[0] && type[0] <= 'Z') || type == "tRNS"; }

/// Looks at the file as a whole, before libpng decodes it, which stops where the last pixel is. A short file must not ask
/// for all of the memory: a byte of compressed data holds at most 1032 others (https://zlib.net/zlib_tech.html).
/// Returns: what it says beside its pixels.
PngPicture looked_over(std::span<const std::uint8_t> png, const std::string& name) {
  PngPicture found{Image({1, 1})};
  const std::uint64_t needed = take_header(png, name);
  std::size_t compressed = 0;
  while (const std::optional<PngChunk> chunk = take_png_chunk(png)) {
    const std::string type(chunk->type);
    if (!chunk->intact && holds_pixels(type)) fail_reading(name, "it is damaged: a checksum is wrong");
    if (!chunk->intact)
      found.warnings.push_back("the checksum of a chunk " + type + " is wrong, which holds no pixels");
    constexpr std::array of_colours{"gAMA", "cHRM", "sRGB", "iCCP", "cICP"};
    if (chunk->intact && std::ranges::count(of_colours, type) > 0)
      found.colours[type] = {chunk->data.begin(), chunk->data.end()};
    if (type == "acTL" && chunk->data.size() >= 4) found.pictures = get_32(chunk->data);
    if (type == "IDAT") compressed += chunk->data.size();
    if (type != "IEND") continue;
    if (needed / 1032 <= compressed) return found;
    fail_reading(name, "it is damaged: there is not enough data for its pixels");
  }
  fail_reading(name, "it is cut off: its end is missing");
}

/// libpng, reading from memory. Its simplified reader takes less code, but misreads interlaced pictures of 16 bits (1.6.39),
/// and does not return the samples that are stored where a file has a gamma.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> png) : rest_(png) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw std::bad_alloc();
    png_set_read_fn(png_, this, take);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Requires of this and of read(): nothing in it that would have to be destroyed where libpng jumps back to its beginning.
  /// Returns: false where that is no picture; said() tells why.
  bool begin() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_user_limits(png_, max_image_side, max_image_side);
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_gray_to_rgb(png_);
    png_set_scale_16(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  bool read(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows);
    return true;
  }

  Size size() const {
    return {static_cast<int>(png_get_image_width(png_, info_)), static_cast<int>(png_get_image_height(png_, info_))};
  }
  bool has_alpha() const { return png_get_channels(png_, info_) == 4; }
  std::size_t bytes_of_row() const { return png_get_rowbytes(png_, info_); }
  const char* said() const { return said_.data(); }

 private:
  static void take(png_structp png, png_bytep to, std::size_t count) {
    auto& rest = static_cast<Reader*>(png_get_io_ptr(png))->rest_;
    if (rest.size() < count) png_error(png, "the data ends too early");
    std::copy_n(rest.begin(), count, to);
    rest = rest.subspan(count);
  }
  [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
    std::array<char, 100>& said = static_cast<Reader*>(png_get_error_ptr(png))->said_;
    said[std::string_view(message).copy(said.data(), said.size() - 1)] = '\0';
    png_longjmp(png, 1);
  }

  std::span<const std::uint8_t> rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::array<char, 100> said_{};
};

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

PngPicture decode_png(std::span<const std::uint8_t> png, const std::string& name) {
  PngPicture picture = looked_over(png, name);
  Reader reader(png);
  const auto expect = [&](bool is_good) {
    if (!is_good) fail_reading(name, std::string("it cannot be decoded: libpng says: ") + reader.said());
  };
  expect(reader.begin());
  picture.image = Image(reader.size());
  const auto height = static_cast<std::size_t>(reader.size().height);
  std::vector<std::uint8_t> rgba(reader.has_alpha() ? reader.bytes_of_row() * height : 0);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y)
    rows[y] = reader.has_alpha() ? &rgba[y * reader.bytes_of_row()] : picture.image.row(static_cast<int>(y));
  expect(reader.read(rows.data()));
  if (reader.has_alpha()) flatten(rgba, picture.image);
  return picture;
}

PngPicture read_png(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> beginning = read_beginning(path, 1 << 16);
  std::span<const std::uint8_t> rest = beginning;
  take_header(rest, path.string());  // before more is read of what is no picture
  return decode_png(read_file(path), path.string());
}

}  // namespace render
