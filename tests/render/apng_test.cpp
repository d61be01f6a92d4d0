#include "render/apng.hpp"

#include <unistd.h>
#include <zlib.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"

using namespace render;
namespace fs = std::filesystem;

namespace {

constexpr Size size{300, 200};

/// Pictures too busy for one block of compressed data.
Image picture(int seed) {
  Image image(size);
  for (int y = 0; y < size.height; ++y)
    for (int i = 0; i < 3 * size.width; ++i)
      image.row(y)[i] = static_cast<std::uint8_t>((i * i * (seed + 3) + y * y * y + i * y * seed) >> 5);
  return image;
}

std::uint32_t number(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

struct Chunk {
  std::string type, data;
  bool intact;  ///< whether the checksum is right
};

std::vector<Chunk> chunks(std::span<const std::uint8_t> file) {
  const std::string bytes(file.begin(), file.end());
  REQUIRE(bytes.starts_with("\x89PNG\r\n\x1a\n"));
  std::vector<Chunk> list;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = number(bytes.substr(at, 4));
    REQUIRE(at + 12 + length <= bytes.size());
    const std::string checked = bytes.substr(at + 4, 4 + length);
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
    list.push_back({checked.substr(0, 4), checked.substr(4), sum == number(bytes.substr(at + 8 + length, 4))});
    at += 12 + length;
  }
  return list;
}

std::vector<Chunk> of_type(const std::vector<Chunk>& list, const std::string& type) {
  std::vector<Chunk> found;
  for (const Chunk& chunk : list)
    if (chunk.type == type) found.push_back(chunk);
  return found;
}

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(value >> shift));
  return bytes;
}

std::string written(const std::string& type, const std::string& data) {
  const std::string checked = type + data;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return big_endian(data.size()) + checked + big_endian(sum);
}

Image decoded(const std::string& bytes) {
  const fs::path path = fs::temp_directory_path() / ("gjkstep-apng-test-" + std::to_string(getpid()) + ".png");
  write_file(path, bytes);
  const Image image = read_png(path);
  fs::remove(path);
  return image;
}

Animation animation(int count, double seconds = 2) {
  Animation made({"A title", "AB×AO"});
  for (int i = 0; i < count; ++i) made.add(encode_png(picture(i), {"frame " + std::to_string(i), ""}), seconds);
  return made;
}

}  // namespace

TEST_CASE("who knows nothing of animation sees the first picture") {
  const Animation made = animation(3);
  REQUIRE(decoded({made.bytes().begin(), made.bytes().end()}) == picture(0));
}

TEST_CASE("every picture of an animation comes out as it went in") {
  const auto list = chunks(animation(4).bytes());
  const std::string header = written("IHDR", of_type(list, "IHDR").at(0).data), end = written("IEND", "");
  const auto later = of_type(list, "fdAT");
  REQUIRE(later.size() == 3);
  for (int i = 0; i < 3; ++i) {
    const std::string data = later[static_cast<std::size_t>(i)].data.substr(4);
    REQUIRE(decoded("\x89PNG\r\n\x1a\n" + header + written("IDAT", data) + end) == picture(i + 1));
  }
}

TEST_CASE("an animation is a whole file after every picture: counted, checked, in order") {
  for (int count = 1; count <= 4; ++count) {
    const auto list = chunks(animation(count).bytes());
    for (const Chunk& chunk : list) REQUIRE(chunk.intact);
    REQUIRE(list.front().type == "IHDR");
    REQUIRE(list.back().type == "IEND");
    REQUIRE(of_type(list, "IEND").size() == 1);
    REQUIRE(of_type(list, "acTL").at(0).data == big_endian(static_cast<std::size_t>(count)) + big_endian(0));
    REQUIRE(of_type(list, "fcTL").size() == static_cast<std::size_t>(count));

    std::string types;
    std::uint32_t sequence = 0;
    for (const Chunk& chunk : list) {
      if (chunk.type == "fcTL" || chunk.type == "fdAT") REQUIRE(number(chunk.data.substr(0, 4)) == sequence++);
      if (chunk.type != "iTXt") types += chunk.type + " ";
    }
    std::string expected = "IHDR acTL fcTL IDAT ";
    for (int i = 1; i < count; ++i) expected += "fcTL fdAT ";
    REQUIRE(types == expected + "IEND ");
  }
}

TEST_CASE("every frame says its time and that it replaces the whole picture") {
  Animation made({});
  const std::vector<double> seconds = {0, 0.0504, 2, 65.535, 66, 600};
  const std::vector<std::pair<unsigned, unsigned>> parts = {{0, 1000},     {50, 1000},  {2000, 1000},
                                                            {65535, 1000}, {6600, 100}, {60000, 100}};
  for (const double each : seconds) made.add(encode_png(picture(1), {}), each);
  const auto controls = of_type(chunks(made.bytes()), "fcTL");
  REQUIRE(controls.size() == seconds.size());
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const std::string& data = controls[i].data;
    REQUIRE(data.size() == 26);
    REQUIRE(number(data.substr(4, 4)) == 300);
    REQUIRE(number(data.substr(8, 4)) == 200);
    REQUIRE(number(data.substr(12, 8)) == 0);
    REQUIRE(number(data.substr(20, 2)) == parts[i].first);
    REQUIRE(number(data.substr(22, 2)) == parts[i].second);
    REQUIRE(number(data.substr(24, 2)) == 0);
  }
}

TEST_CASE("an animation has its own title and description, not those of its pictures") {
  const auto texts = of_type(chunks(animation(2).bytes()), "iTXt");
  REQUIRE(texts.size() == 2);
  REQUIRE(texts[0].data == std::string("Title\0\0\0\0\0A title", 17));
  REQUIRE(texts[1].data == std::string("Description\0\0\0\0\0AB×AO", 22));
  REQUIRE(of_type(chunks(animation(2).bytes()), "tEXt").empty());
}

TEST_CASE("a picture of another size is refused, and the animation stays as it was") {
  Animation made = animation(2);
  const std::vector<std::uint8_t> before(made.bytes().begin(), made.bytes().end());
  REQUIRE_THROWS_AS(made.add(encode_png(Image({300, 199}), {}), 2), std::invalid_argument);
  REQUIRE(std::vector<std::uint8_t>(made.bytes().begin(), made.bytes().end()) == before);
  REQUIRE(made.frames() == 2);
}

TEST_CASE("an animation without pictures is no file") { REQUIRE(animation(0).bytes().empty()); }
