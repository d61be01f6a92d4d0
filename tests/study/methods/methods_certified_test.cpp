/// Certified answers as methods of the study.
#include "tests/kit/catch.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace {

std::vector<const Method*> certified_ones() {
  std::vector<const Method*> some;
  for (const Method& method : all_methods())
    if (is_certified(method.rules)) some.push_back(&method);
  return some;
}

bool is_of_points(const Family& family) {
  const Pair pair = family.make(7, 0);
  return std::holds_alternative<Points>(pair.a) && std::holds_alternative<Points>(pair.b);
}

TEST_CASE("Certified answers about all families of points are right and their certificates hold", "[certified]") {
  for (const Family& family : families()) {
    if (!is_of_points(family)) continue;
    for (const Row& row : sweep(plan_for({&family}, certified_ones(), 40, 5)).rows) {
      INFO(family.name << ", " << row.rules << " " << row.scalar);
      const Counts counts = counts_at(row.tally, no_limit);
      CHECK(counts.pairs + row.tally.out_of_range == 40);
      CHECK(counts.wrong() + counts.undecided == 0);
      CHECK(row.tally.exceptions == 0);
      CHECK(row.tally.certificates == (counts.pairs == 0 ? 0 : 5));
      CHECK(row.tally.false_certificates == 0);
      CHECK(total(row.tally.second_iterations) == counts.pairs);
    }
  }
}

TEST_CASE("Certified answers about balls and cylinders are right, without a certificate or a second search",
          "[certified]") {
  std::size_t round = 0;
  for (const Family& family : families()) {
    if (is_of_points(family)) continue;
    ++round;
    for (const Row& row : sweep(plan_for({&family}, certified_ones(), 20, 20)).rows) {
      INFO(family.name << ", " << row.rules << " " << row.scalar);
      const Counts counts = counts_at(row.tally, no_limit);
      CHECK(counts.pairs == 20);
      CHECK(counts.wrong() == 0);
      CHECK(counts.undecided == counts.in_doubt);
      if (row.scalar == "double") CHECK(counts.undecided == 0);
      CHECK(row.tally.second_iterations == Histogram{20});
      CHECK(row.tally.certificates + row.tally.exceptions == 0);
      CHECK(row.timings.at(no_limit).queries == 20);
    }
  }
  CHECK(round > 0);
}

TEST_CASE("Certified answers depend on no iteration limit and are timed once", "[certified]") {
  Plan plan = plan_for({&family_named("triangles")}, certified_ones(), 100);
  const Findings usual = sweep(plan);
  plan.limits = {1};
  plan.failure_limit = 1;
  plan.failures_kept = 100;
  const Findings few = sweep(plan);
  for (std::size_t i = 0; i < usual.rows.size(); ++i) {
    CHECK(usual.rows[i].tally == few.rows[i].tally);
    CHECK(usual.rows[i].timings.size() == 1);
    CHECK(usual.rows[i].timings.contains(no_limit));
  }
  CHECK(few.failures.empty());  // though most took more than one iteration
}

TEST_CASE("Second searches are counted where the first proves nothing", "[certified]") {
  const auto searches = [](const std::string& family) {
    return sweep(plan_for({&family_named(family)}, {&method_named("certified double exact")}, 400))
        .rows.front()
        .tally.second_iterations;
  };
  const Histogram touching = searches("touching-face-askew"), apart = searches("triangles");
  CHECK(total(touching) == 400);
  CHECK(touching[0] == 0);  // no double proves that sets touch
  CHECK(total(apart) == 400);
  CHECK(apart[0] > 200);
}

TEST_CASE("Every certified answer is timed alone, by whether a second search followed, and the slowest pair is named",
          "[certified]") {
  const auto times_of = [](const std::string& family) {
    return sweep(plan_for({&family_named(family)}, {&method_named("certified double exact")}, 400)).rows.front().alone;
  };
  const TimesAlone touching = times_of("touching-face-askew"), apart = times_of("triangles");
  CHECK(touching.one_search.queries == 0);
  CHECK(touching.two_searches.queries == 400);
  CHECK(apart.one_search.queries + apart.two_searches.queries == 400);
  CHECK(apart.one_search.queries > 200);
  for (const TimesAlone& times : {touching, apart}) {
    CHECK(times.slowest > 0);
    CHECK(times.slowest <= times.one_search.nanoseconds + times.two_searches.nanoseconds);
    CHECK(times.slowest_pair < 400);
  }
  const Findings plain = sweep(plan_for({&family_named("triangles")}, {&method_named("as-intended double exact")}, 10));
  CHECK(plain.rows.front().alone.one_search.queries == 0);
}

TEST_CASE("Eager certified queries begin between the centers", "[certified]") {
  const Pair beside{Points{{0, 0, 0}, {0, 1, 0}}, Points{{-9, 0, 0}, {-9, 0, 1}}};
  for (const Method* const method : certified_ones()) {
    INFO(method->name());
    const Outcome outcome = method->ask(*method->scalar.question(beside), 20);
    CHECK(outcome.answer == Answer::separated);
    CHECK((outcome.iterations == 1) == (method->rules == "certified-eager"));
  }
}

TEST_CASE("Cylinders that touch but for what rounding takes are in doubt, which is neither wrong nor an error",
          "[certified]") {
  const Pair touching{Can{{0, 0, 0}, {0, 0, 1}, 1, 2}, Can{{0.3, 0.2, 2}, {0, 0, -1}, 0.5, 2}};
  for (const Method* const method : certified_ones()) {
    INFO(method->name());
    const auto question = method->scalar.question(touching);
    CHECK(method->ask(*question, 20).answer == Answer::in_doubt);
    CHECK(method->certificate_holds(*question) == std::nullopt);
  }
}

// -- Answers that are no good -------------------------------------------------------------------------------------------

/// A certified method that lies.
Method lying() {
  Method method = method_named("certified double exact");
  method.ask = [](const Question&, int) { return Outcome{Answer::intersecting, 30, 0}; };
  return method;
}

/// One whose answers are right and whose certificates do not hold.
Method without_proof() {
  Method method = method_named("certified-eager double exact");
  method.certificate_holds = [](const Question&) -> std::optional<bool> { return false; };
  return method;
}

TEST_CASE("A certified answer that is wrong is found and kept whatever its iterations", "[certified]") {
  const Method method = lying();
  Plan plan = plan_for({&family_named("triangles")}, {&method}, 50);
  plan.failures_kept = 2;
  const Findings findings = sweep(plan);
  CHECK(counts_at(findings.rows.front().tally, no_limit).false_positives > 10);
  REQUIRE(findings.failures.size() == 2);
  for (const Failure& failure : findings.failures) {
    CHECK(failure.kind == Kind::false_positive);
    CHECK(failure.limit == no_limit);
  }
}

TEST_CASE("Certificates of the first pairs are multiplied out and those that do not hold are counted and kept",
          "[certified]") {
  const Method method = without_proof();
  Plan plan = plan_for({&family_named("triangles")}, {&method}, 50, 8);
  plan.failures_kept = 5;
  const Findings findings = sweep(plan);
  const Tally& tally = findings.rows.front().tally;
  CHECK(tally.certificates == 8);
  CHECK(tally.false_certificates == 8);
  CHECK(counts_at(tally, no_limit).wrong() == 0);
  REQUIRE(findings.failures.size() == 5);
  CHECK(findings.failures.front().kind == Kind::false_certificate);
}

}  // namespace
}  // namespace study::test
