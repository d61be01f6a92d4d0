/// The smallest pairs of whole numbers that show a mistake.
#pragma once

#include <vector>

#include "tests/study/corpus/answered_pair.hpp"

namespace study {

/// Returns: some for each mistake that shows on small whole numbers, "m7-1" the first of mistake 7. Found among random pairs, then
/// made as small as they go: fewer points, smaller numbers. Always the same.
std::vector<NamedPair> smallest_pairs();

}  // namespace study
