// Walkthroughs of two searches: where they part, and what each frame shows of both.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/trace/trace_json.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::Status;

namespace {

gjk::Result<double> result_of(const Telling& telling) { return all<gjk::Finished>(telling.trace).at(0).result; }

/// Returns: the first place where the two traces differ, by all that a trace file says of an event.
std::size_t parting_of(const Story& story) {
  const auto &left = story.tellings[0].trace.events, &right = story.tellings[1].trace.events;
  std::size_t i = 0;
  while (left.at(i) == right.at(i)) ++i;
  return i;
}

}  // namespace

TEST_CASE("As printed Algorithm 1 finds a collision of two spheres farther apart than their radii, its text does not") {
  const Story story = tell(walkthrough("as-printed-spheres"));
  CHECK(story.tellings.at(0).scene.rules == RuleSet::as_printed);
  CHECK(story.tellings.at(1).scene.rules == RuleSet::as_intended);
  CHECK(result_of(story.tellings[0]).status == Status::intersecting);
  CHECK(result_of(story.tellings[1]).status == Status::separated);
  for (const Telling& telling : story.tellings) {
    const Ball a = std::get<Ball>(telling.scene.a.form), b = std::get<Ball>(telling.scene.b.form);
    CHECK((a.center - b.center).norm() > a.radius + b.radius);
    CHECK(a.center == std::get<Ball>(story.tellings[0].scene.a.form).center);
    CHECK(b.center == std::get<Ball>(story.tellings[0].scene.b.form).center);
  }
}

TEST_CASE("From center to center eager rules need one point where the report's need two, and neither is wrong") {
  const Story story = tell(walkthrough("eager-between-centers"));
  CHECK(story.tellings.at(0).scene.rules == RuleSet::eager);
  CHECK(story.tellings.at(1).scene.rules == RuleSet::as_intended);
  for (std::size_t s = 0; s < 2; ++s) {
    CHECK(result_of(story.tellings[s]).status == Status::separated);
    CHECK(result_of(story.tellings[s]).iterations == static_cast<int>(s) + 1);
  }
  for (const Frame& frame : story.frames)
    for (const Fact& fact : frame.facts) CHECK((frame.caption.starts_with("Both: ") || fact.mark == Fact::Mark::yes));
}

TEST_CASE(
    "Until two runs part both scenes show the same event, which one frame marks, after that each its own or its last") {
  for (const char* const name : {"as-printed-spheres", "eager-between-centers"}) {
    const Story story = tell(walkthrough(name));
    const std::size_t parting = parting_of(story);
    CHECK(parting > 0);
    CHECK(std::ranges::count(story.frames, Focus::parting, &Frame::focus) == 1);
    for (const Frame& frame : story.frames) {
      const std::size_t last = std::max(frame.events.at(0).last, frame.events.at(1).last);
      CHECK((frame.focus == Focus::parting) == (last == parting));
      CHECK(frame.caption.starts_with("Both: ") == (last < parting));
      for (std::size_t s = 0; s < 2; ++s) {
        CHECK(frame.events[s].last == std::min(last, story.tellings[s].trace.events.size() - 1));
        CHECK((last >= parting || frame.events[s].last == last));
      }
    }
    for (std::size_t s = 0; s < 2; ++s) CHECK(story.frames.back().moments[s].result.has_value());
  }
}
