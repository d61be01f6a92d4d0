/// What GJK makes of small, fixed sets of pairs.
#include "tests/study/sweep/sweep.hpp"

#include <map>
#include <set>

#include "core/rule_sets.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace sweep_test {

Family listed(std::string name, std::vector<Pair> pairs) {
  const std::uint64_t size = pairs.size();
  return {std::move(name), "pairs of a test", size,
          [pairs = std::move(pairs)](std::uint64_t, std::uint64_t index) { return pairs.at(index); }};
}

Points tetrahedron_at(double x) { return {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}}; }

bool is_of_points(const Family& family) {
  const Pair pair = family.make(7, 0);
  return std::holds_alternative<Points>(pair.a) && std::holds_alternative<Points>(pair.b);
}

TEST_CASE("The exact scalar is never wrong where it decides", "[sweep][unsanitized]") {
  for (const Family& family : families()) {
    if (!is_of_points(family)) continue;
    const Counts counts = counts_of(plan_for({&family}, {&method_named("as-intended exact exact")}, 12, 12));
    INFO(family.name);
    CHECK(counts.pairs == 12);
    CHECK(counts.wrong() == 0);
  }
}

TEST_CASE("Every set of rules is asked in every scalar and with each zero test that means something to it", "[sweep]") {
  std::set<std::string> names;
  for (const Method& method : all_methods()) names.insert(method.name());
  const std::size_t rounding = 3 * std::size(gjk::zero_tests), exact = 1, certified = 4;
  CHECK(names.size() == std::size(gjk::rule_sets) * (rounding + exact) + certified);
  CHECK(all_methods().size() == names.size());
}

TEST_CASE("Eager rules begin between the centers and need one point of sets that are well apart", "[sweep]") {
  const Pair pairs[] = {{tetrahedron_at(0), tetrahedron_at(9)}, {Ball{{0, 0, 5}, 1}, Ball{{1, 0, 0}, 1}}};
  std::map<std::string, int> asked;
  for (const Method& method : all_methods())
    for (const Pair& pair : pairs) {
      const std::unique_ptr<Question> question = method.scalar.question(pair);
      const bool of_balls = &pair == &pairs[1], is_eager = method.rules.ends_with("eager");
      if (!question || (of_balls && is_certified(method.rules))) continue;  // those are decided exactly
      if (!is_eager && method.rules != "as-intended" && method.rules != "certified") continue;
      INFO(method.name());
      ++asked[method.rules];
      const Outcome outcome = method.ask(*question, 20);
      CHECK(outcome.answer == Answer::separated);
      CHECK((outcome.iterations == 1) == is_eager);
    }
  CHECK(asked["eager"] == asked["as-intended"]);
  CHECK(asked["eager"] > asked["certified-eager"]);
  CHECK(asked["certified-eager"] == 2);
}

TEST_CASE("The direction between the centers is that of the pair's scene, and the usual one where there is none",
          "[sweep]") {
  const Pair pair{Points{{0, 0, 0}, {3, 0, 0}, {0, 6, 0}}, Can{{0, 9, 1}, {0, 0, 1}, 1, 2}};
  CHECK(between_centers<double>(pair) == Vec(-1, 7, 1));
  CHECK(between_centers<double>({pair.a, pair.a}) == Vec(1, 0, 0));
  CHECK(between_centers<float>({Points{{3e38, 0, 0}}, Points{{-3e38, 0, 0}}}) == gjk::Vec3<float>(1, 0, 0));
}

TEST_CASE("Pairs on which GJK cycles are undecided and the cycle is seen", "[sweep]") {
  const Family cycling = listed("cycling", {separated_pair_that_cycles(), intersecting_pair_that_cycles()});
  for (const char* const scalar : {"float", "double", "long-double", "exact"}) {
    INFO(scalar);
    const std::string name = "as-intended " + std::string(scalar) + " exact";
    const Counts counts = counts_of(plan_for({&cycling}, {&method_named(name)}, 2, 2));
    CHECK(counts.pairs == 2);
    CHECK(counts.hits == 1);
    CHECK(counts.undecided == 2);
    CHECK(counts.cycles == 2);
    CHECK(counts.wrong() == 0);
  }
}

TEST_CASE("Float is asked about the pair as float writes it", "[sweep]") {
  // Apart by less than float can write: rounded, they share a face.
  const Family close = listed("close", {{tetrahedron_at(0), Points{{1 + 1e-12, 0, 0}, {3, 0, 0}, {3, 1, 0}}}});
  const Tally narrow = sweep(plan_for({&close}, {&method_named("as-intended float exact")}, 1)).front().tally;
  CHECK(narrow.truth_changed == 1);
  CHECK(counts_at(narrow, 20).hits == 1);
  CHECK(counts_at(narrow, 20).wrong() == 0);
  const Tally wide = sweep(plan_for({&close}, {&method_named("as-intended double exact")}, 1)).front().tally;
  CHECK(wide.truth_changed == 0);
  CHECK(counts_at(wide, 20).hits == 0);
}

TEST_CASE("Numbers that float cannot write are counted and not asked", "[sweep]") {
  const Family far =
      listed("far", {{tetrahedron_at(0), tetrahedron_at(1e60)}, {Points{{0, 1e-60, 0}}, tetrahedron_at(0)}});
  const Tally tally = sweep(plan_for({&far}, {&method_named("as-intended float exact")}, 2)).front().tally;
  CHECK(tally.out_of_range == 2);
  CHECK(counts_at(tally, 20).pairs == 0);
}

TEST_CASE("Counts do not depend on the number of threads", "[sweep]") {
  Plan plan = plan_for({&family_named("triangles"), &family_named("tetrahedra")},
                       {&method_named("as-printed double exact"), &method_named("as-printed float exact")}, 1500);
  const std::vector<Row> one = sweep(plan);
  plan.threads = 3;
  const std::vector<Row> three = sweep(plan);
  REQUIRE(one.size() == 4);
  for (std::size_t row = 0; row < one.size(); ++row) {
    CHECK(one[row].tally == three[row].tally);
    CHECK(one[row].timings.at(20).queries == three[row].timings.at(20).queries);
  }
}

}  // namespace sweep_test
}  // namespace study::test
