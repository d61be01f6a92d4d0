// Sheets of paper: what stands on which page and how large, the files, and what a reader of PDF files finds in them.
#include "walkthroughs/output/paper_sheet.hpp"

#include <set>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/output/manifest.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* papers[] = {"a4", "letter-across"};

PaperLayout layout_of(const std::string& name, const std::string& paper, Look look = {}, bool larger_text = true) {
  static render::Font font{render::Font::default_directory()};
  const StagedStory story(tell(walkthrough(name)));
  return paper_layout(story, {.folder = {}, .size = frame_page, .look = look}, paper_named(paper).value(), larger_text,
                      font);
}

std::string option_out(const Folder& folder) { return " --out " + quoted(folder.path().string()); }

}  // namespace

TEST_CASE("Letters on paper have 7 points or more, and every frame stands on one page, in order",
          "[paper-sheet][unsanitized][full]") {
  for (const char* name : {"figure-8", "figure-5", "as-printed-spheres", "regions/2-simplex-r3"})
    for (const char* paper : papers) {
      INFO(name << " on " << paper);
      const PaperLayout layout = layout_of(name, paper);
      CHECK(layout.letters >= least_points);
      const std::size_t frames = StagedStory(tell(walkthrough(name))).frames.size();
      std::size_t next = 0;
      for (const std::vector<std::size_t>& page : layout.pages) {
        REQUIRE_FALSE(page.empty());
        double height = 0;
        for (const std::size_t index : page) {
          CHECK(index == next++);
          height += layout.heights[index];
        }
        CHECK(height < layout.paper.height);
      }
      CHECK(next == frames);
      CHECK((layout.words_below ? layout.words_width : layout.picture_width + layout.words_width) < layout.paper.width);
    }
}

TEST_CASE("The letters of the panels are as small as they may be, so that many frames stand on a page",
          "[paper-sheet]") {
  const PaperLayout layout = layout_of("figure-4-left", "a4");
  CHECK(layout.letters == Approx(least_points).margin(1e-9));
  CHECK(layout.pages.size() == 6);          // of 18 frames
  CHECK(layout.look.style.theme.text > 1);  // with usual letters the panels would be larger on paper
  CHECK(layout.words_width > 150);
}

TEST_CASE("Letters whose size was asked for keep it on paper", "[paper-sheet]") {
  const PaperLayout layout = layout_of("figure-4-left", "a4", {}, false);
  CHECK(layout.look.style.theme.text == Look{}.style.theme.text);
  CHECK(layout.picture_height > layout_of("figure-4-left", "a4").picture_height);
}

TEST_CASE("Without captions panels fill the page, and nothing stands beside them", "[paper-sheet]") {
  const PaperLayout layout = layout_of("figure-4-left", "a4", {.text = Text::none});
  CHECK(layout.words_width == 0);
  for (const double height : layout.heights) CHECK(height == layout.picture_height);
}

TEST_CASE("Papers have their sizes, upright or across", "[paper-sheet]") {
  const render::PaperSize a4 = paper_named("a4").value(), letter = paper_named("letter").value();
  CHECK(a4.width == Approx(595.28).margin(0.01));
  CHECK(a4.height == Approx(841.89).margin(0.01));
  CHECK(letter.width == 612);
  CHECK(letter.height == 792);
  for (const std::string name : {"a4", "letter"}) {
    CHECK(paper_named(name + "-across").value().width == paper_named(name).value().height);
    CHECK(paper_named(name + "-across").value().height == paper_named(name).value().width);
  }
  for (const char* none : {"", "one", "a5", "-across"}) CHECK_FALSE(paper_named(none).has_value());
}

TEST_CASE("gjkstep render --sheet=a4 writes pages that compare reads, one PDF of them, and removes older pages",
          "[paper-sheet][full]") {
  const Folder folder, again;
  const fs::path own = folder.path() / "figure-4-right";
  fs::create_directories(own);
  for (const char* stale : {"sheet-3.png", "sheet-4.png"}) write_output(own / stale, "older");
  const std::string command = "render figure-4-right --size 320x180 --sheet=a4";
  const Outcome outcome = run(command + option_out(folder));
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  std::set<std::string> pages;
  for (const std::string& file : listing(own))
    if (file.starts_with("sheet")) pages.insert(file);
  CHECK(pages == std::set<std::string>{"sheet-1.png", "sheet-2.png", "sheet.pdf"});
  for (const std::string& page : pages) CHECK(has(outcome.out, (own / page).string() + "  "));
  CHECK(render::read_png(own / "sheet-1.png").size() == render::Size{2480, 3508});

  run(command + option_out(again));
  CHECK(bytes_of(again.path() / "figure-4-right" / "sheet.pdf") == bytes_of(own / "sheet.pdf"));
  CHECK(run("compare " + quoted(folder.path().string()) + " " + quoted(again.path().string())).exit_code == 0);
}

TEST_CASE("A reader of PDF files finds the pages of a sheet, their size and their very pixels, and no date",
          "[paper-sheet][full]") {
  if (!has(shell("pdfinfo -v").err, "pdfinfo version")) {
    kit::skip("there is no pdfinfo");
    return;
  }
  const Folder folder;
  CHECK(run("render figure-4-right --size 320x180 --sheet=letter" + option_out(folder)).exit_code == 0);
  const std::string file = quoted((folder.path() / "figure-4-right" / "sheet.pdf").string());
  const std::string info = shell("pdfinfo " + file).out;
  INFO(info);
  CHECK(has(info, "Pages:           2\n"));
  CHECK(has(info, "612 x 792 pts (letter)"));
  CHECK(has(info, walkthrough("figure-4-right").title));
  CHECK_FALSE(has(info, "Date"));
  const std::string drawn = (folder.path() / "drawn").string();
  shell("pdfimages -png " + file + " " + quoted(drawn));
  for (int page = 0; page < 2; ++page)
    CHECK(render::read_png(drawn + "-00" + std::to_string(page) + ".png") ==
          render::read_png(folder.path() / "figure-4-right" / ("sheet-" + std::to_string(page + 1) + ".png")));
}

TEST_CASE("The picture of a sheet fills the page of its PDF to the last column and row", "[paper-sheet][full]") {
  if (!has(shell("pdftoppm -v").err, "pdftoppm version")) {
    kit::skip("there is no pdftoppm");
    return;
  }
  const Folder folder;  // on dark paper, beside which the PDF's own is seen
  CHECK(run("render figure-4-right --size 320x180 --theme dark --sheet=letter" + option_out(folder)).exit_code == 0);
  const std::string drawn = (folder.path() / "drawn").string();
  shell("pdftoppm -png -r 300 -l 1 " + quoted((folder.path() / "figure-4-right" / "sheet.pdf").string()) + " " +
          quoted(drawn));
  const render::Image page = render::read_png(drawn + "-1.png");
  REQUIRE(page.size() == render::Size{2550, 3300});
  for (const int x : {0, 2549})
    for (const int y : {0, 3299}) CHECK(page.pixel(x, y).r < 128);
}

TEST_CASE("At the foot of each page stands its number, of one digit on each of two", "[paper-sheet][full]") {
  const Folder folder;
  CHECK(run("render figure-4-right --size 320x180 --sheet=a4" + option_out(folder)).exit_code == 0);
  constexpr int inch = 300, paper_width = 2480;
  const auto foot_of = [&](int page) {
    const fs::path file = folder.path() / "figure-4-right" / ("sheet-" + std::to_string(page) + ".png");
    return render::part_of(render::read_png(file), 0, 3508 - inch * 44 / 72, {paper_width, inch * 14 / 72});
  };
  const auto columns_of_ink = [](const render::Image& foot) {
    std::set<int> columns;
    for (int x = 0; x < foot.size().width; ++x)
      for (int y = 0; y < foot.size().height; ++y)
        if (foot.pixel(x, y).r < 128) columns.insert(x);
    return columns;
  };
  const std::set<int> first = columns_of_ink(foot_of(1)), second = columns_of_ink(foot_of(2));
  REQUIRE_FALSE(first.empty());
  REQUIRE_FALSE(second.empty());
  CHECK(*first.begin() == *second.begin());
  CHECK(paper_width - *first.begin() < inch * 110 / 72);
  CHECK_FALSE(foot_of(1) == foot_of(2));
}

TEST_CASE("A paper that is not known is wrong usage, and --sheet alone is one picture as before", "[paper-sheet]") {
  const Untouched untouched;
  check_failure("render figure-5 --sheet=a5" + untouched.option, 2, {"--sheet", "a4", "letter-across"});
  const Folder folder;
  CHECK(run("render figure-5 --sheet --size 320x180" + option_out(folder)).exit_code == 0);
  CHECK(listing(folder.path() / "figure-5") == std::vector<std::string>{"000.png", "001.png", "002.png", "sheet.png"});
}
