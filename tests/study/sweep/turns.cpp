#include "tests/study/sweep/turns.hpp"

#include <algorithm>
#include <chrono>
#include <map>

#include "tests/study/methods/certified.hpp"

namespace study {
namespace {

constexpr int turns = 5, slow_turns = 3;  // odd: the median is one of them

using Times = std::map<int, std::vector<std::chrono::nanoseconds>>;  // by limit, one for each turn

/// Each limit has its own pass that is not measured, and another limit comes first in each turn: a processor learns to
/// predict branches, and whoever came last would seem to be the fastest.
void take_turn(const Batch& batch, std::vector<int> limits, int turn, Times& times) {
  std::rotate(limits.begin(), limits.begin() + turn % static_cast<std::ptrdiff_t>(limits.size()), limits.end());
  for (const int limit : limits) {
    batch.method->time(batch.questions, limit);
    times[limit].push_back(batch.method->time(batch.questions, limit));
  }
}

std::uint64_t median_of(std::vector<std::chrono::nanoseconds> times) {
  std::ranges::sort(times);
  return static_cast<std::uint64_t>(times[times.size() / 2].count());
}

}  // namespace

std::vector<Timings> times_in_turn(const std::vector<Batch>& batches, const std::vector<int>& limits) {
  std::vector<Times> times(batches.size());
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t b = 0; b < batches.size(); ++b)
      if (!batches[b].questions.empty() && (turn < slow_turns || !batches[b].method->scalar.is_slow))
        take_turn(batches[b], limits_for(batches[b].method->rules, limits), turn, times[b]);
  std::vector<Timings> medians(batches.size());
  for (std::size_t b = 0; b < batches.size(); ++b)
    for (const auto& [limit, all] : times[b]) medians[b][limit] = {batches[b].questions.size(), median_of(all)};
  return medians;
}

}  // namespace study
