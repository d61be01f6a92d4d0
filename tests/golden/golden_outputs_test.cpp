// What is written beside the pictures of each walkthrough is what was accepted: its page, captions, places on paper and in a
// sheet; and what is written of all of them.

#include <sstream>

#include "tests/golden/checksum.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/output/paper_sheet.hpp"
#include "walkthroughs/output/sheet.hpp"
#include "walkthroughs/page/compare_page.hpp"
#include "walkthroughs/page/index_page.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/footer.hpp"
#include "walkthroughs/picture/movie.hpp"
#include "walkthroughs/program/listing.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace golden;
using namespace walkthroughs;

namespace {

PageSurroundings surroundings(const Walkthrough& w) {
  PageSurroundings around;
  around.command = "gjkstep render " + w.name;
  around.trace_command = "gjkstep trace " + w.name;
  around.sources = {{"scene.json", "a scene"}};
  around.ways = {{"../index.html", "All walkthroughs"}};
  around.has_files = w.name.size() % 2 == 0;
  around.page_of = [](const std::string& name) { return "../" + name + "/index.html"; };
  return around;
}

PagePictures pictures(const Walkthrough& w, const Look& look) {
  return {.url = [](std::size_t frame, int turn) { return std::to_string(frame) + "-" + std::to_string(turn); },
          .page = page_of_frame(look.text),
          .part = pictures_of_frame(w, look),
          .turns = w.name.size() % 3 == 0 ? 3 : 0,
          .is_dark = w.name.size() % 5 == 0};
}

std::string captions_of(const StagedStory& story) {
  std::vector<FrameFile> files;
  for (std::size_t i = 0; i < story.frames.size(); ++i) files.push_back({"frame.png", story, i});
  return captions_json(files);
}

void add(Checksum& sum, const PaperLayout& layout) {
  for (const double number :
       {layout.letters, layout.picture_width, layout.picture_height, layout.words_width, layout.look.style.theme.text})
    sum.add(number);
  sum.add(long{layout.words_below});
  for (const double height : layout.heights) sum.add(height);
  for (const auto& page : layout.pages) sum.add(static_cast<long>(page.size()));
}

std::string layouts_of(const StagedStory& story, render::Font& font) {
  Checksum sum;
  const std::size_t which = story.frames.size() + story.walkthrough.name.size();
  const Output output{.folder = {}, .size = frame_page, .look = {.text = which % 4 == 0 ? Text::none : Text::around}};
  const char* paper = std::array{"a4", "letter-across", "a4-across", "letter"}[which % 4];
  const bool is_laid_out = which % 5 == 0;  // which takes the time of all else
  for (const bool larger_text : {false, true})
    if (is_laid_out) add(sum, paper_layout(story, output, paper_named(paper).value(), larger_text, font));
  const SheetLayout sheet = sheet_layout(static_cast<int>(story.frames.size()), output);
  for (const int number : {sheet.columns, sheet.frame.width, sheet.cell.height, sheet.top(sheet.count - 1),
                           sheet.size().width, sheet.size().height})
    sum.add(long{number});
  return sum.text();
}

/// The words of its first and last frames, as they stand on paper.
std::string words_of(const StagedStory& story, render::Font& font) {
  const Look look;
  render::Canvas canvas({400, 400}, {400, 400}, look.style.theme.paper, font);
  Checksum sum;
  for (const std::size_t index : {std::size_t{0}, story.frames.size() - 1})
    sum.add(draw_words(canvas, 380, story, index, look.style));
  sum.add(canvas);
  return sum.text();
}

/// Returns: its name, then checksums of page, captions, layouts and words on paper.
std::string line_of(const StagedStory& story, render::Font& font) {
  const Walkthrough& w = story.walkthrough;
  std::string page = page_html(story, pictures(w, {}), surroundings(w));
  for (const PageFile& file : page_files(story, pictures(w, {}), surroundings(w)))
    if (file.name == steps_file || file.name == events_file || file.name == questions_file) page += file.content;
  return w.name + " " + checksum_of(page) + " " + checksum_of(captions_of(story)) + " " + layouts_of(story, font) +
         " " + words_of(story, font);
}

std::string lists() {
  std::ostringstream out;
  write_list(out, catalogue());
  std::vector<const Walkthrough*> all;
  for (const Walkthrough& w : catalogue()) all.push_back(&w);
  write_table(out, all);
  for (const Movie movie : {Movie::mp4, Movie::gif}) out << ffmpeg_line(movie, "a folder's", 0.4, {1, 2, 250});
  for (const int count : {1, 3, 4, 5, 999, 5000}) {
    const SheetLayout sheet = sheet_layout(count, {.folder = {}, .size = {8192, 16}, .look = {}});
    out << sheet.columns << " " << sheet.cell.width << " " << sheet.size().height << "\n";
  }
  return out.str();
}

}  // namespace

TEST_CASE("outputs of all walkthroughs are as accepted") {
  if (!letters_are_those_accepted()) return;
  render::Font font(render::Font::default_directory());
  std::vector<std::string> now;
  std::vector<IndexEntry> entries;
  for (const Walkthrough& w : catalogue()) {
    const StagedStory story(tell(w));
    now.push_back(line_of(story, font));
    entries.push_back(index_entry(story, pictures(story.walkthrough, {})));
  }
  now.push_back("lists " + checksum_of(lists()));
  now.push_back("pages-of-all " + checksum_of(index_html(entries, "compare.html") + compare_html(comparable(entries))));
  check_lines("outputs.txt", now, "outputs", [&](std::size_t i, const std::string& accepted) {
    return "'" + accepted + "' is now '" + now[i] + "' (page, captions, places and words on paper)";
  });
}
