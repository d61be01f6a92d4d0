#include "render/image.hpp"

#include <libdeflate.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <system_error>
#include <variant>

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

/// What is wrong with a PNG, and what to do about it.
struct Fault {
  std::string what;
  const char* what_to_do = "replace it with an undamaged PNG file";
};

/// The chunk that comes first: how large the picture is, and how many bits a pixel takes.
struct Header {
  std::uint32_t width, height, bits;
};

std::optional<Header> header_of(const PngChunk& chunk) {
  if (chunk.type != "IHDR" || chunk.data.size() != 13 || !chunk.intact) return std::nullopt;
  constexpr std::array<std::uint32_t, 7> samples = {1, 1, 3, 1, 2, 1, 4};  // of a pixel, by kind of colour
  const std::uint8_t depth = chunk.data[8], kind = chunk.data[9];
  if (kind >= samples.size()) return std::nullopt;
  return Header{get_32(chunk.data), get_32(chunk.data.subspan(4)), depth * samples[kind]};
}

/// `rest`: the chunks after the header. A short file must not ask for all of the memory: a byte of compressed data holds
/// at most 1032 others (https://zlib.net/zlib_tech.html).
std::optional<Fault> fault_after(const Header& header, std::span<const std::uint8_t> rest) {
  std::size_t compressed = 0;
  while (const std::optional<PngChunk> chunk = take_png_chunk(rest)) {
    if (!chunk->intact) return Fault{"it is damaged: a checksum is wrong"};
    if (chunk->type == "IDAT") compressed += chunk->data.size();
    if (chunk->type != "IEND") continue;
    if (std::uint64_t{header.width} * header.height * header.bits / 8 / 1032 <= compressed) return std::nullopt;
    return Fault{"it is damaged: there is not enough data for its pixels"};
  }
  return Fault{"it is cut off: its end is missing"};
}

/// Takes the signature and the header off the front of `png`. Returns: the header, or what is wrong with either.
std::variant<Header, Fault> take_header(std::span<const std::uint8_t>& png) {
  if (png.empty()) return Fault{"it is empty"};
  const std::size_t begin = std::min(png.size(), png_signature.size());
  if (!std::ranges::equal(png.first(begin), std::span(png_signature).first(begin)))
    return Fault{"it is not a PNG file"};
  png = png.subspan(begin);
  const std::optional<PngChunk> first = take_png_chunk(png);
  if (!first) return Fault{"it is cut off: its end is missing"};
  const std::optional<Header> header = header_of(*first);
  if (!header) return Fault{"it is damaged: its header is wrong"};
  if (is_too_large(header->width, header->height))
    return Fault{too_large(header->width, header->height), "compare smaller pictures"};
  return *header;
}

/// Looks at the file as a whole, before libpng decodes it, which stops where the last pixel is.
std::optional<Fault> fault_of(std::span<const std::uint8_t> png) {
  const std::variant<Header, Fault> first = take_header(png);
  if (const Fault* fault = std::get_if<Fault>(&first)) return *fault;
  return fault_after(std::get<Header>(first), png);
}

[[noreturn]] void fail_reading(const std::string& name, const Fault& fault) {
  throw ReadError("cannot read " + name + ": " + fault.what + "; " + fault.what_to_do);
}

/// Returns: how many pictures an animation says that it has, ahead of the first; 1 where it is none.
std::uint32_t pictures_in(std::span<const std::uint8_t> after_header) {
  while (const std::optional<PngChunk> chunk = take_png_chunk(after_header)) {
    if (chunk->type == "acTL" && chunk->data.size() == 8) return std::max(get_32(chunk->data), 1u);
    if (chunk->type == "IDAT") break;
  }
  return 1;
}

/// Returns: what a file of so many such pictures may need: its pixels twice, which even many small chunks of data that cannot
/// be compressed do not take, four bytes a row for filters and for what interlacing adds, and notes such as colour profiles.
std::uintmax_t most_bytes(const Header& header, std::uint32_t pictures) {
  constexpr std::uintmax_t notes = std::uintmax_t{64} << 20;
  const std::uintmax_t row = std::uintmax_t{header.width} * header.bits / 8 + 4;
  const std::uintmax_t picture = std::max<std::uintmax_t>(2 * row * header.height, 1);
  const std::uintmax_t enough = max_file_bytes / picture + 1;  // pictures, to stay within the range
  return std::min(max_file_bytes, picture * std::min<std::uintmax_t>(pictures, enough) + notes);
}

/// Looks at the beginning of the file only. Returns: how many bytes it may have. Errors: ReadError where it has more.
std::uintmax_t most_bytes_of(const std::filesystem::path& path) {
  constexpr std::size_t beginning = 1 << 16;
  const std::vector<std::uint8_t> bytes = read_beginning(path, beginning);
  std::span<const std::uint8_t> rest = bytes;
  const std::variant<Header, Fault> first = take_header(rest);
  if (const Fault* fault = std::get_if<Fault>(&first)) fail_reading(path.string(), *fault);
  const Header& header = std::get<Header>(first);
  const std::uintmax_t most = most_bytes(header, pictures_in(rest));
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  if (!unknown && size > most)
    fail_reading(path.string(),
                 {"it has " + std::to_string(size >> 20) + " MiB, and its " + std::to_string(header.width) + "x" +
                  std::to_string(header.height) + " pixels need " + std::to_string(most >> 20) + " MiB at most"});
  return most;
}

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

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text) {
  write_file(path, encode_png(image, text));
}

Image decode_png(std::span<const std::uint8_t> png, const std::string& name) {
  if (const std::optional<Fault> fault = fault_of(png)) fail_reading(name, *fault);
  PngReader reader;
  png_image& header = reader.header;
  const auto damaged = [&] {
    fail_reading(name, {std::string("it cannot be decoded: libpng says: ") + header.message});
  };
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
  return decode_png(read_file(path, most_bytes_of(path)), path.string());
}

}  // namespace render
