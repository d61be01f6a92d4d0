// Walkthroughs of two searches: Figure 4 iteration by iteration, and Algorithm 1 as printed beside its text.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/trace/trace_json.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::Status;

namespace {

Status status_of(const Telling& telling) { return all<gjk::Finished>(telling.trace).at(0).result.status; }

/// Returns: the first place where the two traces differ, by all that a trace file says of an event.
std::size_t parting_of(const Trace& left, const Trace& right) {
  std::size_t i = 0;
  while (left.events.at(i) == right.events.at(i)) ++i;
  return i;
}

}  // namespace

// -- Figure 4 in step -------------------------------------------------------------------------------------------------

TEST_CASE("Figure 4 in step shows the sets of its halves, both without the crossing test") {
  CHECK(Told("figure-4", 0).hull.corners == Told("figure-4-left").hull.corners);
  CHECK(Told("figure-4", 1).hull.corners == Told("figure-4-right").hull.corners);
  for (const Scene& scene : walkthrough("figure-4").scenes)
    CHECK(scene.options.crossing_test == gjk::CrossingTest::off);
}

TEST_CASE("Figure 4 in step has one frame for each iteration, which both scenes have just finished") {
  const Story story = tell(walkthrough("figure-4"));
  REQUIRE(story.frames.size() == 4);
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const Frame& frame = story.frames[i];
    REQUIRE(frame.moments.size() == 2);
    for (std::size_t s = 0; s < 2; ++s) {
      const auto& events = story.tellings[s].trace.events;
      const std::size_t last = frame.events[s].last;
      CHECK(frame.moments[s].iteration == static_cast<int>(i) + 1);
      CHECK(iteration_of(events.at(last)) == static_cast<int>(i) + 1);
      CHECK((last + 1 == events.size() || iteration_of(events[last + 1]) == static_cast<int>(i) + 2));
    }
  }
}

TEST_CASE("Figure 4 in step ends with E, F, G on the left and without a new point on the right") {
  const Story story = tell(walkthrough("figure-4"));
  CHECK(status_of(story.tellings[0]) == Status::intersecting);
  CHECK(status_of(story.tellings[1]) == Status::separated);
  const Frame& last = story.frames.back();
  for (std::size_t s = 0; s < 2; ++s) CHECK(last.focus_of(s) == Focus::end);
  CHECK(last.facts.at(0).text == "left: The origin lies in triangle EFG, so the objects intersect.");
  CHECK(last.facts.at(1).text == "right: The difference does not contain the origin, so the objects do not intersect.");
}

// -- Where two runs part ----------------------------------------------------------------------------------------------

TEST_CASE("As printed Algorithm 1 finds a collision of two spheres that its text finds apart") {
  const Story story = tell(walkthrough("as-printed-spheres"));
  REQUIRE(story.tellings.size() == 2);
  CHECK(story.tellings[0].scene.rules == RuleSet::as_printed);
  CHECK(story.tellings[1].scene.rules == RuleSet::as_intended);
  CHECK(status_of(story.tellings[0]) == Status::intersecting);
  CHECK(status_of(story.tellings[1]) == Status::separated);
}

TEST_CASE("The spheres of both runs are the same, and farther apart than their radii") {
  const Walkthrough& w = walkthrough("as-printed-spheres");
  for (const Scene& scene : w.scenes) {
    const Ball a = std::get<Ball>(scene.a.form), b = std::get<Ball>(scene.b.form);
    CHECK((a.center - b.center).norm() > a.radius + b.radius);
    CHECK(a.center == std::get<Ball>(w.scenes[0].a.form).center);
    CHECK(b.center == std::get<Ball>(w.scenes[0].b.form).center);
  }
}

TEST_CASE("The first event that differs between two runs is marked, and no other") {
  for (const char* const name : {"as-printed-spheres", "eager-between-centers"}) {
    const Story story = tell(walkthrough(name));
    const std::size_t parting = parting_of(story.tellings[0].trace, story.tellings[1].trace);
    CHECK(parting > 0);
    CHECK(std::ranges::count(story.frames, Focus::parting, &Frame::focus) == 1);
    for (const Frame& frame : story.frames) {
      const std::size_t last = std::max(frame.events.at(0).last, frame.events.at(1).last);
      CHECK((frame.focus == Focus::parting) == (last == parting));
      CHECK(frame.caption.starts_with("Both: ") == (last < parting));
    }
  }
}

TEST_CASE("From center to center eager rules need one point where the report's need two") {
  const Story story = tell(walkthrough("eager-between-centers"));
  const auto result = [&](std::size_t s) { return all<gjk::Finished>(story.tellings.at(s).trace).at(0).result; };
  CHECK(story.tellings[0].scene.rules == RuleSet::eager);
  CHECK(story.tellings[1].scene.rules == RuleSet::as_intended);
  CHECK(result(0).status == Status::separated);
  CHECK(result(1).status == Status::separated);
  CHECK(result(0).iterations == 1);
  CHECK(result(1).iterations == 2);
  for (const Frame& frame : story.frames)  // neither is wrong
    for (const Fact& fact : frame.facts) CHECK((frame.caption.starts_with("Both: ") || fact.mark == Fact::Mark::yes));
}

TEST_CASE("Until two runs part both scenes show the same event, after that each its own or its last") {
  const Story story = tell(walkthrough("as-printed-spheres"));
  const std::size_t parting = parting_of(story.tellings[0].trace, story.tellings[1].trace);
  for (const Frame& frame : story.frames) {
    const std::size_t last = std::max(frame.events[0].last, frame.events[1].last);
    for (std::size_t s = 0; s < 2; ++s) {
      CHECK(frame.events[s].last == std::min(last, story.tellings[s].trace.events.size() - 1));
      CHECK((last >= parting || frame.events[s].last == last));
    }
  }
  for (std::size_t s = 0; s < 2; ++s) CHECK(story.frames.back().moments[s].result.has_value());
}
