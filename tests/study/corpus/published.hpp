/// Pairs on which other implementations failed in public: facts and coordinates, with the thread that tells them.
#pragma once

#include <vector>

#include "tests/study/corpus/answered_pair.hpp"

namespace study {

/// Returns: those whose coordinates are all in the thread. A wrong answer is not all that happened there: some never ended, or
/// found a wrong distance, normal or point. Most are mended since.
std::vector<NamedPair> published_failures();

}  // namespace study
