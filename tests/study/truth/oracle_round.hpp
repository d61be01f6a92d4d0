/// Balls, and cylinders whose axes are parallel to coordinate axes, judged by formulas in fractions.
///
/// Where a formula has square roots, it is asked in squares: √S + √T >= c exactly where c² - S - T <= 0 or its square is
/// at most 4 S T, for c >= 0.
#pragma once

#include "tests/study/pairs/pairs.hpp"

namespace study {

/// Errors: std::invalid_argument where a cylinder's axis is parallel to no coordinate axis, or a number is not finite.
Truth truth_of_round(const Ball& a, const Ball& b);
Truth truth_of_round(const Ball& a, const Can& b);
Truth truth_of_round(const Can& a, const Can& b);

}  // namespace study
