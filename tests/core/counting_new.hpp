/// Counts what the program allocates with new. Linking counting_new.cpp replaces the global operators.
#pragma once

#include <cstddef>

namespace gjk::test {

/// Returns: how many times memory was asked for with new since the program started.
std::size_t allocations();

}  // namespace gjk::test
