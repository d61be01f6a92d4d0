/// What the tests of the study have in common.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/study/methods/all_methods.hpp"
#include "tests/study/sweep/sweep.hpp"

namespace study::test {

inline const Method& method_named(const std::string& name) {
  for (const Method& method : all_methods())
    if (method.name() == name) return method;
  throw std::invalid_argument("there is no method '" + name + "'");
}

inline Plan plan_for(const std::vector<const Family*>& families, const std::vector<const Method*>& methods,
                     std::uint64_t pairs, std::uint64_t slow_pairs = 0) {
  Plan plan;
  plan.seed = 7;
  plan.methods = methods;
  plan.limits = {5, 8, 10, 20, 50};
  for (const Family* family : families)
    plan.parts.push_back({family, std::min(pairs, family->size.value_or(pairs)), slow_pairs});
  return plan;
}

/// Returns: the counts of the one family and the one method of the plan, at the report's limit.
inline Counts counts_of(const Plan& plan) { return counts_at(sweep(plan).front().tally, 20); }

/// The first pair on which GJK cycles for ever (it has no point in common), and the second, which does intersect.
inline Pair separated_pair_that_cycles() {
  return {Points{{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}}, Points{{-1, 3, 2}, {0, 10, 4}, {8, 9, 0}}};
}
inline Pair intersecting_pair_that_cycles() {
  return {Points{{274, -351, 0}, {95, -20, 0}, {104, 344, 0}, {346, 81, -2}},
          Points{{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}}};
}

}  // namespace study::test
