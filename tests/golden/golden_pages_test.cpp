// What is written beside the pictures of a walkthrough: page and captions of one, and what is written of all of them.

#include <algorithm>

#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;

TEST_CASE("pages of a walkthrough, what they load, and its captions are the accepted ones") {
  const Walkthrough& w = *find_walkthrough("figure-4-right");
  const StagedStory story(tell(w));
  const PagePictures pictures{
      .url = [](std::size_t frame, int turn) { return std::to_string(frame) + "-" + std::to_string(turn) + ".png"; },
      .page = page_of_frame(Text::around),
      .part = pictures_of_frame(w, {})};
  PageSurroundings around;
  around.command = "gjkstep render figure-4-right --page";
  around.trace_command = "gjkstep trace figure-4-right";
  around.sources = {{"scene.json", "a scene"}};
  around.ways = {{"../index.html", "All walkthroughs"}};
  around.has_files = true;
  around.page_of = [](const std::string& name) { return "../" + name + "/index.html"; };
  golden::check_text("page/index.html", page_html(story, pictures, around), "pages");
  for (const PageFile& file : page_files(story, pictures, around))
    if (file.name == steps_file || file.name == events_file || file.name == questions_file)
      golden::check_text("page/" + file.name, file.content, "pages");
  std::vector<FrameFile> files;
  for (std::size_t i = 0; i < story.frames.size(); ++i) files.push_back({std::to_string(i) + ".png", story, i});
  golden::check_text("page/captions.json", captions_json(files), "pages");
}
