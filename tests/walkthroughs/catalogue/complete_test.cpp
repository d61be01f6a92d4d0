// The complete rules where the report's go round: what they ask, and that they end.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/story/decision.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

TEST_CASE("By the complete rules the pairs that run in circles are decided") {
  CHECK(Told("complete/cycle-separated").result().status == gjk::Status::separated);
  CHECK(Told("complete/cycle-intersecting").result().status == gjk::Status::intersecting);
  const Story both = tell(walkthrough("complete/beside-the-report"));
  CHECK(std::get<gjk::Finished<double>>(both.tellings[0].trace.events.back()).result.reason == gjk::Reason::cycle);
  CHECK(std::get<gjk::Finished<double>>(both.tellings[1].trace.events.back()).result.status == gjk::Status::separated);
}

TEST_CASE("Two searches of one pair are seen from one place") {
  const StagedStory story{tell(walkthrough("complete/beside-the-report"))};
  CHECK(story.stages[0].lens.camera->toward_viewer() == story.stages[1].lens.camera->toward_viewer());
}

TEST_CASE("Whether an edge leads toward the origin is shown in the plane of both") {
  int shown = 0;
  for (const char* const name : {"complete/cycle-separated", "complete/cycle-intersecting"}) {
    const Story story = tell(walkthrough(name));
    for (const Frame& frame : story.frames) {
      if (frame.focus != Focus::region || !asks_along_edge(frame.moments[0].regions.back())) continue;
      const gjk::RegionTested<double>& asked = frame.moments[0].regions.back();
      INFO(name << ": " << frame.caption);
      const auto views = decision_views(frame.moments[0], frame.focus);
      REQUIRE(views.size() == 1);
      CHECK(views[0].kind == DecisionView::Kind::segment);
      CHECK(views[0].face == asked.feature);
      const bool leads = frame.caption.find(" leads from A toward the origin.") != std::string::npos;
      CHECK(leads == (std::get<double>(asked.value) > 0));
      ++shown;
    }
  }
  CHECK(shown == 24);
}

TEST_CASE("What is left of a simplex by the complete rules lies nearest to the origin: the captions say so") {
  const Story story = tell(walkthrough("complete/cycle-separated"));
  const auto said = [&](const std::string& words) {
    return std::ranges::count_if(story.frames,
                                 [&](const Frame& f) { return f.caption.find(words) != std::string::npos; });
  };
  CHECK(said("The point nearest to the origin lies on edge AC.") == 1);
  CHECK(said("never find this out") == 1);
  CHECK(said("one face above which") == 0);
}
