#include "walkthroughs/judge/case.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"

namespace walkthroughs::judge {
namespace {

/// Returns: whether floats have room for all: none becomes infinite, or zero that was not.
bool round_to_floats(Points& points) {
  bool have_room = true;
  for (Vec& p : points)
    for (double& x : p) {
      const double rounded = static_cast<double>(static_cast<float>(x));
      have_room = have_room && std::isfinite(rounded) && (rounded == 0) == (x == 0);
      x = rounded;
    }
  return have_room;
}

}  // namespace

gjk::Status truth_of(const PointPair& pair) {
  const gjk::PointSet<double> a(pair.a), b(pair.b);
  const gjk::CertifiedResult found = gjk::certified_collision(a, b);
  if (!gjk::holds(found.certificate, a, b) || gjk::claim_of(found.certificate) != found.status)
    throw std::logic_error("a certificate does not hold: the answer about " + question_line({pair.a, pair.b}) +
                           " is not proven");
  return found.status;
}

std::optional<PointPair> as_expected(const Pair& pair, const Expected& expected) {
  std::optional<PointPair> points = points_of(pair);
  if (!points) return std::nullopt;
  for (Points* const set : {&points->a, &points->b}) {
    if (expected.in_plane)
      for (Vec& p : *set) p.z() = 0;
    if (expected.numbers == Numbers::floats && !round_to_floats(*set)) return std::nullopt;
  }
  return points;
}

std::vector<Case> Cases::next(std::size_t count) {
  std::vector<Case> cases;
  while (cases.size() < count) {
    const auto named = next_();
    if (!named) break;
    if (auto points = as_expected(named->pair, expected_)) {
      const gjk::Status truth = truth_of(*points);
      cases.push_back({named->name, named->family, std::move(*points), truth});
    } else {
      ++passed_over_;
    }
  }
  return cases;
}

Cases cases_of(std::vector<NamedPair> listed, std::vector<const Family*> families, std::uint64_t of_each,
               std::uint64_t seed, const Expected& expected) {
  const auto count_of = [=](const Family& family) { return std::min(of_each, family.size.value_or(of_each)); };
  const auto name_of = [=](const Family& family, std::uint64_t index) {
    return family.name + (seed == 1 ? "-" : "-of-seed-" + std::to_string(seed) + "-") + std::to_string(index);
  };
  std::set<std::string> known;
  for (const NamedPair& each : listed) known.insert(each.name);
  std::uint64_t most = listed.size();
  for (const Family* const family : families) most += count_of(*family);
  struct Place {
    std::size_t listed = 0, family = 0;
    std::uint64_t index = 0;
  };
  const auto next = [=, at = std::make_shared<Place>()]() -> std::optional<NamedPair> {
    if (at->listed < listed.size()) return listed[at->listed++];
    while (at->family < families.size()) {
      const Family& family = *families[at->family];
      if (at->index == count_of(family)) {
        *at = {at->listed, at->family + 1, 0};
        continue;
      }
      const std::uint64_t index = at->index++;
      const std::string name = name_of(family, index);
      if (!known.contains(name)) return NamedPair{name, family.name, family.make(seed, index)};
    }
    return std::nullopt;
  };
  return {next, most, expected};
}

}  // namespace walkthroughs::judge
