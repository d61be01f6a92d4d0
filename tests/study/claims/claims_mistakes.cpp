#include "tests/study/claims/claims_measured.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/truth/oracle.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/pairs/random_triangles.hpp"

namespace study {
namespace {

Pair make(TestPairs pairs, std::uint64_t seed, std::uint64_t index) {
  static const Family &triangles = family_named("triangles"), &tetrahedra = family_named("tetrahedra");
  if (pairs == TestPairs::triangles) return triangles.make(seed, index);
  if (pairs == TestPairs::tetrahedra) return tetrahedra.make(seed, index);
  Dice dice(seed, "grid-triangles", index);
  return coarse_triangles(dice, 6, 1);
}

/// What Algorithm 1 would answer: at its limit, no.
bool says_yes(const Run& run) { return run.status == gjk::Status::intersecting; }

void count(const Run& with, const Run& without, bool meet, MistakeCounts& sum) {
  const bool decided = with.status != gjk::Status::undecided, right = says_yes(with) == meet;
  sum.fails.add(!right && says_yes(without) == meet);
  sum.undecided += decided ? 0 : 1;
  sum.wrong_yes += decided && !right && !meet ? 1 : 0;
  sum.wrong_no += decided && !right && meet ? 1 : 0;
  const bool changed = with.way != without.way || with.status != without.status;
  sum.changed.add(changed);
  if (!changed) return;
  const bool heals = right && decided;
  (meet ? sum.heals_meeting : sum.heals_apart).add(heals);
  if (heals) sum.extra_iterations += with.iterations - without.iterations;
}

void ask_about(const Pair& pair, MistakeTable& sum) {
  const gjk::PointSet<double> a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
  const bool meet = truth(pair) == Truth::intersecting;
  const Run without = ask_faithfully(a, b);
  sum.counts.resize(mistakes().size());
  for (std::size_t i = 0; i < mistakes().size(); ++i) count(mistakes()[i].ask(a, b), without, meet, sum.counts[i]);
}

}  // namespace

bool MistakeCounts::mostly_heals() const {
  const auto mostly = [](const Rate& rate) { return rate.trials == 0 || rate.interval().low > 0.5; };
  return changed.count > 0 && mostly(heals_meeting) && mostly(heals_apart);
}

double MistakeCounts::mean_extra() const {
  const std::uint64_t healed = heals_meeting.count + heals_apart.count;
  return healed == 0 ? 0 : static_cast<double>(extra_iterations) / static_cast<double>(healed);
}

MistakeCounts& MistakeCounts::operator+=(const MistakeCounts& other) {
  fails += other.fails;
  wrong_yes += other.wrong_yes;
  wrong_no += other.wrong_no;
  undecided += other.undecided;
  changed += other.changed;
  heals_meeting += other.heals_meeting;
  heals_apart += other.heals_apart;
  extra_iterations += other.extra_iterations;
  return *this;
}

MistakeTable& MistakeTable::operator+=(const MistakeTable& other) {
  counts.resize(std::max(counts.size(), other.counts.size()));
  for (std::size_t i = 0; i < other.counts.size(); ++i) counts[i] += other.counts[i];
  return *this;
}

MistakeTable measure_mistakes(TestPairs pairs, const ClaimsOptions& options) {
  return over_pairs<MistakeTable>(options.pairs, options.threads, [&](MistakeTable& sum, std::uint64_t index) {
    ask_about(make(pairs, options.seed, index), sum);
  });
}

}  // namespace study
