// Searches that go round in a circle: that they do, that a frame says so, and that the complete rules do not.

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/story/stories.hpp"

namespace cycles_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Status;

namespace {

const std::vector<std::string> cycles = {"cycle-separated", "cycle-intersecting"};

void check_last_but_one_tells(const Return& back, const Story& story) {
  CHECK(std::ranges::count(story.frames, Focus::repetition, &Frame::focus) == 1);
  const Frame& frame = story.frames.at(story.frames.size() - 2);
  CHECK(frame.focus == Focus::repetition);
  CHECK(frame.events[0].last == back.event);
  CHECK(kit::has(frame.caption, " iteration " + std::to_string(back.to_iteration) + ":"));
  CHECK(kit::has(frame.headline, " iteration " + std::to_string(back.to_iteration) + "."));
  CHECK(frame.facts.back().mark == Fact::Mark::no);
}

}  // namespace

TEST_CASE("A search that runs in circles ends undecided, as soon as it is back where it was, and a frame says so") {
  for (const std::string& name : cycles) {
    INFO(name);
    const Story story = tell(walkthrough(name));
    const Trace& trace = story.tellings[0].trace;
    const gjk::Result<double> result = all<gjk::Finished>(trace).at(0).result;
    CHECK(result.status == Status::undecided);
    CHECK(result.reason == gjk::Reason::cycle);
    CHECK(result.iterations == 9);
    const auto back = first_return(trace);
    REQUIRE(back);
    CHECK(result.cycle_start == back->to_iteration + 1);
    CHECK(back->event + 2 == trace.events.size());
    check_last_but_one_tells(*back, story);
  }
}

TEST_CASE("The two searches that run in circles do so without the crossing test too") {
  for (const std::string& name : cycles) {
    Walkthrough w = walkthrough(name);
    w.scenes[0].options.crossing_test = gjk::CrossingTest::off;
    const Story story = tell(w);
    CHECK(Told(w.scenes[0]).result().reason == gjk::Reason::cycle);
    const auto back = first_return(story.tellings[0].trace);
    REQUIRE(back);
    check_last_but_one_tells(*back, story);
  }
}

TEST_CASE(
    "Without the crossing test a search that is back with the same simplex may still end, and is told to its end") {
  Walkthrough w = walkthrough_of({{0, 1, 0}, {2, 4, -3}, {-1, 3, -1}, {1, 2, -4}, {4, 1, 3}, {-1, -3, -2}, {2, 4, 3}},
                                 {.crossing_test = gjk::CrossingTest::off});
  w.naming = Naming::roles;
  const Story story = tell(w);
  CHECK(Told(w.scenes[0]).result().reason == gjk::Reason::no_new_vertex);
  CHECK(std::ranges::count(story.frames, Focus::repetition, &Frame::focus) == 0);
  CHECK(story.frames.size() == shown(story).size());
  for (std::size_t i = 1; i < story.frames.size(); ++i)
    CHECK(story.frames[i].moments[0].iteration <= story.frames[i - 1].moments[0].iteration + 1);
}

TEST_CASE("The last frame tells how often a search goes round, as the study has it") {
  CHECK(kit::has(bytes_of(kit::source("tests/study/results") / "errors.md"), "| triangles | 4e-6 ("));
  for (const std::string& name : cycles) {
    const std::vector<Fact> facts = tell(walkthrough(name)).frames.back().facts;
    CHECK(std::ranges::any_of(facts, [](const Fact& fact) {
      return kit::has(fact.text, "Of a million random pairs of triangles 4 go round");
    }));
  }
}

}  // namespace cycles_test
