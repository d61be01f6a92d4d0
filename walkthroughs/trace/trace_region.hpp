/// Is a region what Algorithms 2-5 tell of it? C6 of trace_check.hpp.
#pragma once

#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/trace/trace_rules.hpp"

namespace walkthroughs {

/// Returns: what follows from the event's verdict. `rows`: what may be told of `simplex` now. Errors: Contradiction.
RuleStep step_after(const gjk::RegionTested<double>& event, const gjk::Simplex<double>& simplex,
                    const std::vector<RuleRow>& rows, const Scene& scene);

}  // namespace walkthroughs
