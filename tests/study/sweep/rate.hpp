/// How often something happens, and how sure that is.
#pragma once

#include <cstdint>

#include "tests/study/sweep/interval.hpp"

namespace study {

/// Trials are some of many that could be made, or all that there are: then the rate is known, and has no interval.
enum class Extent { sample, census };

/// `count` of `trials`.
struct Rate {
  std::uint64_t count = 0, trials = 0;
  Extent extent = Extent::sample;

  double share() const { return trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(trials); }
  bool has_interval() const { return trials > 0 && extent == Extent::sample; }
  /// Returns: Wilson's, for 95 %, as of a sample; from 0 to 1 where there are no trials.
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
  Rate opposite() const { return {trials - count, trials, extent}; }
};

}  // namespace study
