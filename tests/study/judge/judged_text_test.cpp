#include "tests/study/judge/judged_text.hpp"

#include <nlohmann/json.hpp>

#include "tests/kit/catch.hpp"

namespace study {
namespace {

/// Wrong steps of one mistake, and one that rounding may explain.
ProgramJudged with_steps(const JudgedSteps& other) {
  ProgramJudged judged;
  judged.steps = {{"p", 3, "words", {6}}, {"q", 2, "words", {6, 8}}, {"r", 0, "every step is right"}, other};
  return judged;
}

bool says(const ProgramJudged& judged, const std::string& sentence) {
  return judged_markdown(judged, {}).find(sentence) != std::string::npos;
}

TEST_CASE("Judge: what makes most of the wrong steps is told, those left out that rounding may explain", "[judge]") {
  CHECK(says(with_steps({"s", 4, "words", {8}}),
             "Of these 3 wrong steps 2 follow from M7, M9: no mistake of the study makes them all."));
  const ProgramJudged rounded = with_steps({.pair = "s", .iteration = 4, .words = "words", .may_be_rounding = true});
  CHECK(says(rounded, "Of these 2 wrong steps 2 follow from M7."));
  const auto steps = nlohmann::json::parse(judged_json(rounded, {}))["steps"];
  REQUIRE(steps.size() == 4);
  CHECK_FALSE(steps[0].contains("may_be_rounding"));
  CHECK(steps[3]["may_be_rounding"] == true);
}

}  // namespace
}  // namespace study
