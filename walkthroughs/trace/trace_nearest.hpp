/// The complete rules, told: which question comes next follows from the answers to those before. The region logic is that of
/// core/nearest.hpp, which reads its answers from the trace here.
#pragma once

#include <vector>

#include "walkthroughs/trace/trace_rules.hpp"

namespace walkthroughs {

/// Returns: the rows one of which must be told next. `told`: what has been told of the simplex so far.
///
/// Requires: 2 <= size <= 4; each event of `told` was one that these rows allow, and the last did not end the step.
std::vector<RuleRow> complete_rows(const std::vector<gjk::RegionTested<double>>& told, int size);

}  // namespace walkthroughs
