/// May rounding alone have misled a program, or is something else wrong with it?
#pragma once

#include <cstdint>
#include <vector>

#include "tests/study/judge/judged.hpp"

namespace study {

/// An answer is laid to rounding where the report's algorithm, which has no mistake, answers wrongly, too, begun in one of several
/// directions (also in a cycle, at its limit); where the truth is another one once A is moved by 16 ε of the sets' size, unless
/// the numbers are so small and whole that no product rounds; and where a number overflows.
LaidToRounding laid_to_rounding(const std::vector<Judged>& pairs);

}  // namespace study
