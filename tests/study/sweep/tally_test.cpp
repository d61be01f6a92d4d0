#include "tests/study/sweep/tally.hpp"

#include "tests/kit/catch.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace tally_test {

TEST_CASE("What a smaller limit answers follows from the answers at the largest", "[tally]") {
  const std::vector<const Family*> families{&family_named("triangles"), &family_named("flat-1e-9-turned"),
                                            &family_named("cycles"), &family_named("scale-1e-75")};
  for (const char* const name : {"as-intended double exact", "as-printed float exact", "as-intended float relative"}) {
    Plan plan = plan_for(families, {&method_named(name)}, 120);
    const std::vector<Row> all = sweep(plan);
    for (const int limit : {1, 2, 3, 5, 8, 20}) {
      plan.limits = {limit};
      const std::vector<Row> some = sweep(plan);
      for (std::size_t row = 0; row < all.size(); ++row) {
        INFO(name << " at most " << limit << ": " << all[row].family);
        CHECK(counts_at(all[row].tally, limit) == counts_at(some[row].tally, limit));
      }
    }
  }
}

TEST_CASE("The slowest pair of two is that of the larger time", "[tally]") {
  const TimesAlone quick{{3, 300}, {1, 40}, 11, 150}, slow{{2, 500}, {5, 60}, 4, 400};
  for (const auto& [one, other] : {std::pair{quick, slow}, {slow, quick}}) {
    TimesAlone sum = one;
    sum += other;
    CHECK(sum.one_search.nanoseconds + sum.two_searches.nanoseconds == 900);
    CHECK(sum.slowest == 400);
    CHECK(sum.slowest_pair == 4);
  }
}

}  // namespace tally_test
}  // namespace study::test
