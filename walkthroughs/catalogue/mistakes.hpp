/// A search with a mistake in it, beside the report's.
#pragma once

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs {

/// Returns: "mistakes/m14-order-below-triangle": the scene searched with that mistake, and as the report has it.
/// Requires: a scene without a mistake, whose rules are the report's as intended.
Walkthrough beside_the_report(Mistake mistake, Scene right);

}  // namespace walkthroughs
