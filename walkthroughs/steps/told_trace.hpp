/// A program's own steps as the events of a search, and the report's beside them from the first wrong step on.
#pragma once

#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/steps/check_steps.hpp"

namespace walkthroughs::steps {

/// Returns: its support points, simplices and directions, as it tells them; why it chose them it does not tell.
Trace told_trace(const ToldRun& run);

/// Returns: the same until that iteration, which is made as the report makes it, from the same simplex and direction; then it ends.
/// Requires: 1 <= iteration <= steps.
Trace rightly_from(const ToldRun& run, int iteration);

}  // namespace walkthroughs::steps
