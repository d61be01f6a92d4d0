#include "render/image.hpp"

#include <png.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"

using namespace render;
namespace fs = std::filesystem;

namespace {

/// An empty folder that goes with everything in it.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("gjkstep-image-test-" + std::to_string(getpid()));

  Folder() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  auto entries() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

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

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void store(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
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

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(value >> shift));
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string checked = type + data;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + checked + big_endian(static_cast<std::uint32_t>(sum));
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                   static_cast<uLong>(bytes.size())) == Z_OK);
  return packed.substr(0, size);
}

/// Writes a PNG with libpng's simplified API, for formats that write_png never uses.
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

TEST_CASE("a new image is black and rows run from the top") {
  Image image({3, 2});
  REQUIRE(image.pixel(2, 1) == palette::black);
  image.row(1)[3] = 200;
  REQUIRE(image.pixel(1, 1) == Color{200, 0, 0});
  REQUIRE(image.pixel(1, 0) == palette::black);
  REQUIRE(image.row(1) - image.row(0) == 9);
}

TEST_CASE("what is written is read back, whatever the size") {
  const Folder folder;
  for (const Size size : {Size{1, 1}, Size{37, 21}, Size{256, 3}}) {
    const Image image = gradient(size);
    write_png(folder.path / "a.png", image, {"title", "description"});
    REQUIRE(read_png(folder.path / "a.png") == image);
  }
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("the same picture gives the same file, without a time stamp and with its texts") {
  const Folder folder;
  write_png(folder.path / "a.png", gradient({20, 20}), {"A title", "AB×AO ⊥ AB"});
  write_png(folder.path / "b.png", gradient({20, 20}), {"A title", "AB×AO ⊥ AB"});
  const std::string bytes = bytes_of(folder.path / "a.png");
  REQUIRE(bytes == bytes_of(folder.path / "b.png"));
  REQUIRE(bytes.find("tIME") == std::string::npos);
  REQUIRE(bytes.find(std::string("tEXtTitle\0A title", 17)) != std::string::npos);
  REQUIRE(bytes.find("iTXtDescription") != std::string::npos);
  REQUIRE(bytes.find("AB×AO ⊥ AB") != std::string::npos);
}

TEST_CASE("a file that cannot be written is reported and nothing is left behind") {
  const Folder folder;
  const Image image({2, 2});
  REQUIRE_THROWS_AS(write_png(folder.path / "no folder" / "a.png", image, {}), FileError);
  REQUIRE(folder.entries() == 0);

  fs::create_directories(folder.path / "a.png" / "full");  // cannot be replaced by a file
  try {
    write_png(folder.path / "a.png", image, {});
    FAIL("no error");
  } catch (const FileError& error) {
    REQUIRE(std::string(error.what()).find((folder.path / "a.png").string()) != std::string::npos);
    REQUIRE(std::string(error.what()).find("check that") != std::string::npos);
  }
  REQUIRE(folder.entries() == 1);
  REQUIRE(fs::is_directory(folder.path / "a.png"));
}

namespace {

/// While it lives, a file of this process can have no more than so many bytes.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_before_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  void (*signal_before_)(int) = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before_{};
};

}  // namespace

TEST_CASE("a disk that is full before the picture is whole is reported") {
  const Folder folder;
  const fs::path target = folder.path / "a.png";
  store(target, "the old file");
  {
    const SmallFiles limit(100);
    REQUIRE_THROWS_AS(write_png(target, gradient({64, 64}), {}), FileError);
  }
  REQUIRE(bytes_of(target) == "the old file");
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("an existing file is replaced") {
  const Folder folder;
  store(folder.path / "a.png", "the old file");
  write_png(folder.path / "a.png", gradient({4, 4}), {});
  REQUIRE(read_png(folder.path / "a.png") == gradient({4, 4}));
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("reading: missing, a folder, empty, not a PNG") {
  const Folder folder;
  REQUIRE(error_of_reading(folder.path / "a.png").find("No such file") != std::string::npos);
  REQUIRE(error_of_reading(folder.path / "a.png").find((folder.path / "a.png").string()) != std::string::npos);
  REQUIRE(error_of_reading(folder.path).find("it is a folder") != std::string::npos);
  const fs::path path = folder.path / "b.png";
  for (const auto& [bytes, words] : {std::pair{std::string(), "it is empty"},
                                     {std::string(5000, 'x'), "it is not a PNG file"},
                                     {std::string("\x89PNX"), "it is not a PNG file"},
                                     {std::string("\x89PN"), "it is cut off"}}) {
    store(path, bytes);
    REQUIRE(error_of_reading(path) == "cannot read " + path.string() + ": " + words +
                                          (words == std::string("it is cut off") ? ": its end is missing" : "") +
                                          "; replace it with an undamaged PNG file");
  }
}

TEST_CASE("reading: a file larger than its pixels can need is refused without being read, an animation has more") {
  const Folder folder;
  const fs::path path = folder.path / "a.png";
  const auto stored = [&](const std::string& bytes, std::uintmax_t size) {
    store(path, bytes);
    fs::resize_file(path, size);  // with a hole, which takes no room
    return error_of_reading(path);
  };
  const std::uintmax_t mebi = 1 << 20;
  write_png(path, gradient({30, 20}), {});
  const std::string whole = bytes_of(path), header = whole.substr(0, 33), rest = whole.substr(33);
  REQUIRE(stored(whole, 60 * mebi).empty());
  REQUIRE(stored(whole, 1000 * mebi) == "cannot read " + path.string() +
                                            ": it has 1000 MiB, and its 30x20 pixels need 64 MiB at most; replace it "
                                            "with an undamaged PNG file");
  const auto animated = [&](std::uint32_t pictures) {
    return header + chunk("acTL", big_endian(pictures) + big_endian(0)) + rest;
  };
  REQUIRE(stored(animated(1), 80 * mebi).find("need 64 MiB at most") != std::string::npos);
  REQUIRE(stored(animated(10'000), 80 * mebi).empty());
  REQUIRE(stored("no picture", 1000 * mebi).find("it is not a PNG file") != std::string::npos);
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

TEST_CASE("what comes after the end of a PNG is no part of it") {
  const Folder folder;
  const fs::path path = folder.path / "a.png";
  write_png(path, gradient({30, 30}), {});
  store(path, bytes_of(path) + "more");
  REQUIRE(read_png(path) == gradient({30, 30}));
}

TEST_CASE("whatever chunks a PNG consists of, it is read or refused with a sentence") {
  const std::string header = chunk("IHDR", big_endian(2) + big_endian(1) + std::string("\x08\x00\x00\x00\x00", 5)),
                    pixels = chunk("IDAT", deflated(std::string("\0\x10\x20", 3))), end = chunk("IEND", ""),
                    begin = "\x89PNG\r\n\x1a\n";
  const auto read = [&](const std::string& chunks) {
    const std::string bytes = begin + chunks;
    return error_of_decoding({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  };
  REQUIRE(read(header + pixels + end).empty());
  REQUIRE(read(header + chunk("teST", "of another program") + pixels + end).empty());
  for (const std::string& bad :
       {end, pixels + end, header + end, header + header + pixels + end, header + chunk("IDAT", "no zlib") + end,
        header + chunk("IDAT", deflated("")) + end, header + chunk("TEST", "must be known") + pixels + end,
        chunk("IHDR", "") + pixels + end,
        chunk("IHDR", big_endian(0) + big_endian(1) + std::string("\x08\x00\x00\x00\x00", 5)) + pixels + end,
        chunk("IHDR", big_endian(2) + big_endian(1) + std::string("\x08\x07\x00\x00\x00", 5)) + pixels + end,
        chunk("IHDR", big_endian(2) + big_endian(1) + std::string("\x08\xff\x00\x00\x00", 5)) + pixels + end})
    REQUIRE(read(bad).starts_with("cannot read it: it "));
}

TEST_CASE("a picture that is too large is told so, and is not called damaged") {
  const Folder folder;
  for (const auto& [width, height] : {std::pair{16385u, 1u}, {1u, 16385u}, {2'000'000u, 2'000'000u}, {1u << 31, 1u}}) {
    const std::string header = big_endian(width) + big_endian(height) + std::string("\x08\x02\x00\x00\x00", 5);
    store(folder.path / "a.png", "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IEND", ""));
    REQUIRE(error_of_reading(folder.path / "a.png") ==
            "cannot read " + (folder.path / "a.png").string() + ": it is " + std::to_string(width) + "x" +
                std::to_string(height) +
                " pixels large, and at most 16384 each way can be read; compare smaller pictures");
  }
}

TEST_CASE("the largest pictures are written and read, and one pixel more is refused by both") {
  for (const Size size : {Size{max_image_side, 1}, Size{1, max_image_side}})
    REQUIRE(decode_png(encode_png(gradient(size), {}), "it") == gradient(size));
  for (const Size size : {Size{max_image_side + 1, 1}, Size{1, max_image_side + 1}})
    REQUIRE_THROWS_AS(encode_png(Image(size), {}), FileError);
}

TEST_CASE("a short file that says it is a huge picture does not get the memory for it") {
  const Folder folder;
  const std::string header = big_endian(16384) + big_endian(16384) + std::string("\x08\x02\x00\x00\x00", 5);
  store(folder.path / "a.png", "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) +
                                   chunk("IDAT", deflated(std::string(100'000, '\0'))) + chunk("IEND", ""));
  REQUIRE(error_of_reading(folder.path / "a.png").find("not enough data for its pixels") != std::string::npos);
}

TEST_CASE("a picture packed as tightly as can be is not too short for its pixels, whatever its kind of colour") {
  for (const auto& [kind, bytes] : {std::pair{0, 1}, {2, 3}, {4, 2}, {6, 4}}) {
    const std::string header = big_endian(4000) + big_endian(4000) + std::string{8, static_cast<char>(kind), 0, 0, 0};
    const std::string packed = deflated(std::string(static_cast<std::size_t>(4000 * (4000 * bytes + 1)), '\0'));
    const std::string png = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", packed) + chunk("IEND", "");
    REQUIRE(error_of_decoding({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}) == "");
    const std::string half = packed.substr(0, packed.size() * 9 / 10);
    const std::string cut = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", half) + chunk("IEND", "");
    REQUIRE(
        error_of_decoding({reinterpret_cast<const std::uint8_t*>(cut.data()), cut.size()}).find("not enough data") !=
        std::string::npos);
  }
}

TEST_CASE("the emptiest of pictures is not too short for its pixels") {
  for (const int side : {1, 2, 100, 3000})
    REQUIRE(decode_png(encode_png(Image({side, side}), {}), "it") == Image({side, side}));
}

TEST_CASE("grey, palette and alpha become RGB, alpha over white") {
  const Folder folder;
  const fs::path path = folder.path / "a.png";

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
  // Every sample is 0x8080, and no gamma is stated.
  const Folder folder;
  const fs::path path = folder.path / "a.png";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, 5, 5, 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  std::array<std::uint8_t, 10> row;
  row.fill(0x80);
  std::array<png_bytep, 5> rows;
  rows.fill(row.data());
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);

  const Image image = read_png(path);
  REQUIRE(image.size() == Size{5, 5});
  for (int i = 0; i < 25; ++i) REQUIRE(image.pixel(i % 5, i / 5) == Color{128, 128, 128});
}
