#include "render/image.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>

namespace render {
namespace {

constexpr std::size_t channels = 3;
constexpr png_uint_32 max_side = 16384;  // a damaged header must not ask for all of the memory

// ---------------------------------------------------------------------------------------------- encoding

/// Everything that the C callbacks of libpng share with encode_png().
struct Encoder {
  std::vector<std::uint8_t> bytes;
  std::string message;
};

void append_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto& encoder = *static_cast<Encoder*>(png_get_io_ptr(png));
  try {
    encoder.bytes.insert(encoder.bytes.end(), data, data + size);
  } catch (const std::bad_alloc&) {  // must not fly through libpng
    png_error(png, "out of memory");
  }
}

void fail(png_structp png, png_const_charp message) {
  static_cast<Encoder*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit PngWriter(Encoder& encoder)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoder, fail, ignore_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {}
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
};

/// ASCII goes into tEXt, which every reader shows; anything else needs iTXt, which is UTF-8.
png_text text_chunk(const char* keyword, const std::string& text) {
  const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  png_text chunk{};
  chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  chunk.key = const_cast<char*>(keyword);  // libpng copies both
  chunk.text = const_cast<char*>(text.c_str());
  return chunk;
}

/// Returns whether libpng wrote everything. It reports errors by longjmp, which skips destructors: no object here has
/// one, nothing is changed after setjmp, and the caller owns everything.
bool run_libpng(const PngWriter& writer, const Image& image, const std::vector<png_text>& texts) {
  const png_structp png = writer.png;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.size().width),
               static_cast<png_uint_32>(image.size().height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 6);
  png_set_filter(png, PNG_FILTER_TYPE_BASE,
                 PNG_FILTER_NONE);  // flat colours compress best and fastest unfiltered
  if (!texts.empty()) png_set_text(png, writer.info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(png, writer.info);
  for (int y = 0; y < image.size().height; ++y) png_write_row(png, image.row(y));
  png_write_end(png, nullptr);
  return true;
}

// ---------------------------------------------------------------------------------------------- decoding

/// libpng's simplified reader: converts every kind of PNG, and returns errors instead of jumping.
struct PngReader {
  png_image header{};

  PngReader() { header.version = PNG_IMAGE_VERSION; }
  ~PngReader() { png_image_free(&header); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

std::uint8_t over_white(unsigned value, unsigned alpha) {
  return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
}

/// Copies straight RGBA onto white.
void flatten(const std::vector<std::uint8_t>& rgba, Image& image) {
  const std::uint8_t* from = rgba.data();
  for (int y = 0; y < image.size().height; ++y) {
    std::uint8_t* to = image.row(y);
    for (int x = 0; x < image.size().width; ++x, from += 4) {
      for (int channel = 0; channel < 3; ++channel) *to++ = over_white(from[channel], from[3]);
    }
  }
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
  std::vector<png_text> texts;
  if (!text.title.empty()) texts.push_back(text_chunk("Title", text.title));
  if (!text.description.empty()) texts.push_back(text_chunk("Description", text.description));

  Encoder encoder;
  const PngWriter writer(encoder);
  if (writer.info == nullptr) throw std::bad_alloc();
  png_set_write_fn(writer.png, &encoder, append_bytes, nullptr);
  if (!run_libpng(writer, image, texts)) {
    if (encoder.message.find("memory") != std::string::npos) throw std::bad_alloc();
    throw FileError("cannot encode a picture: libpng says: " + encoder.message);
  }
  return std::move(encoder.bytes);
}

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text) {
  write_file(path, encode_png(image, text));
}

Image read_png(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_file(path);
  PngReader reader;
  png_image& header = reader.header;
  const auto fail = [&](const std::string& why) {
    throw ReadError("cannot read " + path.string() + ": " + why + "; replace it with an undamaged PNG file");
  };
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) fail(header.message);
  if (header.width > max_side || header.height > max_side) fail("larger than 16384 pixels each way");

  header.format = PNG_FORMAT_RGBA;
  header.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16-bit files are as gamma-encoded as 8-bit ones
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, rgba.data(), 0, nullptr) == 0) fail(header.message);

  Image image({static_cast<int>(header.width), static_cast<int>(header.height)});
  flatten(rgba, image);
  return image;
}

}  // namespace render
