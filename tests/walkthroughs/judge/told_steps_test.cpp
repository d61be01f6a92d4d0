// A GJK of another style tells its steps, with a fault in them or without.
#include "walkthroughs/judge/told_steps.hpp"

#include <algorithm>

#include "tests/kit/catch.hpp"
#include "walkthroughs/pairs/families.hpp"
#include "walkthroughs/steps/mistakes.hpp"

namespace walkthroughs::judge {
namespace told_steps_test {

AskedProgram telling(const std::string& fault) {
  return {.words = {"env", "FAULT=" + fault, JUDGED_PLANTED},
          .limit = std::chrono::seconds(60),
          .is_answer = is_meant_as_answer};
}

StepsLooked looked_at(const AskedProgram& program, const std::vector<const Family*>& families) {
  std::vector<NamedPair> kept = kept_pairs();
  std::erase_if(kept, [](const NamedPair& each) { return !points_of(each.pair) || each.family != "smallest"; });
  return look_at_steps(program,
                       judge(program, cases_of(std::move(kept), families, 50, 1, {}), {}, 10, [](auto, auto) {}));
}

TEST_CASE(
    "Told steps: the mistake that makes the first wrong ones stands first, and what later ones repair is counted") {
  const StepsLooked looked = looked_at(telling("m14"), {&family_named("grid-tetrahedra")});
  CHECK(looked.searches > 50);
  CHECK(looked.wrong > looked.repaired);
  CHECK(looked.repaired > 0);
  std::vector<Cause> causes{{"another", "", 0.9}};
  add_cause(looked, causes);
  REQUIRE(causes.size() == 2);
  CHECK(causes.front().name.starts_with("M14: "));
  CHECK(causes.front().mistake == "m14-order-below-triangle");
  REQUIRE(looked.shown());
  CHECK(words_of_first_wrong(*looked.shown()).find(": keeps [C, B, A] where the report keeps [C, A, B]") !=
        std::string::npos);
}

TEST_CASE("Told steps: a direction that is not changed is named") {
  const StepsLooked looked = looked_at(telling("stale"), {&family_named("boxes")});
  std::vector<Cause> causes;
  add_cause(looked, causes);
  REQUIRE(causes.size() == 1);
  CHECK(causes.front().name == "the direction is not changed");
}

TEST_CASE("Told steps: of who makes no wrong step none is told, be the first point told or not") {
  const AskedProgram program = telling(GENERATE("none", "untold"));
  const StepsLooked looked = look_at_steps(
      program, judge(program, cases_of({}, {&family_named("triangles"), &family_named("boxes")}, 50, 1, {}), {}, 10,
                     [](auto, auto) {}));
  CHECK(looked.searches > 50);
  CHECK(looked.steps > looked.searches);
  CHECK((looked.wrong == 0 && looked.rounding == 0 && looked.shown() == nullptr));
  const auto is_seen_not_to_be_made = [](const StepsLooked::Mistake& each) { return each.not_made > 0; };
  CHECK(std::ranges::count_if(looked.by_mistake, is_seen_not_to_be_made) > 5);
  std::vector<Cause> causes;
  add_cause(looked, causes);
  CHECK(causes.empty());
}

TEST_CASE("Told steps: who answers wrongly before the first step is told that") {
  const StepsLooked looked = looked_at(telling("translation"), {&family_named("offset-1e8")});
  CHECK(looked.without_steps > 3);
  std::vector<Cause> causes{{"a symptom", "", 1, "", "", Cause::symptom}};
  add_cause(looked, causes);
  CHECK(causes.front().name == "it answers before it searches");
}

TEST_CASE("Told steps: each mistake is among those that make the first wrong step of a search", "[full][unsanitized]") {
  for (std::size_t m = 0; m < mistakes().size(); ++m) {
    if (m == 1) continue;  // M2 ends searches before their first step is told
    INFO("M" << m + 1);
    std::vector<const Family*> some;
    for (const Family& each : families())
      if (points_of(each.make(1, 0))) some.push_back(&each);
    const StepsLooked looked = looked_at(telling("m" + std::to_string(m + 1)), some);
    const StepsLooked::Mistake& own = looked.by_mistake[m];
    CHECK(own.made > 0);
    CHECK(own.made == std::ranges::max(looked.by_mistake, {}, &StepsLooked::Mistake::made).made);
    CHECK(own.not_made == 0);
  }
}

}  // namespace told_steps_test
}  // namespace walkthroughs::judge
