#include "render/compare.hpp"

#include <stdexcept>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"

namespace compare_test {

using namespace render;

namespace {

struct Pixel {
  int x, y;
};

constexpr int base = 100;  // of every channel

Image plain(Size size) { return kit::plain(size, {base, base, base}); }

void add(Image& image, Pixel at, int change, int channel = 0) {
  image.row(at.y)[3 * at.x + channel] = static_cast<std::uint8_t>(base + change);
}

/// Compares a plain picture with one in which these pixels are off.
Comparison with(const std::vector<Pixel>& off, Size size = {1000, 800}, int change = 3) {
  Image actual = plain(size);
  for (const Pixel& pixel : off) add(actual, pixel, change);
  return compare(plain(size), actual);
}

/// So many pixels, no two of which touch, row by row.
std::vector<Pixel> scattered(int count, int width) {
  std::vector<Pixel> pixels;
  for (int i = 0; i < count; ++i) pixels.push_back({2 * i % width, 2 * (2 * i / width)});
  return pixels;
}

}  // namespace

// -- What passes --------------------------------------------------------------------------------------------------------

TEST_CASE("Every pixel may differ by two in every channel upwards or downwards") {
  for (const std::uint8_t other : {std::uint8_t{base - 2}, std::uint8_t{base + 2}}) {
    const Comparison found = compare(plain({40, 30}), kit::plain({40, 30}, {other, other, other}));
    CHECK(found.verdict == Verdict::within_tolerance);
    CHECK(found.off == 0);
    CHECK(found.histogram[2] == 1200);
  }
}

// -- Both sides of every number -----------------------------------------------------------------------------------------

TEST_CASE("A pixel is off when any one channel differs by three and not by two, which are not added") {
  Image three_times_two = plain({8, 8});
  for (const int channel : {0, 1, 2}) {
    add(three_times_two, {4, 4}, 2, channel);
    for (const int sign : {-1, 1}) {
      Image three = plain({8, 8});
      add(three, {4, 4}, 3 * sign, channel);
      CHECK(compare(plain({8, 8}), three).off == 1);
    }
  }
  CHECK(compare(plain({8, 8}), three_times_two).off == 0);
}

TEST_CASE("One of a hundred thousand pixels may be off, and parts of a pixel do not count") {
  CHECK(tolerance::allowed({1, 1}) == 0);
  CHECK(tolerance::allowed({320, 180}) == 0);
  CHECK(tolerance::allowed({99'999, 1}) == 0);
  CHECK(tolerance::allowed({1000, 100}) == 1);
  CHECK(tolerance::allowed({640, 360}) == 2);
  CHECK(tolerance::allowed({1280, 720}) == 9);
  CHECK(tolerance::allowed({16384, 16384}) == 2684);
}

TEST_CASE("As many scattered pixels may be off as are allowed and not one more") {
  for (const auto& [size, most] :
       {std::pair{Size{1000, 800}, 8}, {Size{1000, 600}, 6}, {Size{500, 200}, 1}, {Size{30, 20}, 0}}) {
    const Comparison last = with(scattered(most, size.width), size),
                     one_more = with(scattered(most + 1, size.width), size);
    CHECK(passes(last.verdict));
    CHECK(one_more.verdict == Verdict::different);
    CHECK(one_more.off == most + 1);
    CHECK(one_more.allowed == most);
    CHECK(one_more.largest_group == 1);
  }
}

TEST_CASE("Four pixels that are off may hang together and not five in whatever shape") {
  const std::vector<std::vector<Pixel>> shapes{
      {{3, 3}, {4, 3}, {5, 3}, {6, 3}, {7, 3}},  // a row
      {{3, 3}, {3, 4}, {3, 5}, {3, 6}, {3, 7}},  // a column
      {{3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}},  // corners only, down
      {{7, 3}, {6, 4}, {5, 5}, {4, 6}, {3, 7}},  // corners only, up
      {{3, 3}, {4, 4}, {5, 3}, {6, 4}, {7, 3}},  // zigzag
      {{3, 4}, {4, 4}, {5, 4}, {4, 3}, {4, 5}},  // a cross
      {{3, 3}, {7, 3}, {4, 4}, {6, 4}, {5, 5}},  // a V, whose arms meet in the last row
      {{5, 3}, {4, 4}, {6, 4}, {3, 5}, {7, 5}},  // and upside down
  };
  for (const std::vector<Pixel>& five : shapes) {
    const Comparison found = with(five);
    CHECK(found.verdict == Verdict::different);
    CHECK(found.off == 5);
    CHECK(found.largest_group == 5);
  }
  for (std::size_t i : {0u, 1u, 2u, 3u, 4u}) {  // those whose first four hang together
    std::vector<Pixel> four = shapes[i];
    four.pop_back();
    CHECK(with(four).verdict == Verdict::within_tolerance);
    CHECK(with(four).largest_group == 4);
  }
}

TEST_CASE("Pixels at the left and right border are no neighbours") {
  const std::vector<Pixel> border{{999, 3}, {0, 4}, {999, 5}, {0, 6}, {999, 7}};
  CHECK(with(border).largest_group == 1);
  CHECK(with(border).verdict == Verdict::within_tolerance);
}

TEST_CASE("A picture in which every pixel is off is one group and stripes are groups of their own") {
  std::vector<Pixel> all, stripes;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 30; ++x) {
      all.push_back({x, y});
      if (x % 2 == 0) stripes.push_back({x, y});
    }
  CHECK(with(all, {30, 20}).largest_group == 600);
  CHECK(with(stripes, {30, 20}).largest_group == 20);
}

// -- What is told -------------------------------------------------------------------------------------------------------

TEST_CASE("The bounding box encloses the pixels that are off but not those within the tolerance") {
  Image actual = plain({32, 32});
  add(actual, {1, 1}, 2);
  add(actual, {5, 20}, 50);
  add(actual, {9, 8}, -50);
  const Comparison found = compare(plain({32, 32}), actual);
  CHECK(found.box == PixelBox{5, 8, 9, 20});
  CHECK(found.box.width() == 5);
  CHECK(found.box.height() == 13);
  CHECK(found.largest_difference() == 50);
}

TEST_CASE("The histogram counts each pixel once by its most different channel") {
  Image actual = plain({10, 10});
  add(actual, {0, 0}, 1, 0);
  add(actual, {0, 0}, 7, 2);
  add(actual, {1, 0}, -7, 1);
  add(actual, {2, 0}, 155, 1);
  const Comparison found = compare(plain({10, 10}), actual);
  CHECK(found.histogram[0] == 97);
  CHECK(found.histogram[1] == 0);
  CHECK(found.histogram[7] == 2);
  CHECK(found.histogram[155] == 1);
}

TEST_CASE("The picture of the difference is sixteen times as large on black and ends at white") {
  Image actual = plain({4, 1});
  add(actual, {1, 0}, -2, 0);
  add(actual, {1, 0}, 3, 1);
  add(actual, {2, 0}, 16, 2);
  const Image image = difference(plain({4, 1}), actual);
  CHECK(image.pixel(0, 0) == Color{0, 0, 0});
  CHECK(image.pixel(1, 0) == Color{32, 48, 0});
  CHECK(image.pixel(2, 0) == Color{0, 0, 255});
}

}  // namespace compare_test
