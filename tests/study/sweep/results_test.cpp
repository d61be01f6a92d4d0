#include "tests/study/sweep/results.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace results_test {

Plan plan_at(std::vector<int> limits) {
  Plan plan = plan_for({&family_named("grid-segments")}, {}, 10, 2);
  plan.limits = std::move(limits);
  return plan;
}

/// What ordinary runs seldom or never see: the others are in the tables of report_test.py.
TEST_CASE("Whatever is counted has a column of its own, and files say which part of which run they are", "[results]") {
  Row row{{}, "grid-segments", "as-intended", "float", "exact"};
  row.tally.count({Truth::separated, Proof::formulas}, {Answer::unusable, 4});
  row.tally.out_of_range = 11;
  row.tally.not_askable = 12;
  row.tally.truth_changed = 13;
  row.tally.exceptions = 14;
  row.tally.certificates = 15;
  row.tally.false_certificates = 16;
  Plan plan = plan_at({5});
  plan.shard = {1, 3};
  const std::string counts = csv_of({.seed = 3, .pairs = 101}, plan, {row}).back().text;
  CHECK(counts.starts_with("# command: gjkstep-study run --pairs 101 --seed 3\n# seed: 3\n# version: gjkstep-study "));
  CHECK_THAT(counts, kit::contains("\n# shard: 1 of 3\n"));
  CHECK(kit::lines(counts).back() == "grid-segments,as-intended,float,exact,5,1,0,0,0,1,0,1,0,11,12,13,14,0,1,0,15,16");
}

TEST_CASE("What is proven and yet wrong, none or without its proof is a contradiction", "[results]") {
  const auto said = [](const std::string& rules, const std::string& scalar, auto change) {
    Row row{{}, "grid-segments", rules, scalar, "exact"};
    row.tally.count({Truth::separated, Proof::predicates}, {Answer::separated, 2});
    change(row.tally);
    return contradiction(plan_at({5, 20}), {row});
  };
  const auto counted = [](Truth truth, Answer answer) {
    return [=](Tally& tally) { tally.count({truth, Proof::predicates}, {answer, 6}); };
  };
  const auto false_positive = counted(Truth::separated, Answer::intersecting),
             false_negative = counted(Truth::intersecting, Answer::separated),
             none = counted(Truth::separated, Answer::unusable), in_doubt = counted(Truth::separated, Answer::in_doubt);
  CHECK(said("as-intended", "double", false_positive).empty());
  CHECK(said("as-printed", "exact", false_positive).empty());
  CHECK(said("as-intended", "exact", none).empty());
  for (const auto& wrong : {false_positive, false_negative})
    CHECK_THAT(
        said("as-intended", "exact", wrong),
        kit::contains("family grid-segments: of 2 answers by rules as-intended, computed in exact, 1 were wrong"));
  CHECK(said("certified", "double", in_doubt).empty());
  for (const auto& wrong : {false_positive, false_negative, none})
    CHECK_THAT(said("certified", "double", wrong),
               kit::contains("of 2 answers by rules certified, computed in double, 1 "));
  for (const auto counter : {&Tally::exceptions, &Tally::false_certificates})
    CHECK_THAT(said("certified", "double", [=](Tally& tally) { ++(tally.*counter); }), kit::contains(", 1 were wrong"));
}

}  // namespace results_test
}  // namespace study::test
