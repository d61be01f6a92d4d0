#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace frame_choice_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

std::vector<std::size_t> places(const std::string& text, const Story& story) {
  return places_of(frames_in(text).value(), story.frames);
}

}  // namespace

TEST_CASE("Steps are chosen by numbers from 1, by ranges and by kinds, each once and in the order of the story") {
  const Story story = tell(walkthrough("figure-4-left"));
  CHECK(places("1", story) == std::vector<std::size_t>{0});
  CHECK(places("10,4,3-5", story) == std::vector<std::size_t>{2, 3, 4, 9});
  CHECK(places("end", story) == std::vector<std::size_t>{story.frames.size() - 1});
  for (const std::size_t i : places("regions", story)) CHECK(story.frames[i].focus == Focus::region);
  CHECK(static_cast<long>(places("regions", story).size()) ==
        std::ranges::count(story.frames, Focus::region, &Frame::focus));
  CHECK(places("end", tell(walkthrough("figure-2"))) == std::vector<std::size_t>{3});
}

TEST_CASE("What is no choice of frames is none") {
  for (const char* text :
       {"", ",", "1,", "0", "3-1", "-2", "2-", "1.5", "a", "region", " 1", "1;2", "99999999999999999999"}) {
    INFO(text);
    CHECK_FALSE(frames_in(text));
  }
}

TEST_CASE("Steps that a story does not have are objected to") {
  const Story story = tell(walkthrough("figure-1"));
  const auto objection = [&](const char* text) { return objection_to(frames_in(text).value(), story.frames); };
  CHECK(objection("1,end").empty());
  CHECK(objection("1-3") == "has 1 step, and no step 3; choose from 1 to 1");
  CHECK(objection("regions") == "has 1 step, and none is of these kinds; choose others, or leave it out");
}

TEST_CASE("Frames that are kept cover all events from the beginning to the last of them, each once") {
  for (const char* name : {"figure-4-left", "figure-4", "regions/3-simplex-face-adb-edge-ad", "figure-2"}) {
    INFO(name);
    Story story = tell(walkthrough(name));
    const Frame last = story.frames.back();
    const std::vector<std::size_t> kept = places("2,end", story);
    keep_only(story, kept);
    REQUIRE(story.frames.size() == 2);
    CHECK(story.frames[1].caption == last.caption);
    CHECK(story.diagrams.size() == (story.walkthrough.layout == Layout::diagrams ? 2 : 0));
    for (std::size_t s = 0; s < last.events.size(); ++s) {
      CHECK(story.frames[0].events[s].first == 0);
      CHECK(story.frames[1].events[s].last == last.events[s].last);
      CHECK(story.frames[1].events[s].first == std::min(story.frames[0].events[s].last + 1, last.events[s].last));
    }
  }
}

}  // namespace frame_choice_test
