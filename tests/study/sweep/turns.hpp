/// Times methods so that they can be compared: they take turns, so that whatever makes the machine slower for a while makes
/// all of them slower.
#pragma once

#include <vector>

#include "tests/study/sweep/tally.hpp"

namespace study {

/// Questions that one method is asked in a row.
struct Batch {
  const Method* method;
  std::vector<const Question*> questions;
};

/// In each turn a method is asked all its questions with each limit that it has, once unmeasured, so that what came before does not cost
/// it its caches, and once measured. Of the turns of a method the median counts.
///
/// Returns: for each batch the times by limit; none for a batch without questions.
std::vector<Timings> times_in_turn(const std::vector<Batch>& batches, const std::vector<int>& limits);

}  // namespace study
