// What is written beside pictures: the page and the captions of a walkthrough, and the page that compares pictures.

#include <regex>

#include "render/compare_report.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace golden_pages_test {

using namespace walkthroughs::program;

TEST_CASE("pages of a walkthrough, what they load, and its captions are the accepted ones") {
  const Walkthrough& w = *find_walkthrough("figure-4-right");
  const StagedStory story(tell(w));
  const PagePictures pictures{
      .url = [](std::size_t frame, int turn) { return std::to_string(frame) + "-" + std::to_string(turn) + ".png"; },
      .page = page_of_frame(Look()),
      .part = pictures_of_frame(w, {})};
  PageSurroundings around;
  around.command = "gjkstep render figure-4-right --page";
  around.sources = {{"scene.json", "a scene"}};
  around.ways = {{"../index.html", "All walkthroughs"}};
  around.has_files_beside = true;
  around.page_of = [](const std::string& name) { return "../" + name + "/index.html"; };
  for (const PageFile& file : page_files(story, pictures, around))
    if (file.name == page_file || file.name == story_file || file.name == events_file)
      golden::check_text("page/" + file.name, file.content, "pages");
  std::vector<FrameFile> files;
  for (std::size_t i = 0; i < story.frames.size(); ++i) files.push_back({std::to_string(i) + ".png", story, i});
  golden::check_text("page/captions.json", captions_json(files), "pages");
}

/// Without the pictures' bytes, which another zlib packs otherwise.
TEST_CASE("pages that compare pictures are the accepted ones") {
  using namespace render;
  const auto compared = [](const std::string& name, Color expected, Color actual) {
    ComparedFiles pair{.files = {name, "e/" + name, "a/" + name}, .words = {}, .expected = {}, .actual = {}};
    pair.expected = kit::plain({12, 8}, expected);
    pair.actual = kit::plain({12, 8}, actual);
    pair.comparison = compare(*pair.expected, *pair.actual);
    pair.verdict = pair.comparison.verdict;
    pair.words = in_words(pair.comparison);
    return pair;
  };
  CompareReport report({.expected = "e", .actual = "a", .expected_by = RenderedBy{{"FreeType", "2.12"}}});
  report.add(compared("same.png", palette::sky, palette::sky), "");
  report.add(compared("within.png", palette::sky, {85, 181, 234}), "");
  report.add(compared("different.png", palette::sky, palette::blue), "cp a/different.png e/different.png");
  ComparedFiles missing = compared("missing.png", palette::sky, palette::sky);
  missing.actual.reset();
  missing.verdict = Verdict::missing;
  missing.words = "only the expected side has it";
  report.add(missing, "rm e/missing.png");
  golden::check_text("page/compared.html", std::regex_replace(report.html(), std::regex("base64,[^\"]*"), "base64,"),
                     "pages");
}

}  // namespace golden_pages_test
