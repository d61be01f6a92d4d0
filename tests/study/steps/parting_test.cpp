#include "tests/study/steps/parting.hpp"

#include <algorithm>

#include "tests/catch.hpp"

namespace study {
namespace {

/// M14's search on the pair of the recipe, as its program tells it.
ToldRun wrong_order() {
  return {{"m14-1", "smallest", {Points{{0, 1, 1}, {0, -1, -1}}, Points{{1, 0, 1}, {0, 1, 0}, {-1, -1, -1}}}},
          {{{1, 0, 0}, {{1, 2, 2}}},
           {{-1, -2, -2}, {{1, 2, 2}, {-1, -1, -2}}},
           {{3, -10, 6}, {{1, 2, 2}, {-1, -1, -2}, {0, -2, -1}}},
           {{-7, -2, 5}, {{0, -2, -1}, {-1, 1, 0}}}},
          Said::separated};
}

TEST_CASE(
    "Parting: the mistake and the report's algorithm are told beside each other, and part where the step is wrong",
    "[steps]") {
  const ToldRun run = wrong_order();
  const StepsChecked checked = check_steps(run);
  REQUIRE(checked.iteration == 3);
  const auto parting = parting_of(run, checked);
  REQUIRE(parting);
  const walkthroughs::Story story = parting->story();
  const auto part = std::ranges::find(story.frames, walkthroughs::Focus::parting, &walkthroughs::Frame::focus);
  REQUIRE(part != story.frames.end());
  CHECK(part->moments.front().iteration == 3);
  CHECK(story.frames.back().moments.front().iteration == 4);
  REQUIRE(part->facts.size() == 2);
  CHECK((part->facts[0].text.starts_with("M14: ") && part->facts[0].mark == walkthroughs::Fact::Mark::no));
  CHECK((part->facts[1].text.starts_with("the report: ") && part->facts[1].mark == walkthroughs::Fact::Mark::yes));
}

TEST_CASE("Parting: there is none of a search that is right, or that no mistake explains", "[steps]") {
  ToldRun run = wrong_order();
  CHECK_FALSE(parting_of(run, {}));
  run.steps.resize(1);
  run.steps[0].simplex = {{-1, 0, 0}};
  const StepsChecked checked = check_steps(run);
  CHECK(checked.iteration == 1);
  CHECK_FALSE(parting_of(run, checked));
}

}  // namespace
}  // namespace study
