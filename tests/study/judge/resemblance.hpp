/// Which mistake answers most like a program?
#pragma once

#include <vector>

#include "tests/study/judge/judged.hpp"

namespace study {

/// Returns: mistakes and algorithms without one that have a wrong pair in common with the program, the most alike first. Only pairs
/// of points count. Each search is begun in several directions, and the most alike counts; and so it is with the pairs that count
/// for a mistake: those that the report's algorithm answers rightly in doubles, or also in floats.
std::vector<Resemblance> resemblances(const std::vector<Judged>& pairs);

}  // namespace study
