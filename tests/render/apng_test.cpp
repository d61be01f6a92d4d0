#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/image.hpp"
#include "render/png_chunk.hpp"
#include "tests/kit/catch.hpp"
#include "tests/render/png_bytes.hpp"

namespace apng_test {

using namespace render;
using namespace render::test;

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

struct Chunk {
  std::string type, data;
};

std::vector<Chunk> chunks(std::span<const std::uint8_t> file) {
  std::vector<Chunk> list;
  for (file = file.subspan(png_signature.size()); !file.empty();) {
    const auto chunk = take_png_chunk(file);
    REQUIRE(chunk);
    REQUIRE(chunk->intact);
    list.push_back({std::string(chunk->type), {chunk->data.begin(), chunk->data.end()}});
  }
  return list;
}

std::vector<std::string> of_type(const std::vector<Chunk>& list, const std::string& type) {
  std::vector<std::string> found;
  for (const Chunk& chunk : list)
    if (chunk.type == type) found.push_back(chunk.data);
  return found;
}

std::string big_endian_16(std::uint32_t value) { return big_endian(value).substr(2); }

std::vector<std::uint8_t> png_of(std::size_t i) {
  return encode_png(picture(static_cast<int>(i)), {"frame " + std::to_string(i), ""});
}

std::vector<std::uint8_t> animation(std::size_t count) {
  return encode_apng(count, png_of, [](std::size_t) { return 2; }, {"A title", "AB×AO"});
}

}  // namespace

TEST_CASE("every picture of an animation comes out as it went in, the first also where nothing is known of animation") {
  const std::vector<std::uint8_t> made = animation(4);
  REQUIRE(decode_png(made, "it").image == picture(0));
  const auto list = chunks(made);
  const auto later = of_type(list, "fdAT");
  REQUIRE(later.size() == 3);
  for (int i = 0; i < 3; ++i) {
    const std::string alone = png_begin + chunk("IHDR", of_type(list, "IHDR").at(0)) +
                              chunk("IDAT", later[static_cast<std::size_t>(i)].substr(4)) + chunk("IEND", "");
    REQUIRE(decode_png(bytes_of_text(alone), "it").image == picture(i + 1));
  }
}

TEST_CASE(
    "an animation is a whole file of any number of pictures: counted, in order, with its own title and description") {
  for (std::uint32_t count = 1; count <= 4; ++count) {
    const auto list = chunks(animation(count));
    REQUIRE(of_type(list, "acTL").at(0) == big_endian(count) + big_endian(0));
    REQUIRE(of_type(list, "tEXt") == std::vector{std::string("Title\0A title", 13)});
    REQUIRE(of_type(list, "iTXt") == std::vector{std::string("Description\0\0\0\0\0AB×AO", 22)});
    std::string types, expected = "IHDR acTL fcTL IDAT ";
    std::uint32_t sequence = 0;
    for (const Chunk& chunk : list) {
      if (chunk.type == "fcTL" || chunk.type == "fdAT") REQUIRE(chunk.data.substr(0, 4) == big_endian(sequence++));
      if (chunk.type != "iTXt" && chunk.type != "tEXt") types += chunk.type + " ";
    }
    for (std::uint32_t i = 1; i < count; ++i) expected += "fcTL fdAT ";
    REQUIRE(types == expected + "IEND ");
  }
}

TEST_CASE("every frame says its time and that it replaces the whole picture") {
  const std::vector<double> seconds = {0, 0.0504, 2, 65.535, 66, 600};
  const std::vector<std::pair<unsigned, unsigned>> parts = {{0, 1000},     {50, 1000},  {2000, 1000},
                                                            {65535, 1000}, {6600, 100}, {60000, 100}};
  const auto made = encode_apng(seconds.size(), png_of, [&](std::size_t i) { return seconds[i]; }, {});
  const auto controls = of_type(chunks(made), "fcTL");
  REQUIRE(controls.size() == seconds.size());
  for (std::size_t i = 0; i < controls.size(); ++i)
    REQUIRE(controls[i].substr(4) == big_endian(300) + big_endian(200) + big_endian(0) + big_endian(0) +
                                         big_endian_16(parts[i].first) + big_endian_16(parts[i].second) +
                                         std::string(2, '\0'));
}

TEST_CASE("a picture of another size is refused") {
  const auto higher = [](std::size_t i) { return encode_png(Image({300, 199 + static_cast<int>(i)}), {}); };
  const auto seconds = [](std::size_t) { return 2; };
  REQUIRE_THROWS_AS(encode_apng(2, higher, seconds, {}), std::invalid_argument);
  REQUIRE_NOTHROW(encode_apng(1, higher, seconds, {}));
}

}  // namespace apng_test
