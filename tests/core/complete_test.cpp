/// The complete rules: what they keep is nearest to the origin, so they end; and what they tell is what they asked.
#include "core/complete.hpp"

#include <set>

#include "tests/core/evidence.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace complete_test {

using Exactly = Complete<>;

ExactVec nearest_to_origin(const Simplex<Rational>& simplex) { return -toward_origin(places(simplex)); }

TEST_CASE("In exact numbers each step of the complete rules brings the simplex nearer to the origin", "[complete]") {
  Dice dice(71);
  int reduced = 0;
  for (int i = 0; i < 600; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto a = point_set<Rational>(t.a), b = point_set<Rational>(t.b);
    const auto [result, events] = observed<Rational, Exactly>(a, b, {.iteration_limit = 100});
    INFO("pair " << i << ", seed 71");
    REQUIRE(result.status != Status::undecided);
    if (result.separation)
      REQUIRE(
          difference_stays_below<Rational>(t.a, t.b, result.separation->direction, result.separation->support_value));
    else
      REQUIRE(contain_origin(places(result.simplex)));
    std::optional<Rational> before;
    for (const auto& reduction : events_of_kind<SimplexReduced<Rational>>(events)) {
      const ExactVec v = nearest_to_origin(reduction.after);
      REQUIRE((!before || v.squaredNorm() < *before));
      before = v.squaredNorm();
      ++reduced;
    }
  }
  REQUIRE(reduced > 200);
}

TEST_CASE("The complete rules end where the report's go round for ever", "[complete]") {
  const auto check = [](const Points& a, const Points& b, Status expected) {
    const auto exact_a = point_set<Rational>(a), exact_b = point_set<Rational>(b);
    REQUIRE(asked<Rational>(exact_a, exact_b).reason == Reason::cycle);
    REQUIRE(asked<Rational, Exactly>(exact_a, exact_b).status == expected);
    REQUIRE(asked<double, Exactly>(point_set<double>(a), point_set<double>(b)).status == expected);
  };
  check(cycling_apart_a, cycling_apart_b, Status::separated);
  check(cycling_meeting_a, cycling_meeting_b, Status::intersecting);
}

TEST_CASE("A question of the complete rules is told once, with the product that answers it", "[complete]") {
  Dice dice(73);
  int possible = 0;
  for (int i = 0; i < 2000; ++i) {
    const Points a = dice.points(4, 9), b = dice.points(4, 9);
    std::set<std::string> told;
    for (const Event<double>& event : observed<double, Exactly>(point_set<double>(a), point_set<double>(b)).events) {
      if (std::holds_alternative<VertexAdded<double>>(event)) told.clear();
      const auto* const region = std::get_if<RegionTested<double>>(&event);
      if (!region || region->verdict == Verdict::skipped || region->expression.empty()) continue;
      const std::string asked = to_string(region->face) + " " + to_string(region->expression);
      INFO("pair " << i << ", seed 73, " << asked);
      REQUIRE(told.insert(asked).second);
      const double* const value = std::get_if<double>(&region->value);
      if (!value || region->feature == "ABC") continue;
      const bool holds = region->relation == Relation::not_negative ? *value >= 0 : *value > 0;
      REQUIRE(holds == (region->verdict != Verdict::rejected));
      possible += region->verdict == Verdict::possible;
    }
  }
  REQUIRE(possible > 1000);
}

TEST_CASE("A product that is not a number ends a search by the complete rules undecided", "[complete]") {
  const PointSet<double> a({{1e200, 0, 1}, {-1e200, 0, 1}}), origin({{0, 0, 0}});
  const Result<double> result = asked<double, Exactly>(a, origin);
  REQUIRE(result.reason == Reason::unusable_direction);
  REQUIRE(result.status == Status::undecided);
}

}  // namespace complete_test
}  // namespace gjk::test
