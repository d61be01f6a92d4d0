/// What a search with a mistake tells otherwise than the table of rules (trace_rules.hpp) has it: so a trace that names its mistake is
/// checked as strictly as one that has none, and one with a mistake that it does not name contradicts itself.
#pragma once

#include <string>
#include <vector>

#include "core/events.hpp"
#include "walkthroughs/trace/trace_rules.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs {

/// Changes the rows of one place for a simplex of that size into what they are with the mistake. Those of Algorithm 1 change none.
void make_mistake(wrong_on_purpose::Mistake mistake, int size, std::vector<RuleRow>& rows);

/// Returns: the expression in vectors that have no mistake: a normal ABCn that the mistake has reversed is ACBn.
std::string with_reversed_normals(std::string expression, wrong_on_purpose::Mistake mistake, int size);

/// Returns: how the direction of that name is computed, as said above. `told`: the regions that were told of the simplex.
std::string formula_of(const std::string& direction, wrong_on_purpose::Mistake mistake,
                       const std::vector<gjk::RegionTested<double>>& told);

}  // namespace walkthroughs
