// Searches that go round in a circle: that they do, and that a frame says so.

#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::test::exact;
using gjk::test::ExactVecs;

namespace {

const std::vector<std::string> cycles = {"cycle-separated", "cycle-intersecting"};

bool intersect(const Scene& scene) {
  ExactVecs differences;
  for (const Point& a : vertices_of(scene.a))
    for (const Point& b : vertices_of(scene.b)) differences.push_back(exact(a) - exact(b));
  return gjk::test::contain_origin(differences);
}

}  // namespace

TEST_CASE("Of the two pairs that run in circles one is apart and one is not") {
  CHECK_FALSE(intersect(walkthrough("cycle-separated").scenes[0]));
  CHECK(intersect(walkthrough("cycle-intersecting").scenes[0]));
}

TEST_CASE("A search that runs in circles ends undecided, as soon as it is back where it was") {
  for (const std::string& name : cycles) {
    INFO(name);
    const Told told(name);
    const gjk::Result<double> result = told.result();
    CHECK(result.status == gjk::Status::undecided);
    CHECK(result.reason == gjk::Reason::cycle);
    CHECK(result.iterations == 9);
    const auto back = first_return(told.trace);
    REQUIRE(back);
    CHECK(result.cycle_start == back->to_iteration + 1);
    CHECK(back->event + 2 == told.trace.events.size());
  }
}

TEST_CASE("One frame, the last but one, says which iteration the search is back in") {
  for (const std::string& name : cycles) {
    INFO(name);
    const Story story = tell(walkthrough(name));
    const Trace& trace = story.tellings[0].trace;
    const Return back = first_return(trace).value();
    CHECK(std::ranges::count(story.frames, Focus::repetition, &Frame::focus) == 1);
    const Frame& frame = story.frames.at(story.frames.size() - 2);
    CHECK(frame.focus == Focus::repetition);
    CHECK(frame.events[0].last == back.event);
    CHECK(frame.caption.find(" iteration " + std::to_string(back.to_iteration) + ":") != std::string::npos);
    CHECK(frame.headline.find(" iteration " + std::to_string(back.to_iteration) + ".") != std::string::npos);
    CHECK(frame.facts.back().mark == Fact::Mark::no);
  }
}

TEST_CASE("Where no search comes back no frame says so") {
  for (const Story& story : whole_searches()) {
    const bool returns = first_return(story.tellings[0].trace).has_value();
    CHECK(returns == (std::ranges::count(cycles, story.walkthrough.name) == 1));
    CHECK(returns == (std::ranges::count(story.frames, Focus::repetition, &Frame::focus) == 1));
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

TEST_CASE("The two searches that run in circles do so without the crossing test too") {
  for (const std::string& name : cycles) {
    Walkthrough w = walkthrough(name);
    w.scenes[0].options.crossing_test = gjk::CrossingTest::off;
    const Story story = tell(w);
    const auto back = first_return(story.tellings[0].trace);
    CHECK(Told(w.scenes[0]).result().reason == gjk::Reason::cycle);
    REQUIRE(back);
    const Frame& frame = story.frames.at(story.frames.size() - 2);
    CHECK(frame.focus == Focus::repetition);
    CHECK(frame.events[0].last == back->event);
  }
}

TEST_CASE("The last frame tells why it goes round, how often, as the study has it, and what helps") {
  const std::string measured = bytes_of(kit::source("tests/study/results") / "errors.md");
  CHECK(measured.find("| triangles | 4e-6 (") != std::string::npos);
  for (const std::string& name : cycles) {
    INFO(name);
    const std::vector<Fact> facts = tell(walkthrough(name)).frames.back().facts;
    REQUIRE(facts.size() >= 2);
    CHECK(facts[1].text.find("Of a million random pairs of triangles 4 go round") != std::string::npos);
    CHECK(facts[1].text.find("the complete rules end, but where numbers round; a certified answer always does") !=
          std::string::npos);
  }
}
