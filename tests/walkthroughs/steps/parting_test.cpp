#include "walkthroughs/steps/parting.hpp"

#include <algorithm>
#include <limits>

#include "tests/kit/catch.hpp"
#include "walkthroughs/judge/case.hpp"

namespace walkthroughs::steps {
namespace parting_test {

/// M14's search on the pair of the recipe, as its program tells it.
ToldRun wrong_order() {
  return {"m14-1",
          {Points{{0, 1, 1}, {0, -1, -1}}, Points{{1, 0, 1}, {0, 1, 0}, {-1, -1, -1}}},
          {{{1, 0, 0}, {{1, 2, 2}}},
           {{-1, -2, -2}, {{1, 2, 2}, {-1, -1, -2}}},
           {{3, -10, 6}, {{1, 2, 2}, {-1, -1, -2}, {0, -2, -1}}},
           {{-7, -2, 5}, {{0, -2, -1}, {-1, 1, 0}}}},
          gjk::Status::separated};
}

TEST_CASE(
    "Parting: the mistake and the report's algorithm are told beside each other, and part where the step is wrong",
    "[steps]") {
  const ToldRun run = wrong_order();
  const StepFindings found = check_steps(run).findings;
  REQUIRE(first_wrong(found)->iteration == 3);
  const auto parting = parting_of(run, *first_wrong(found));
  REQUIRE(parting);
  const story::Story story = parting->story();
  const auto part = std::ranges::find(story.frames, story::Focus::parting, &story::Frame::focus);
  REQUIRE(part != story.frames.end());
  CHECK(part->moments.front().iteration == 3);
  CHECK(story.frames.back().moments.front().iteration == 4);
  REQUIRE(part->facts.size() == 5);
  CHECK((part->facts[0].text.starts_with("M14: ") && part->facts[0].mark == story::Fact::Mark::no));
  CHECK((part->facts[2].text.starts_with("the report: ") && part->facts[2].mark == story::Fact::Mark::yes));
}

TEST_CASE("Parting: there is none where what is told are no numbers", "[steps]") {
  ToldRun run = wrong_order();
  run.steps[1].direction[0] = std::numeric_limits<double>::quiet_NaN();
  const StepFindings found = check_steps(run).findings;
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].iteration == 2);
  CHECK_FALSE(parting_of(run, found[0]));
}

/// Returns: the frame where they part, of steps that no mistake explains.
story::Frame own_parting(const ToldRun& run, int iteration) {
  const StepFindings found = check_steps(run).findings;
  const StepFinding& wrong = *first_wrong(found);
  REQUIRE(wrong.iteration == iteration);
  const auto parting = parting_of(run, wrong);
  REQUIRE(parting);
  const story::Story story = parting->story();
  const auto part = std::ranges::find(story.frames, story::Focus::parting, &story::Frame::focus);
  REQUIRE(part != story.frames.end());
  CHECK(part->moments.front().iteration == iteration);
  CHECK(part->caption == "Here the two runs part: " + wrong.words + ".");
  const auto& end = std::get<gjk::Finished<double>>(parting->traces[1].events.back()).result;
  CHECK((end.status == gjk::Status::intersecting) == (judge::truth_of(run.pair) == gjk::Status::intersecting));
  CHECK(end.status != gjk::Status::undecided);
  REQUIRE(part->facts.size() == 2);
  CHECK((part->facts[0].text.starts_with("yours: ") && part->facts[0].mark == story::Fact::Mark::no));
  CHECK((part->facts[1].text.starts_with("the report: ") && part->facts[1].mark == story::Fact::Mark::yes));
  return *part;
}

TEST_CASE("Parting: steps that no mistake explains are told themselves, and part where they are wrong", "[steps]") {
  ToldRun run = wrong_order();
  run.steps.resize(1);
  run.steps[0].simplex = {{-1, 0, 0}};  // no farthest point
  CHECK(own_parting(run, 1).facts[1].text.find("The support point along +x is P") != std::string::npos);
  run = wrong_order();
  run.steps.resize(3);
  run.steps[2].simplex = {{0, -2, -1}};  // too much is dropped
  CHECK(own_parting(run, 3).facts[0].text.find("drop ") != std::string::npos);
  run = wrong_order();
  run.steps.resize(3);
  run.steps[2].direction = {3, 10, 6};  // after two vertices rightly kept
  CHECK(own_parting(run, 2).facts[0].text.find("The next direction d leads from segment") != std::string::npos);
}

}  // namespace parting_test
}  // namespace walkthroughs::steps
