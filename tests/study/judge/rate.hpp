/// How often something happens, and how sure that is.
#pragma once

#include <cmath>
#include <cstdint>

namespace study {

struct Interval {
  double low, high;
};

/// The 95 % score interval of a rate of which `count` in `trials` were seen. It neither leaves 0 … 1 nor collapses where
/// nothing was seen, as the textbook's "± 1.96 standard errors" does.
///
/// E. B. Wilson, Probable inference, the law of succession, and statistical inference, Journal of the American
/// Statistical Association 22 (1927) 209-212; recommended by L. D. Brown, T. T. Cai, A. DasGupta, Interval estimation for
/// a binomial proportion, Statistical Science 16 (2001) 101-133.
///
/// Requires: count <= trials, 0 < trials.
inline Interval wilson(std::uint64_t count, std::uint64_t trials) {
  const double z = 1.959963984540054;  // 97.5 % of the standard normal distribution lie below
  const double n = static_cast<double>(trials), p = static_cast<double>(count) / n;
  const double middle = p + z * z / (2 * n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const double scale = 1 + z * z / n;
  // The ends are exact where all or none were seen; computed, they would be a rounding error off.
  return {count == 0 ? 0 : (middle - half) / scale, count == trials ? 1 : (middle + half) / scale};
}

/// `count` of `trials`.
struct Rate {
  std::uint64_t count = 0, trials = 0;

  double share() const { return trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(trials); }
  /// Returns: from 0 to 1 where there are no trials.
  Interval interval() const { return trials == 0 ? Interval{0, 1} : wilson(count, trials); }
  void add(bool happened) {
    count += happened ? 1 : 0;
    ++trials;
  }
};

}  // namespace study
