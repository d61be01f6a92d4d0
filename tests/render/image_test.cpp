#include "render/image.hpp"

#include <png.h>

#include <array>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/text.hpp"
#include "tests/render/png_bytes.hpp"

namespace image_test {

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
    REQUIRE(read_png(folder / "a.png").image == image);
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

TEST_CASE("a PNG in which any one byte is another is damaged, or warns of a text that no pixel needs") {
  std::vector<std::uint8_t> bytes = encode_png(gradient({12, 12}), {"title", "a text that no pixel needs"});
  int warned = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    INFO("byte " << i);
    bytes[i] ^= 0x10;
    if (error_of_decoding(bytes).empty()) {
      ++warned;
      const PngPicture read = decode_png(bytes, "it");
      REQUIRE(read.warnings.size() == 1);
      REQUIRE(read.image == gradient({12, 12}));
    }
    bytes[i] ^= 0x10;
  }
  REQUIRE(warned >= 31);  // the letters of the texts
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
    REQUIRE(decode_png(encode_png(gradient(size), {}), "it").image == gradient(size));
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
  REQUIRE(read_png(path).image.pixel(1, 0) == Color{200, 200, 200});

  const std::array<std::uint8_t, 8> rgba = {255, 0, 0, 255, 0, 0, 100, 51};
  store_as(path, PNG_FORMAT_RGBA, {2, 1}, rgba.data());
  REQUIRE(read_png(path).image.pixel(0, 0) == Color{255, 0, 0});
  REQUIRE(read_png(path).image.pixel(1, 0) == Color{204, 204, 224});  // 51/255 = 1/5 of it, the rest white
  const std::array<std::uint8_t, 4> hardly_there = {127, 128, 129, 1};
  store_as(path, PNG_FORMAT_RGBA, {1, 1}, hardly_there.data());
  REQUIRE(read_png(path).image.pixel(0, 0) == Color{254, 255, 255});  // 254.498, 254.502 and 254.506, to nearest

  const std::array<std::uint8_t, 6> colors = {10, 20, 30, 40, 50, 60};
  const std::array<std::uint8_t, 2> indices = {1, 0};
  store_as(path, PNG_FORMAT_RGB_COLORMAP, {2, 1}, indices.data(), colors.data(), 2);
  REQUIRE(read_png(path).image.pixel(0, 0) == Color{40, 50, 60});
  REQUIRE(read_png(path).image.pixel(1, 0) == Color{10, 20, 30});
}

namespace {

/// A picture of 16 bits a sample whose every row, column and channel differs.
struct Deep {
  char kind;                                  ///< 0 grey, 2 RGB, 4 and 6 with alpha
  std::array<int, 3> changed = {-1, -1, -1};  ///< x, y and channel of a sample that is another

  static constexpr int side = 11;
  int channels() const { return kind == 0 ? 1 : kind == 2 ? 3 : kind == 4 ? 2 : 4; }
  unsigned sample(int x, int y, int channel) const {
    const unsigned usual =
        (static_cast<unsigned>(x) * 5003 + static_cast<unsigned>(y) * 1511 + static_cast<unsigned>(channel) * 9001) %
        65536;
    return changed == std::array{x, y, channel} ? (usual + 20000) % 65536 : usual;
  }
  std::string png(bool is_interlaced) const {
    struct Pass {
      int x, y, right, down;
    };
    const std::vector<Pass> adam7{{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                  {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    std::string rows;
    for (const Pass& pass : is_interlaced ? adam7 : std::vector<Pass>{{0, 0, 1, 1}})
      for (int y = pass.y; y < side; y += pass.down) {
        std::string row;
        for (int x = pass.x; x < side; x += pass.right)
          for (int c = 0; c < channels(); ++c) row += big_endian(sample(x, y, c)).substr(2);
        if (!row.empty()) rows += std::string(1, '\0') + row;
      }
    return png_begin +
           chunk("IHDR",
                 big_endian(side) + big_endian(side) + std::string{16, kind, 0, 0, is_interlaced ? '\1' : '\0'}) +
           chunk("IDAT", deflated(rows)) + chunk("IEND", "");
  }
  Color pixel(int x, int y) const {
    const bool is_grey = kind == 0 || kind == 4, has_alpha = kind >= 4;
    const auto eighth = [&](int c) { return static_cast<int>((sample(x, y, c) * 255 + 32895) >> 16); };
    const auto shown = [&](int c) {
      const int value = eighth(is_grey ? 0 : c), alpha = has_alpha ? eighth(channels() - 1) : 255;
      return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
    };
    return {shown(0), shown(1), shown(2)};
  }
};

}  // namespace

TEST_CASE("16 bits a sample of every kind of colour are read alike, interlaced or not, and each sample counts") {
  for (const char kind : {'\0', '\2', '\4', '\6'}) {
    INFO("kind " << static_cast<int>(kind));
    const Deep picture{kind};
    const Image plain = decode_png(bytes_of_text(picture.png(false)), "it").image;
    REQUIRE(decode_png(bytes_of_text(picture.png(true)), "it").image == plain);
    for (int y = 0; y < Deep::side; ++y)
      for (int x = 0; x < Deep::side; ++x) REQUIRE(plain.pixel(x, y) == picture.pixel(x, y));
    for (int y = 0; y < Deep::side; ++y)
      for (int channel = 0; channel < picture.channels(); ++channel) {
        const Deep other{kind, {y, y, channel}};
        for (const bool is_interlaced : {false, true})
          REQUIRE(decode_png(bytes_of_text(other.png(is_interlaced)), "it").image != plain);
      }
  }
}

TEST_CASE("A wrong checksum where no pixels are is a warning, where pixels depend on it the file is damaged") {
  const auto spoilt = [](std::string bytes) {
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    return bytes;
  };
  const std::string begin = png_begin + header(1, 1, 3), palette = chunk("PLTE", "abc"),
                    end = chunk("IDAT", deflated(std::string(2, '\0'))) + chunk("IEND", "");
  const PngPicture read = decode_png(
      bytes_of_text(begin + palette + spoilt(chunk("tEXt", "a")) + spoilt(chunk("gAMA", "0000")) + end), "it");
  CHECK(read.image.pixel(0, 0) == Color{'a', 'b', 'c'});
  REQUIRE(read.warnings.size() == 2);
  CHECK(read.warnings[0] == "the checksum of a chunk tEXt is wrong, which holds no pixels");
  CHECK(read.colours.empty());
  CHECK(error_of_decoding(begin + palette + spoilt(chunk("tRNS", "a")) + end) ==
        "cannot read it: it is damaged: a checksum is wrong; replace it with an undamaged PNG file");
  CHECK(kit::has(error_of_decoding(begin + spoilt(palette) + end), "a checksum is wrong"));
}

TEST_CASE("Samples are read as they are stored, whatever gamma a file tells, and that is told") {
  const std::string begin = png_begin + header(1, 1, 0), gamma = chunk("gAMA", big_endian(100000)),
                    end = chunk("IDAT", deflated(std::string("\0\x64", 2))) + chunk("IEND", "");
  CHECK(decode_png(bytes_of_text(begin + end), "it").image.pixel(0, 0) == Color{100, 100, 100});
  const PngPicture read = decode_png(bytes_of_text(begin + gamma + end), "it");
  CHECK(read.image.pixel(0, 0) == Color{100, 100, 100});
  CHECK(read.colours.at("gAMA") == big_endian(100000));
}

}  // namespace image_test
