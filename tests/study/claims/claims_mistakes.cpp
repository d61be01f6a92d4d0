#include <algorithm>

#include "tests/study/claims/claims.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/pairs/random_triangles.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

/// What Algorithm 1 would answer: at its limit, no.
bool says_yes(const Run& run) { return run.status == gjk::Status::intersecting; }

void count(const Run& with, const Run& without, bool meet, MistakeCounts::value_type& sum) {
  using enum OfMistake;
  const bool decided = with.status != gjk::Status::undecided, right = says_yes(with) == meet;
  ++sum[asked];
  sum[fails] += !right && says_yes(without) == meet;
  sum[undecided] += !decided;
  if (decided && !right) ++sum[meet ? wrong_no : wrong_yes];
  if (with.way == without.way && with.status == without.status) return;
  ++sum[changed];
  ++sum[meet ? changed_meeting : changed_apart];
  if (!right || !decided) return;
  ++sum[meet ? healed_meeting : healed_apart];
  sum[extra_iterations] += with.iterations - without.iterations;
}

void ask_about(const Pair& pair, MistakeCounts& sum) {
  const gjk::PointSet<double> a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
  const bool meet = truth(pair) == Truth::intersecting;
  const Run without = ask_faithfully(a, b);
  sum.resize(mistakes().size());
  for (std::size_t i = 0; i < mistakes().size(); ++i) count(mistakes()[i].ask(a, b), without, meet, sum[i]);
}

}  // namespace

MistakeCounts& MistakeCounts::operator+=(const MistakeCounts& more) {
  resize(std::max(size(), more.size()));
  for (std::size_t i = 0; i < more.size(); ++i) (*this)[i] += more[i];
  return *this;
}

MistakeCounts count_mistakes(const std::string& pairs, const ClaimsOptions& options) {
  const auto on_a_grid = [](std::uint64_t seed, std::uint64_t index) {
    Dice dice(seed, "grid-triangles", index);
    return coarse_triangles(dice, 6, 1);
  };
  const auto make = pairs == "grid" ? on_a_grid : family_named(pairs).make;
  return over_pairs<MistakeCounts>(options.pairs, options.threads, [&](MistakeCounts& sum, std::uint64_t index) {
    ask_about(make(options.seed, index), sum);
  });
}

}  // namespace study
