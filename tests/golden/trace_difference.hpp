/// Two traces, event by event: where they part, and what each side says there.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace golden {

/// Numbers agree when they differ by at most this share of the larger one; the numbers of a vector, when they differ by at most
/// this share of its largest coordinate. A zero agrees with a zero only, because signs decide. Everything is computed by
/// + - × ÷ and sqrt, so runs on one machine agree in every bit; the bound leaves room for another sin and cos (a pose given by
/// an angle), carried through products of four lengths.
inline constexpr double relative_bound = 1e-11;

/// The first difference of two traces.
struct TraceDifference {
  std::size_t line;  ///< counted from 1, as an editor does
  std::string key;   ///< what differs there: "verdict", "scenes/0/a/points/2"; empty where one trace has ended
  std::string expected, actual;     ///< the two events in words; "(no further event)" where a trace has ended
  std::vector<std::string> before;  ///< the events before it in words, at most three, the last one last
};

/// Compares two traces as `gjkstep trace` prints them. Names, regions, verdicts, order and counts must be the same, numbers
/// agree within `relative_bound`. Returns: nothing where they agree.
std::optional<TraceDifference> difference_of_traces(const std::string& expected, const std::string& actual);

/// Returns: the difference as a reader wants it, on several lines.
std::string in_words(const TraceDifference& difference);

}  // namespace golden
