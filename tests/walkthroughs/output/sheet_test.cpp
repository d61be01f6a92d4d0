#include "walkthroughs/output/sheet.hpp"

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/output/written.hpp"
#include "tests/walkthroughs/support.hpp"

namespace sheet_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using render::Image;
using render::Size;

namespace {

constexpr Size usual{1280, 720};

}  // namespace

TEST_CASE("A sheet shows every frame, drawn at its reduced size, in reading order") {
  const Folder folder;
  const StagedStory story(tell(walkthrough("figure-4-right")));  // six frames: four and two
  Studio studio;
  const Size cell{480, 270};
  render_frames(story, {folder.path(), cell}, studio, [](const auto&, std::size_t) {});
  const Image sheet = render::read_png(render_sheet(story, {folder.path(), usual}, studio)).image;
  REQUIRE(sheet.size() == Size{4 * 488 + 8, 2 * 278 + 8});
  for (std::size_t i = 0; i < 6; ++i) {
    INFO("frame " << i);
    const Image frame = render::read_png(folder / ("figure-4-right/00" + std::to_string(i) + ".png")).image;
    const int left = 8 + static_cast<int>(i % 4) * 488, top = 8 + static_cast<int>(i / 4) * 278;
    int different = 0;
    for (int y = 0; y < cell.height; ++y)
      for (int x = 0; x < cell.width; ++x) different += frame.pixel(x, y) != sheet.pixel(left + x, top + y) ? 1 : 0;
    CHECK(different == 0);
  }
  CHECK(sheet.pixel(0, 0) == render::palette::faint);
  CHECK(sheet.pixel(3 * 488, 500) == render::palette::faint);  // no seventh frame
}

TEST_CASE("A sheet can be read, however many frames there are and however large they are") {
  int shrunk = 0, wide = 0;
  for (const Size size : {Size{16, 16}, usual, Size{8192, 16}, Size{16, 8192}, Size{8192, 8192}})
    for (const Text text : {Text::around, Text::none})
      for (int count = 1; count <= 20'000; count += 1 + count / 3) {
        CAPTURE(size.width, size.height, count);
        const SheetLayout layout = sheet_layout(count, {{}, size, {.text = text}});
        const Size sheet = layout.size();
        REQUIRE(std::max(sheet.width, sheet.height) <= render::max_image_side);
        int misplaced = 0;
        for (int i = 1; i < count; ++i) {
          const bool same_row = layout.top(i) == layout.top(i - 1);
          misplaced += layout.left(i) != (same_row ? layout.left(i - 1) + layout.cell.width + sheet_gap : sheet_gap);
          misplaced += !same_row && layout.top(i) != layout.top(i - 1) + layout.cell.height + sheet_gap;
        }
        REQUIRE(misplaced == 0);
        REQUIRE(layout.left(layout.columns - 1) + layout.cell.width + sheet_gap == sheet.width);
        REQUIRE(layout.top(count - 1) + layout.cell.height + sheet_gap == sheet.height);
        shrunk += layout.frame.width < size.width / 3 && size.width > 100;
        wide += layout.columns > sheet_columns;
      }
  CHECK(shrunk > 0);
  CHECK(wide > shrunk);
}

TEST_CASE("A sheet has four frames in a row, more where it would be too high, and smaller ones at last") {
  const auto says = [](int count, Size size, int columns, Size frame) {
    CAPTURE(count);
    const SheetLayout layout = sheet_layout(count, {{}, size});
    CHECK(layout.columns == columns);
    CHECK(layout.frame == frame);
  };
  says(3, usual, 3, {480, 270});
  says(232, usual, 4, {480, 270});  // 58 rows
  says(233, usual, 5, {480, 270});
  says(408, usual, 8, {480, 270});
  says(20, {8192, 8192}, 4, {3072, 3072});
  says(24, {8192, 8192}, 5, {3072, 3072});
  says(26, {8192, 8192}, 5, {2633, 2633});  // six rows
}

TEST_CASE("So many frames that no sheet holds them are told so") {
  CHECK_NOTHROW(sheet_layout(400'000, {{}, usual}));
  CHECK_THROWS_AS(sheet_layout(500'000, {{}, usual}), render::FileError);
}

}  // namespace sheet_test
