// The frames: one for each event that changes the picture.

#include "walkthroughs/story/storyboard.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"

namespace storyboard_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

TEST_CASE("A search has one frame for each event that changes the picture, in order, of the moment after its event") {
  for (const Story& story : whole_searches()) {
    INFO(story.walkthrough.name);
    const auto events = shown(story);
    const bool returns = first_return(story.tellings[0].trace).has_value();
    REQUIRE(events.size() == story.frames.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      const bool is_return = returns && i + 2 == events.size();
      const Focus focus = is_return ? Focus::repetition : focus_of(events[i], story.walkthrough.naming).value();
      CHECK(story.frames[i].focus == focus);
      REQUIRE(story.frames[i].moments.size() == 1);
      const Moment& now = story.frames[i].moments[0];
      CHECK(now.iteration == iteration_of(events[i]));
      CHECK(now.result.has_value() == (story.frames[i].focus == Focus::end));
      if (const auto* e = std::get_if<gjk::SupportFound<double>>(&events[i])) CHECK(now.found->w == e->vertex.w);
      if (const auto* e = std::get_if<gjk::CrossingTested<double>>(&events[i])) CHECK(now.crossing->value == e->value);
      if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&events[i]))
        CHECK((now.added && now.processed.size() == e->simplex.size()));
      if (const auto* e = std::get_if<gjk::RegionTested<double>>(&events[i]))
        CHECK(now.regions.back().feature == e->feature);
      if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&events[i]))
        CHECK(now.simplex.size() == e->after.size());
      if (const auto* e = std::get_if<gjk::DirectionChosen<double>>(&events[i]))
        CHECK(now.direction->value == e->direction);
    }
  }
}

TEST_CASE("A frame for each step is the last one of its iteration") {
  const Story decisions = tell(walkthrough("figure-4-left")),
              steps = tell(walkthrough("figure-4-left"), Detail::iteration);
  const auto last = last_of_each_iteration(decisions.frames);
  REQUIRE(steps.frames.size() == last.size());
  for (std::size_t i = 0; i < last.size(); ++i) {
    const Frame& step = steps.frames[i];
    CHECK(step.moments[0].iteration == static_cast<int>(i) + 1);
    CHECK(step.caption == decisions.frames.at(last[i]).caption);
  }
  CHECK(steps.frames.back().focus == Focus::end);
}

/// Returns: the last of the events up to there of which something is said.
const gjk::Event<double>& last_shown(const Telling& telling, std::size_t event) {
  while (!telling.said[event]) --event;
  return telling.trace.events[event];
}

TEST_CASE("Of two searches each is drawn as it stands: one that has ended makes no test again") {
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.scenes.size() < 2 || w.layout == Layout::diagrams) continue;
    const Story story = tell(w);
    for (const Frame& f : story.frames)
      for (std::size_t s = 0; s < 2; ++s) {
        INFO(w.name << ", " << w.scenes[s].name << ": " << f.caption);
        const auto& event = last_shown(story.tellings[s], f.events[s].last);
        CHECK(f.focus_of(s) == focus_of(event, w.naming));
        CHECK(f.iterations()[f.iterations().size() == 1 ? 0 : s] == iteration_of(event));
      }
  }
  const Story steps = tell(walkthrough("mistakes/m2-first-point-tested"), Detail::iteration);
  REQUIRE(steps.frames.size() == 2);  // one search ends in the first iteration, the other in the second
  CHECK(steps.frames[1].iterations() == std::vector<int>{1, 2});
}

TEST_CASE("Frames cover the events of each run without a gap, and a run that has ended repeats its last") {
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.layout != Layout::search && w.layout != Layout::until_they_part && w.layout != Layout::in_step) continue;
    for (const Detail detail : {Detail::decision, Detail::iteration}) {
      const Story story = tell(w, detail);
      for (std::size_t s = 0; s < w.scenes.size(); ++s) {
        INFO(w.name << ", " << w.scenes[s].name);
        const std::size_t last = story.tellings[s].trace.events.size() - 1;
        std::size_t next = 0;
        for (const Frame& f : story.frames) {
          CHECK(f.events.at(s).first == std::min(next, last));
          CHECK(f.events.at(s).last >= f.events.at(s).first);
          next = f.events.at(s).last + 1;
        }
        CHECK(next == last + 1);
      }
    }
  }
}

}  // namespace storyboard_test
