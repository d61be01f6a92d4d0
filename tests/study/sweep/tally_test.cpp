#include "tests/study/sweep/tally.hpp"

#include "tests/kit/catch.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace {

TEST_CASE("What a smaller limit answers follows from the answers at the largest", "[tally]") {
  const std::vector<const Family*> families{&family_named("triangles"), &family_named("flat-1e-9-turned"),
                                            &family_named("cycles"), &family_named("scale-1e-75")};
  for (const char* const name : {"as-intended double exact", "as-printed float exact", "as-intended float relative"}) {
    Plan plan = plan_for(families, {&method_named(name)}, 120);
    const Findings all = sweep(plan);
    for (const int limit : {1, 2, 3, 5, 8, 20}) {
      INFO(name << " at most " << limit);
      plan.limits = {limit};
      const Findings some = sweep(plan);
      for (std::size_t row = 0; row < all.rows.size(); ++row) {
        INFO(all.rows[row].family);
        const Counts derived = counts_at(all.rows[row].tally, limit), asked = counts_at(some.rows[row].tally, limit);
        REQUIRE(derived.pairs == asked.pairs);
        REQUIRE(derived.hits == asked.hits);
        REQUIRE(derived.false_positives == asked.false_positives);
        REQUIRE(derived.false_negatives == asked.false_negatives);
        REQUIRE(derived.undecided == asked.undecided);
        REQUIRE(derived.hit_iterations == asked.hit_iterations);
        REQUIRE(derived.miss_iterations == asked.miss_iterations);
      }
    }
  }
}

TEST_CASE("A tally tells wrong answers of either kind apart from undecided ones", "[tally]") {
  Tally tally;
  tally.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  tally.count({Truth::intersecting, Proof::predicates}, {Answer::separated, 4});
  tally.count({Truth::intersecting, Proof::predicates}, {Answer::separated, 9});
  tally.count({Truth::intersecting, Proof::predicates}, {Answer::intersecting, 5});
  tally.count({Truth::separated, Proof::predicates}, {Answer::separated, 2});
  tally.count({Truth::separated, Proof::predicates}, {Answer::at_limit, 50});
  tally.count({Truth::separated, Proof::predicates}, {Answer::unusable, 6});
  tally.count({Truth::intersecting, Proof::formulas}, {Answer::in_doubt, 7});
  const Counts at_8 = counts_at(tally, 8);
  REQUIRE(at_8.pairs == 8);
  REQUIRE(at_8.hits == 4);
  REQUIRE(at_8.false_positives == 1);
  REQUIRE(at_8.false_negatives == 1);
  REQUIRE(at_8.undecided == 4);  // those that took 9, 50, 6 and 7
  REQUIRE(at_8.unusable == 1);
  REQUIRE(at_8.in_doubt == 1);
  REQUIRE(iterations_of(at_8) == 3 + 4 + 8 + 5 + 2 + 8 + 6 + 7);
  REQUIRE(at_8.hit_iterations == Histogram{0, 0, 0, 0, 1, 1, 0, 1, 1});
  REQUIRE(counts_at(tally, 10).false_negatives == 2);
}

TEST_CASE("Tallies add up", "[tally]") {
  Tally one, other, both;
  one.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  other.count({Truth::intersecting, Proof::predicates}, {Answer::intersecting, 12});
  other.truth_changed = 5;
  both.count({Truth::intersecting, Proof::predicates}, {Answer::intersecting, 12});
  both.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  both.truth_changed = 5;
  one += other;
  REQUIRE(counts_at(one, 50).false_positives == 1);
  REQUIRE(one == both);
}

TEST_CASE("Times of queries asked alone add up, and the slowest pair is that of the larger time", "[tally]") {
  const TimesAlone quick{{3, 300}, {1, 40}, 11, 150}, slow{{2, 500}, {5, 60}, 4, 400};
  for (const bool slow_first : {true, false}) {
    TimesAlone sum = slow_first ? slow : quick;
    sum += slow_first ? quick : slow;
    INFO("slow first: " << slow_first);
    REQUIRE(sum.one_search.queries == 5);
    REQUIRE(sum.one_search.nanoseconds == 800);
    REQUIRE(sum.two_searches.queries == 6);
    REQUIRE(sum.two_searches.nanoseconds == 100);
    REQUIRE(sum.slowest == 400);
    REQUIRE(sum.slowest_pair == 4);
  }
}

}  // namespace
}  // namespace study::test
