#include "render/image.hpp"

#include <png.h>

#include <array>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/text.hpp"
#include "tests/render/png_bytes.hpp"

using namespace render;
using namespace render::test;
using kit::bytes_of, kit::Folder;
namespace fs = std::filesystem;

namespace {

Image gradient(Size size) {
  Image image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      std::uint8_t* rgb = image.row(y) + 3 * x;
      rgb[0] = static_cast<std::uint8_t>(x * 7);
      rgb[1] = static_cast<std::uint8_t>(y * 11);
      rgb[2] = static_cast<std::uint8_t>(x * y);
    }
  }
  return image;
}

std::string error_of_reading(const fs::path& path) {
  try {
    read_png(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

std::string error_of_decoding(std::span<const std::uint8_t> png) {
  try {
    decode_png(png, "it");
  } catch (const ReadError& error) {
    return error.what();
  }
  return "";
}
std::string error_of_decoding(const std::string& png) { return error_of_decoding(bytes_of_text(png)); }

/// Returns: what begins a PNG file of 8 bits a channel; `kind`: 0 grey, 2 RGB, 3 palette, 4 and 6 with alpha.
std::string header(std::uint32_t width, std::uint32_t height, char kind) {
  return chunk("IHDR", big_endian(width) + big_endian(height) + std::string{8, kind, 0, 0, 0});
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                   static_cast<uLong>(bytes.size())) == Z_OK);
  return packed.substr(0, size);
}

/// Writes a PNG with libpng's simplified API, for formats that encode_png never uses.
void store_as(const fs::path& path, png_uint_32 format, Size size, const void* pixels, const void* colormap = nullptr,
              png_uint_32 colors = 0) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(size.width);
  header.height = static_cast<png_uint_32>(size.height);
  header.format = format;
  header.colormap_entries = colors;
  REQUIRE(png_image_write_to_file(&header, path.c_str(), 0, pixels, 0, colormap) != 0);
}

}  // namespace

TEST_CASE("what a picture is pasted into has its pixels, there alone") {
  const Image image = gradient({4, 2});
  Image other({9, 7});
  other.paste(image, 5, 1);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 9; ++x) {
      const bool is_pasted = x >= 5 && y >= 1 && y < 3;
      REQUIRE(other.pixel(x, y) == (is_pasted ? image.pixel(x - 5, y - 1) : palette::black));
    }
}

TEST_CASE("what is written is read back, whatever the size") {
  const Folder folder;
  for (const Size size : {Size{1, 1}, Size{37, 21}, Size{256, 3}}) {
    const Image image = gradient(size);
    write_file(folder / "a.png", encode_png(image, {"title", "description"}));
    REQUIRE(read_png(folder / "a.png") == image);
  }
}

TEST_CASE("a file has the texts of its picture, and no time stamp") {
  const std::vector<std::uint8_t> png = encode_png(gradient({20, 20}), {"A title", "AB×AO ⊥ AB"});
  const std::string bytes(png.begin(), png.end());
  REQUIRE_FALSE(kit::has(bytes, "tIME"));
  REQUIRE(kit::has(bytes, std::string("tEXtTitle\0A title", 17)));
  REQUIRE(kit::has(bytes, "iTXtDescription"));
  REQUIRE(kit::has(bytes, "AB×AO ⊥ AB"));
}

TEST_CASE("reading: missing, a folder, empty, not a PNG") {
  const Folder folder;
  REQUIRE(error_of_reading(folder / "a.png").find("No such file") != std::string::npos);
  REQUIRE(error_of_reading(folder / "a.png").find((folder / "a.png").string()) != std::string::npos);
  REQUIRE(error_of_reading(folder.path()).find("it is a folder") != std::string::npos);
  const fs::path path = folder / "b.png";
  for (const auto& [bytes, words] : {std::pair{std::string(), "it is empty"},
                                     {std::string(5000, 'x'), "it is not a PNG file"},
                                     {std::string("\x89PNX"), "it is not a PNG file"},
                                     {std::string("\x89PN"), "it is cut off"}}) {
    kit::write(path, bytes);
    REQUIRE(error_of_reading(path) == "cannot read " + path.string() + ": " + words +
                                          (words == std::string("it is cut off") ? ": its end is missing" : "") +
                                          "; replace it with an undamaged PNG file");
  }
}

TEST_CASE("a PNG that is cut off anywhere is told so, also where all pixels are there") {
  const std::vector<std::uint8_t> whole = encode_png(gradient({30, 30}), {"title", ""});
  for (std::size_t size = 1; size < whole.size(); ++size) {
    INFO(size << " of " << whole.size() << " bytes");
    REQUIRE(error_of_decoding(std::span(whole).first(size)) ==
            "cannot read it: it is cut off: its end is missing; replace it with an undamaged PNG file");
  }
}

TEST_CASE("a PNG in which any one byte is another is damaged") {
  std::vector<std::uint8_t> bytes = encode_png(gradient({12, 12}), {"title", "a text that no pixel needs"});
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    INFO("byte " << i);
    bytes[i] ^= 0x10;
    REQUIRE_FALSE(error_of_decoding(bytes).empty());
    bytes[i] ^= 0x10;
  }
  REQUIRE(error_of_decoding(bytes).empty());
}

TEST_CASE("whatever chunks a PNG consists of, it is read or refused with a sentence") {
  const std::string grey = header(2, 1, 0), pixels = chunk("IDAT", deflated(std::string("\0\x10\x20", 3))),
                    end = chunk("IEND", "");
  REQUIRE(error_of_decoding(png_begin + grey + pixels + end).empty());
  REQUIRE(error_of_decoding(png_begin + grey + chunk("teST", "of another program") + pixels + end).empty());
  for (const std::string& bad :
       {end, pixels + end, grey + end, grey + grey + pixels + end, grey + chunk("IDAT", "no zlib") + end,
        grey + chunk("IDAT", deflated("")) + end, grey + chunk("TEST", "must be known") + pixels + end,
        chunk("IHDR", "") + pixels + end, header(0, 1, 0) + pixels + end, header(2, 1, 7) + pixels + end,
        header(2, 1, '\xff') + pixels + end})
    REQUIRE(error_of_decoding(png_begin + bad).starts_with("cannot read it: it "));
}

TEST_CASE("a picture that is too large is told so, and is not called damaged") {
  for (const auto& [width, height] : {std::pair{16385u, 1u}, {1u, 16385u}, {2'000'000u, 2'000'000u}, {1u << 31, 1u}})
    REQUIRE(error_of_decoding(png_begin + header(width, height, 2) + chunk("IEND", "")) ==
            "cannot read it: it is " + std::to_string(width) + "x" + std::to_string(height) +
                " pixels large, and at most 16384 each way can be read; compare smaller pictures");
}

TEST_CASE("the largest pictures are written and read, and one pixel more is refused by both") {
  for (const Size size : {Size{max_image_side, 1}, Size{1, max_image_side}})
    REQUIRE(decode_png(encode_png(gradient(size), {}), "it") == gradient(size));
  for (const Size size : {Size{max_image_side + 1, 1}, Size{1, max_image_side + 1}})
    REQUIRE_THROWS_AS(encode_png(Image(size), {}), FileError);
}

TEST_CASE("a picture packed as tightly as can be is not too short for its pixels, whatever its kind of colour") {
  constexpr std::uint32_t side = 2500;  // fewer, and what is not compressed counts as well
  for (const auto& [kind, bytes] : {std::pair{0, 1u}, {2, 3u}, {4, 2u}, {6, 4u}}) {
    const std::string packed = deflated(std::string(side * (side * bytes + 1), '\0'));
    const auto with = [&, kind = kind](const std::string& data) {
      return error_of_decoding(png_begin + header(side, side, static_cast<char>(kind)) + chunk("IDAT", data) +
                               chunk("IEND", ""));
    };
    REQUIRE(with(packed) == "");
    REQUIRE(kit::has(with(packed.substr(0, packed.size() * 9 / 10)), "not enough data for its pixels"));
  }
}

TEST_CASE("grey, palette and alpha become RGB, alpha over white") {
  const Folder folder;
  const fs::path path = folder / "a.png";

  const std::array<std::uint8_t, 2> grey = {0, 200};
  store_as(path, PNG_FORMAT_GRAY, {2, 1}, grey.data());
  REQUIRE(read_png(path).pixel(1, 0) == Color{200, 200, 200});

  const std::array<std::uint8_t, 8> rgba = {255, 0, 0, 255, 0, 0, 100, 51};
  store_as(path, PNG_FORMAT_RGBA, {2, 1}, rgba.data());
  REQUIRE(read_png(path).pixel(0, 0) == Color{255, 0, 0});
  REQUIRE(read_png(path).pixel(1, 0) == Color{204, 204, 224});  // 51/255 = 1/5 of it, the rest white
  const std::array<std::uint8_t, 4> hardly_there = {127, 128, 129, 1};
  store_as(path, PNG_FORMAT_RGBA, {1, 1}, hardly_there.data());
  REQUIRE(read_png(path).pixel(0, 0) == Color{254, 255, 255});  // 254.498, 254.502 and 254.506, to nearest

  const std::array<std::uint8_t, 6> colors = {10, 20, 30, 40, 50, 60};
  const std::array<std::uint8_t, 2> indices = {1, 0};
  store_as(path, PNG_FORMAT_RGB_COLORMAP, {2, 1}, indices.data(), colors.data(), 2);
  REQUIRE(read_png(path).pixel(0, 0) == Color{40, 50, 60});
  REQUIRE(read_png(path).pixel(1, 0) == Color{10, 20, 30});
}

TEST_CASE("16 bits a channel, interlaced") {
  // Every sample is 0x8080, and no gamma is stated. The seven passes of Adam7 have so many rows of so many pixels.
  std::string rows;
  for (const auto& [count, width] : {std::pair{1, 1}, {1, 1}, {1, 2}, {2, 1}, {1, 3}, {3, 2}, {2, 5}})
    for (int i = 0; i < count; ++i)
      rows += std::string(1, '\0') + std::string(2 * static_cast<std::size_t>(width), '\x80');
  const std::string png = png_begin + chunk("IHDR", big_endian(5) + big_endian(5) + std::string{16, 0, 0, 0, 1}) +
                          chunk("IDAT", deflated(rows)) + chunk("IEND", "");
  const Image image = decode_png(bytes_of_text(png), "it");
  REQUIRE(image.size() == Size{5, 5});
  for (int i = 0; i < 25; ++i) REQUIRE(image.pixel(i % 5, i / 5) == Color{128, 128, 128});
}
