/// A program's own steps as the events of a search, and the report's beside them from the first wrong step on.
#pragma once

#include "tests/study/steps/check_steps.hpp"
#include "walkthroughs/model/scene.hpp"

namespace study {

/// Returns: its support points, simplices and directions, as it tells them; why it chose them it does not tell.
walkthroughs::model::Trace own_steps(const ToldRun& run);

/// Returns: the same until that iteration, which is made as the report makes it, from the same simplex and direction; then it ends.
/// Requires: 1 <= iteration <= steps.
walkthroughs::model::Trace rightly_from(const ToldRun& run, int iteration);

}  // namespace study
