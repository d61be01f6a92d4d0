/// Certified answers as methods of the study.
#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study::test {
namespace methods_certified_test {

std::vector<const Method*> certified_ones() {
  std::vector<const Method*> some;
  for (const Method& method : all_methods())
    if (is_certified(method.rules)) some.push_back(&method);
  return some;
}

TEST_CASE("Certified answers about all families are right, and about points they have certificates that hold",
          "[certified]") {
  std::size_t round = 0;
  for (const Family& family : families()) {
    const Pair first = family.make(7, 0);
    const bool is_round = !std::holds_alternative<Points>(first.a) || !std::holds_alternative<Points>(first.b);
    round += is_round;
    for (const Row& row : sweep(plan_for({&family}, certified_ones(), 40, 5))) {
      INFO(family.name << ", " << row.rules << " " << row.scalar);
      const Counts counts = counts_at(row.tally, no_limit);
      CHECK(counts.pairs + row.tally.out_of_range == 40);
      CHECK(counts.wrong() + row.tally.exceptions + row.tally.false_certificates == 0);
      CHECK(counts.undecided == counts.in_doubt);
      if (!is_round || row.scalar == "double") CHECK(counts.undecided == 0);
      CHECK(row.tally.certificates == (is_round || counts.pairs == 0 ? 0 : 5));
      CHECK(total(row.tally.fallback_iterations) == counts.pairs);
      if (is_round) CHECK(row.tally.fallback_iterations == Histogram{40});
      CHECK(row.alone.one_search.queries + row.alone.two_searches.queries == counts.pairs);
      if (counts.pairs > 0) CHECK(row.timings.at(no_limit).queries == counts.pairs);
    }
  }
  CHECK(round > 0);
}

/// Which is no method of the study.
TEST_CASE("Starting inside changes no certified answer on any family, and its certificates hold", "[certified]") {
  const auto mean = [](const Points& points) {
    return walkthroughs::model::middle<double>(walkthroughs::model::converted<double>(
        walkthroughs::model::AnyShape(points), walkthroughs::model::Cast<double>{}));
  };
  int by_mean = 0;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(family.size.value_or(40), 40); ++i) {
      const Pair pair = family.make(7, i);
      const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
      if (!a || !b) break;
      INFO(family.name << ", pair " << i);
      const gjk::PointSet<double> one(*a), other(*b);
      gjk::Options<double> options{.iteration_limit = 100};
      options.inside = gjk::PointOfEach<double>{mean(*a), mean(*b)};
      CHECK((options.inside->a == one.mean() || !one.mean().allFinite()));
      const gjk::CertifiedResult result = gjk::certified_collision(one, other, options);
      CHECK((result.status == gjk::Status::intersecting) == (truth(pair) == Truth::intersecting));
      CHECK(result.status != gjk::Status::undecided);
      CHECK(gjk::holds(result.certificate, one, other));
      if (const auto* simplex = std::get_if<gjk::CommonSimplex>(&result.certificate))
        by_mean += std::ranges::count(simplex->of, gjk::IndexPair{gjk::IndexPair::mean, gjk::IndexPair::mean}) > 0;
    }
  CHECK(by_mean > 100);
}

TEST_CASE("Certificates of the first pairs are multiplied out, and answers that are no good are counted",
          "[certified]") {
  Method without_proof = method_named("certified-eager double exact"), lying = method_named("certified double exact");
  without_proof.certificate_holds = [](const Question&) -> std::optional<bool> { return false; };
  lying.ask = [](const Question&, int) { return Outcome{Answer::intersecting, 30}; };
  const std::vector<Row> rows = sweep(plan_for({&family_named("triangles")}, {&without_proof, &lying}, 50, 8));
  CHECK(rows[0].tally.certificates == 8);
  CHECK(rows[0].tally.false_certificates == 8);
  CHECK(counts_at(rows[0].tally, no_limit).wrong() == 0);
  CHECK(counts_at(rows[1].tally, no_limit).false_positives > 10);
}

}  // namespace methods_certified_test
}  // namespace study::test
