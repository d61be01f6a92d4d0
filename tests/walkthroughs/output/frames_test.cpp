// The PNG files of one walkthrough of each kind, written once at two sizes and looked at by several tests; and what can
// be told of every frame of all of them without rasterizing it.

#include <cstdlib>
#include <set>
#include <tuple>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/output/written.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/picture/draw.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;
using render::Image;
using render::Size;

namespace {

constexpr Size usual{1280, 720}, other{640, 480};

std::string number_of(std::size_t index) {
  const std::string digits = std::to_string(index);
  return std::string(3 - digits.size(), '0') + digits + ".png";
}

void nobody(const fs::path&, std::size_t) {}

/// One of each kind, because rasterizing all seven hundred frames takes minutes under a sanitizer: a search in the plane,
/// close-ups, diagrams, the regions of a triangle and of a tetrahedron, two runs side by side, round objects in space.
const std::vector<StagedStory>& of_each_kind() {
  static const std::vector<StagedStory> chosen = [] {
    std::vector<StagedStory> list;
    for (const char* name :
         {"figure-4-left", "figure-5", "figure-8", "regions/2-simplex-r3", "regions/3-simplex-face-abc-edge-ac",
          "as-printed-spheres", "vehicle-and-threat/counter-munition-near-miss"})
      list.emplace_back(tell(walkthrough(name)));
    return list;
  }();
  return chosen;
}

void render_all(const fs::path& folder, Size size) {
  Studio studio;
  for (const StagedStory& story : of_each_kind()) {
    render_frames(story, {folder, size}, studio, nobody);
    render_strip(story, {folder, size}, studio);
  }
}

const fs::path& rendered(Size size) {
  static const Folder usual_folder, other_folder;
  const fs::path& folder = (size == usual ? usual_folder : other_folder).path();
  if (fs::is_empty(folder)) render_all(folder, size);
  return folder;
}

std::vector<Image> frames(const Story& story, Size size) {
  std::vector<Image> list;
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    list.push_back(render::read_png(rendered(size) / story.walkthrough.name / number_of(i)));
  return list;
}

std::size_t pixels_unlike_background(const Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.size().height; ++y)
    for (int x = 0; x < image.size().width; ++x) count += image.pixel(x, y) != render::palette::white ? 1 : 0;
  return count;
}

/// Returns: whether the picture has more than `count` colours.
bool has_colors(const Image& image, std::size_t count) {
  std::set<std::tuple<int, int, int>> seen;
  for (int y = 0; y < image.size().height && seen.size() <= count; ++y)
    for (int x = 0; x < image.size().width; ++x) {
      const render::Color c = image.pixel(x, y);
      seen.insert({c.r, c.g, c.b});  // emplace() would make a node for each pixel
    }
  return seen.size() > count;
}

/// Returns: in how many pixels two frames differ besides their texts.
std::size_t differing_pixels_of_panels(const Image& image, const Image& before) {
  std::size_t different = 0;
  for (int y = 80; y < 530; ++y)
    for (int x = 0; x < usual.width; ++x) different += image.pixel(x, y) != before.pixel(x, y) ? 1 : 0;
  return different;
}

/// Returns: whether no channel differs by more than two shades: where an edge lies just between two pixels, another
/// offset of the page rounds otherwise.
bool alike(render::Color p, render::Color q) {
  return std::abs(p.r - q.r) <= 2 && std::abs(p.g - q.g) <= 2 && std::abs(p.b - q.b) <= 2;
}

/// Returns: whether the two outermost rows and columns are white.
bool clear_edge(const Image& image) {
  const Size size = image.size();
  bool clear = true;
  for (int x = 0; x < size.width; ++x)
    for (const int y : {0, 1, size.height - 2, size.height - 1})
      clear = clear && image.pixel(x, y) == render::palette::white;
  for (int y = 0; y < size.height; ++y)
    for (const int x : {0, 1, size.width - 2, size.width - 1})
      clear = clear && image.pixel(x, y) == render::palette::white;
  return clear;
}

}  // namespace

TEST_CASE("The pictures of one walkthrough of each kind", "[unsanitized]") {
  SECTION("Each walkthrough has its frames, its strip and nothing else in its folder") {
    for (const Size size : {usual, other}) {
      std::vector<std::string> expected;
      for (const StagedStory& story : of_each_kind()) {
        for (std::size_t i = 0; i < story.frames.size(); ++i)
          expected.push_back(story.walkthrough.name + "/" + number_of(i));
        expected.push_back(story.walkthrough.name + "/strip.png");
      }
      std::ranges::sort(expected);
      CHECK(listing(rendered(size)) == expected);
    }
  }

  SECTION("Frames decode, have the size that was asked for, and nothing at their very edge") {
    for (const StagedStory& story : of_each_kind()) {
      for (const Image& image : frames(story, other)) {
        CHECK(image.size() == other);
        CHECK(clear_edge(image));
      }
    }
  }

  // Each picture is decoded once for all that is asked about it: that takes longer than the questions.
  SECTION("So do those of the usual size, none is blank or flooded, and each differs from the one before") {
    for (const StagedStory& story : of_each_kind()) {
      const std::vector<Image> images = frames(story, usual);
      for (std::size_t i = 0; i < images.size(); ++i) {
        INFO(story.walkthrough.name << ", frame " << i);
        CHECK(images[i].size() == usual);
        CHECK(clear_edge(images[i]));
        CHECK(has_colors(images[i], 100));
        const auto drawn = static_cast<double>(pixels_unlike_background(images[i])) / (usual.width * usual.height);
        CHECK(drawn > 0.08);
        CHECK(drawn < 0.6);
        if (i > 0) CHECK(differing_pixels_of_panels(images[i], images[i - 1]) > 20);
      }
    }
  }

  SECTION("Two runs write the same bytes") {
    const Folder again;
    render_all(again.path(), other);
    for (const std::string& file : listing(rendered(other))) {
      INFO(file);
      CHECK(bytes_of(again.path() / file) == bytes_of(rendered(other) / file));
    }
  }

  SECTION("A strip is one wide picture with a panel for each iteration, or for each scene of a comparison") {
    const std::vector<std::pair<std::string, int>> panels = {
        {"figure-4-left", 4}, {"figure-4-right", 2}, {"figure-4-right-no-crossing-test", 4}, {"figure-5", 2}};
    const Folder folder;
    Studio studio;
    for (const auto& [name, count] : panels) {
      const StagedStory story(tell(walkthrough(name)));
      const Image strip = render::read_png(render_strip(story, {folder.path(), usual}, studio));
      const Image half = render::read_png(render_strip(story, {folder.path(), other}, studio));
      CHECK(strip.size().width == 420 * count);
      CHECK(strip.size().width > 3 * strip.size().height / 2);
      CHECK(half.size().width * 2 == strip.size().width);
      CHECK(half.size().height * 2 == strip.size().height);
      CHECK(clear_edge(strip));  // no caption is cut off
      CHECK(has_colors(strip, 100));
      for (int panel = 0; panel < count; ++panel) {  // each has something to show
        std::set<int> reds;
        for (int x = 420 * panel; x < 420 * (panel + 1); ++x) reds.insert(strip.pixel(x, 220).r);
        CHECK(reds.size() > 5);
      }
    }
  }

  SECTION("A frame carries its step and its caption as text, for readers without the picture") {
    for (const StagedStory& story : of_each_kind()) {
      for (std::size_t i = 0; i < story.frames.size(); ++i) {
        const std::string bytes = bytes_of(rendered(usual) / story.walkthrough.name / number_of(i));
        INFO(story.walkthrough.name << ", frame " << i);
        CHECK(bytes.find(story.walkthrough.title + ", step " + std::to_string(i + 1) + " of " +
                         std::to_string(story.frames.size())) != std::string::npos);
        CHECK(bytes.find(plain(story.frames[i].caption)) != std::string::npos);
      }
    }
  }
}

namespace {

/// Returns: the picture of one frame alone.
Image draw(Studio& studio, const StagedStory& story, std::size_t index, const Look& look, Size size) {
  render::Canvas canvas(page_of_frame(look.text), size, look.style.theme.paper, studio.font);
  draw_frame(canvas, story, index, look);
  return studio.rasterizer.draw(canvas);
}

/// Returns: the first frame about each kind of event.
std::vector<std::size_t> one_of_each_focus(const StagedStory& story) {
  std::vector<std::size_t> chosen;
  std::set<Focus> seen;
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    if (seen.insert(story.frames[i].focus).second) chosen.push_back(i);
  return chosen;
}

}  // namespace

TEST_CASE("Every theme draws every kind of frame on its own paper", "[unsanitized]") {
  Studio studio;
  for (const render::Theme& theme : {render::themes::report, render::themes::slides, render::themes::dark})
    for (const StagedStory& story : of_each_kind())
      for (const std::size_t i : one_of_each_focus(story)) {
        INFO(story.walkthrough.name << ", frame " << i);
        const Image image = draw(studio, story, i, {.style = Style(theme)}, {320, 180});
        CHECK(image.pixel(0, 0) == theme.paper);
        CHECK(has_colors(image, 50));
      }
}

TEST_CASE("Nothing is drawn outside the panels of a frame without text", "[unsanitized]") {
  // A search has panels of these widths in page units, 14 apart; a pair of scenes has two alike.
  const std::vector<std::pair<int, int>> search = {{40, 340}, {354, 854}, {868, 1240}}, pair = {{40, 633}, {647, 1240}};
  constexpr int top = 20, bottom = 468, border = 2;
  Studio studio;
  const Size page = page_of_frame(Text::none);
  for (const StagedStory& story : of_each_kind()) {
    const Layout layout = story.walkthrough.layout;
    if (layout == Layout::diagrams) continue;
    for (const std::size_t i : one_of_each_focus(story)) {
      INFO(story.walkthrough.name << ", frame " << i);
      const Image image = draw(studio, story, i, {.text = Text::none}, page);
      const auto in_a_panel = [&](int x, int y) {
        return y >= top - border && y < bottom + border &&
               std::ranges::any_of(layout == Layout::search ? search : pair, [&](const auto& panel) {
                 return x >= panel.first - border && x < panel.second + border;
               });
      };
      int outside = 0;
      for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x)
          outside += !in_a_panel(x, y) && image.pixel(x, y) != render::palette::white ? 1 : 0;
      CHECK(outside == 0);
    }
  }
}

TEST_CASE("A sheet shows every frame, drawn at its reduced size, in reading order") {
  const Folder folder;
  const StagedStory story(tell(walkthrough("figure-4-right")));  // six frames: four and two
  Studio studio;
  const Size cell{480, 270};
  render_frames(story, {folder.path(), cell}, studio, nobody);
  const Image sheet = render::read_png(render_sheet(story, {folder.path(), usual}, studio));
  REQUIRE(sheet.size() == Size{4 * 488 + 8, 2 * 278 + 8});
  for (std::size_t i = 0; i < 6; ++i) {
    INFO("frame " << i);
    const Image frame = render::read_png(folder.path() / "figure-4-right" / number_of(i));
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

TEST_CASE("Each file is reported once, in order") {
  const Folder folder;
  Studio studio;
  const StagedStory story(tell(walkthrough("figure-4-left")));
  std::vector<std::string> files;
  std::vector<std::size_t> indices;
  render_frames(story, {folder.path(), {64, 36}}, studio, [&](const fs::path& file, std::size_t index) {
    CHECK(fs::exists(file));
    files.push_back(file.lexically_relative(folder.path()).string());
    indices.push_back(index);
  });
  CHECK(files == listing(folder.path()));
  REQUIRE(indices.size() == story.frames.size());
  for (std::size_t i = 0; i < indices.size(); ++i) CHECK(indices[i] == i);
}

TEST_CASE("Frames without text show the same panels at the same scale, and are less high", "[unsanitized]") {
  const Folder folder;
  rendered(usual);  // before the studio here: a thread has one context
  Studio studio;
  const StagedStory story(tell(walkthrough("figure-4-left"), Detail::step));
  render_frames(story, {folder.path(), usual, {.text = Text::none}}, studio, nobody);
  const StagedStory with_text(tell(walkthrough("figure-4-left")));
  const std::size_t last = with_text.frames.size() - 1;
  const Image bare = render::read_png(folder.path() / "figure-4-left" / number_of(story.frames.size() - 1));
  const Image whole = render::read_png(rendered(usual) / "figure-4-left" / number_of(last));
  REQUIRE(bare.size() == Size{1280, 488});
  CHECK(clear_edge(bare));
  int different = 0;
  for (int y = 20; y < 468; ++y)
    for (int x = 0; x < 1280; ++x) different += alike(bare.pixel(x, y), whole.pixel(x, y + 52)) ? 0 : 1;
  CHECK(different == 0);
}

TEST_CASE("Frames that an earlier, longer run has left are removed, other files are left alone") {
  const Folder folder;
  Studio studio;
  const fs::path own = folder.path() / "figure-5";
  fs::create_directories(own);
  const std::vector<std::string> foreign = {"002.txt", "005.png", "04.png", "notes.txt", "strip.png", "x003.png"};
  for (const std::string& name : foreign) std::ofstream(own / name) << "mine";
  for (const std::string name : {"000.png", "003.png", "004.png", "011.png"}) write_output(own / name, "stale");
  render_frames(StagedStory(tell(walkthrough("figure-5"))), {folder.path(), {64, 36}}, studio, nobody);
  std::vector<std::string> expected = {"000.png", "001.png", "002.png"};
  for (const std::string& name : foreign) {
    expected.push_back(name);
    CHECK(bytes_of(own / name) == "mine");
  }
  std::ranges::sort(expected);
  CHECK(listing(own) == expected);
  CHECK(render::read_png(own / "000.png").size() == Size{64, 36});
}

TEST_CASE("Where a frame cannot be written the error names the file, and nothing temporary is left") {
  const Folder folder;
  Studio studio;
  fs::create_directories(folder.path() / "figure-5" / "001.png" / "in the way");
  std::string error;
  try {
    render_frames(StagedStory(tell(walkthrough("figure-5"))), {folder.path(), {64, 36}}, studio, nobody);
  } catch (const render::FileError& e) {
    error = e.what();
  }
  CHECK(error.find("001.png") != std::string::npos);
  CHECK(listing(folder.path()) == std::vector<std::string>{"figure-5/000.png"});
}

namespace {

/// A picture of the README and the page that it shows.
struct ReadmePicture {
  std::string name;
  render::Size size, page;
  std::function<void(render::Canvas&, const StagedStory&)> draw;
};

}  // namespace

TEST_CASE("The pictures in the README take at most 200 KiB together") {
  const fs::path readme = kit::source("README.md");
  const std::string text = bytes_of(readme.string());
  std::uintmax_t sum = 0;
  int pictures = 0;
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
    const std::string file = text.substr(at + 2, text.find(')', at) - at - 2);
    if (!file.ends_with(".png")) continue;
    ++pictures;
    sum += fs::file_size(readme.parent_path() / file);
  }
  CHECK(pictures == 3);
  CHECK(sum <= 200 * 1024);
}

TEST_CASE("The pictures in the README are those that the program draws") {
  const StagedStory plane(tell(walkthrough("figure-4-left"))),
      space(tell(walkthrough("regions/3-simplex-face-adb-edge-ad")));
  const auto strip = [](render::Canvas& canvas, const StagedStory& story) { draw_strip(canvas, story); };
  const auto step_23 = [](render::Canvas& canvas, const StagedStory& story) { draw_frame(canvas, story, 22); };
  const bool is_plane = GENERATE(true, false);
  const StagedStory& story = is_plane ? plane : space;
  const ReadmePicture picture = is_plane
                                    ? ReadmePicture{"figure-4-left.png", strip_page(story), strip_page(story), strip}
                                    : ReadmePicture{"3-simplex-face-adb-edge-ad.png", {640, 360}, frame_page, step_23};
  INFO(picture.name);
  const Image committed = render::read_png(kit::source("walkthroughs") / picture.name);
  Studio studio;
  render::Canvas canvas(picture.size, picture.page, render::palette::white, studio.font);
  picture.draw(canvas, story);
  const Image drawn = studio.rasterizer.draw(canvas);
  REQUIRE(committed.size() == drawn.size());
  int different = 0;  // a few pixels may differ by a shade from processor to processor
  for (int y = 0; y < drawn.size().height; ++y)
    for (int x = 0; x < drawn.size().width; ++x) different += committed.pixel(x, y) != drawn.pixel(x, y) ? 1 : 0;
  CHECK(different < 50);
}
