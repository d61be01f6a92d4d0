/// What a contender answers, asked where it can do no harm: in a process of its own, each pair with a time limit.
#pragma once

#include <vector>

#include "tests/bench/peers/contender.hpp"

namespace peers {

inline constexpr int seconds_for_a_pair = 1;         ///< of the processor
inline constexpr int failures_before_giving_up = 3;  ///< crashes and time-outs; the pairs left are not asked

/// Returns: the answer to each pair.
/// Errors: std::system_error where no process can be started.
std::vector<Answer> tried(Batch& batch, std::size_t pairs);

}  // namespace peers
