/// How often something happens, and how sure that is.
#pragma once

#include <cstdint>

#include "tests/study/interval.hpp"

namespace study {

/// `count` of `trials`.
struct Rate {
  std::uint64_t count = 0, trials = 0;

  double share() const { return trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(trials); }
  /// Returns: Wilson's, for 95 %; from 0 to 1 where there are no trials.
  Interval interval() const { return trials == 0 ? Interval{0, 1} : wilson(count, trials); }

  void add(bool happened) {
    count += happened ? 1 : 0;
    ++trials;
  }
  Rate& operator+=(const Rate& other) {
    count += other.count;
    trials += other.trials;
    return *this;
  }
  /// Returns: how often it did not happen.
  Rate opposite() const { return {trials - count, trials}; }
};

}  // namespace study
