// Sheets of paper: what stands on which page and how large, the file, and what a reader of PDF files finds in it.
#include "walkthroughs/output/paper_sheet.hpp"

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/support.hpp"

namespace paper_sheet_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
namespace fs = std::filesystem;
using render::OnPaper;

namespace {

constexpr const char* papers[] = {"a4", "letter-across"};

PaperSheet sheet_of(const std::string& name, const std::string& paper, const Look& look = {}, bool larger_text = true) {
  static render::Font font{render::Font::default_directory()};
  return paper_sheet(StagedStory(tell(walkthrough(name))), look, paper_named(paper).value(), larger_text, font);
}

/// Returns: where it is on the page.
render::Box place_of(const OnPaper& part) {
  return {part.corner, part.corner + part.scale * (part.part.max - part.part.min)};
}

std::size_t frames_of(const std::string& name) { return StagedStory(tell(walkthrough(name))).frames.size(); }

std::string option_out(const Folder& folder) { return " --out " + quoted(folder.path().string()); }

/// Returns: the least size of its letters, in points, in the unit in which they stand on paper.
double least_letters(const OnPaper& part) {
  double least = 1000;
  for (const render::Shape& shape : part.canvas->shapes())
    if (const auto* text = std::get_if<render::shape::Text>(&shape)) least = std::min(least, text->style.size);
  return least * part.scale;
}

}  // namespace

TEST_CASE("Letters on paper have 7 points or more, and every frame stands on one page, in order, beside no other",
          "[paper-sheet][unsanitized][full]") {
  for (const char* name : {"figure-8", "figure-5", "as-printed-spheres", "regions/2-simplex-r3", "figure-4-left"})
    for (const char* paper : papers) {
      INFO(name << " on " << paper);
      const PaperSheet sheet = sheet_of(name, paper);
      CHECK(sheet.letters >= least_points);
      std::vector<const render::Canvas*> panels;
      for (const render::PdfPage& page : sheet.pages) {
        REQUIRE(page.size() >= 3);  // panels and words, title and number
        for (std::size_t i = 0; i + 1 < page.size(); ++i) {
          const render::Box place = place_of(page[i]), on_paper = place_of(page.back());
          CHECK(least_letters(page[i]) >= least_points - 1e-9);
          CHECK(place.min.x() >= 30);
          CHECK(place.min.y() >= 60);
          CHECK(place.max.x() <= on_paper.max.x() - 30);
          CHECK(place.max.y() <= on_paper.max.y() - 50);
          for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(place.grown(-0.5).overlaps(place_of(page[j])));
          if (i % 2 == 0) panels.push_back(page[i].canvas);
        }
      }
      REQUIRE(panels.size() == frames_of(name));
      for (std::size_t i = 0; i < panels.size(); ++i) CHECK(panels[i] == &sheet.canvases[i]);
    }
}

TEST_CASE("The panels are as small as their letters may be, so that many frames stand on a page", "[paper-sheet]") {
  const PaperSheet sheet = sheet_of("figure-4-left", "a4");
  CHECK(sheet.letters == Approx(least_points).margin(1e-9));
  CHECK(sheet.pages.size() == 6);  // of 18 frames
  CHECK(sheet_of("figure-4-left", "a4-across").columns == 2);
}

TEST_CASE("Letters whose size was asked for keep it on paper", "[paper-sheet]") {
  const auto width = [](bool larger_text) {
    return place_of(sheet_of("figure-4-left", "a4", {}, larger_text).pages[0][0]).width();
  };
  CHECK(width(false) > width(true) + 50);
}

TEST_CASE("Without captions nothing stands beside the panels", "[paper-sheet]") {
  const PaperSheet sheet = sheet_of("figure-4-left", "a4", {.text = Text::none});
  CHECK(sheet.canvases.size() == frames_of("figure-4-left") + sheet.pages.size());
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

TEST_CASE("gjkstep render --sheet=a4 writes one PDF file, the same each time", "[paper-sheet][full]") {
  const Folder folder, again;
  const std::string command = "render figure-4-right --size 320x180 --sheet=a4";
  const Outcome outcome = run(command + option_out(folder));
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const fs::path file = folder.path() / "figure-4-right" / "sheet.pdf";
  CHECK(has(outcome.out, file.string() + "  Figure 4, right"));
  run(command + option_out(again));
  CHECK(bytes_of(again.path() / "figure-4-right" / "sheet.pdf") == bytes_of(file));
}

TEST_CASE("A reader of PDF files finds the pages of a sheet, their size, their words and numbers, and no date",
          "[paper-sheet][full]") {
  if (!has(shell("pdfinfo -v").err, "pdfinfo version")) return kit::skip("there is no pdfinfo");
  const Folder folder;
  CHECK(run("render figure-4-right --size 320x180 --sheet=letter" + option_out(folder)).exit_code == 0);
  const std::string file = quoted((folder.path() / "figure-4-right" / "sheet.pdf").string());
  const std::string info = shell("pdfinfo " + file).out;
  INFO(info);
  CHECK(has(info, "Pages:           2\n"));
  CHECK(has(info, "612 x 792 pts (letter)"));
  CHECK(has(info, walkthrough("figure-4-right").title));
  CHECK_FALSE(has(info, "Date"));
  for (const std::string page : {"1", "2"}) {
    const std::string words = shell("pdftotext -f " + page + " -l " + page + " " + file + " -").out;
    CHECK(has(words, walkthrough("figure-4-right").title + "\n"));
    CHECK(has(words, "page " + page + " of 2\n"));
    CHECK(has(words, "step " + std::string(page == "1" ? "3" : "6")));
  }
}

TEST_CASE("The colour of the theme fills the page to the last column and row", "[paper-sheet][full]") {
  if (!has(shell("pdftoppm -v").err, "pdftoppm version")) return kit::skip("there is no pdftoppm");
  const Folder folder;  // on dark paper, beside which the PDF's own is seen
  CHECK(run("render figure-4-right --size 320x180 --theme dark --sheet=letter" + option_out(folder)).exit_code == 0);
  const std::string drawn = (folder.path() / "drawn").string();
  shell("pdftoppm -png -r 100 -l 1 " + quoted((folder.path() / "figure-4-right" / "sheet.pdf").string()) + " " +
        quoted(drawn));
  const render::Image page = render::read_png(drawn + "-1.png").image;
  REQUIRE(page.size() == render::Size{850, 1100});
  for (const int x : {0, 849})
    for (const int y : {0, 1099}) CHECK(page.pixel(x, y).r < 128);
}

TEST_CASE("A paper that is not known is wrong usage, and --sheet alone is one picture as before", "[paper-sheet]") {
  const Untouched untouched;
  check_failure("render figure-5 --sheet=a5" + untouched.option, 2, {"--sheet", "a4", "letter-across"});
  const Folder folder;
  CHECK(run("render figure-5 --sheet --size 320x180" + option_out(folder)).exit_code == 0);
  CHECK(listing(folder.path() / "figure-5") == std::vector<std::string>{"000.png", "001.png", "002.png", "sheet.png"});
}

}  // namespace paper_sheet_test
