/// The ways to ask that the study compares.
#pragma once

#include <vector>

#include "tests/study/methods/method.hpp"

namespace study {

/// Returns: every method, in the order of the tables: float, double, long double, exact, and for each scalar the rules; then
/// those whose answers are proven.
const std::vector<Method>& all_methods();

/// The iteration limits of the tables, ascending. Algorithm 1 says 20.
inline constexpr int limits[] = {5, 8, 10, 20, 50};

}  // namespace study
