/// Counting over many pairs, on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace study {

/// Returns: the sum of what `count(tally, index)` adds up for all indices below `pairs`, each in some thread.
///
/// Requires: += of tallies may be done in any order (whole numbers), so that the number of threads does not matter.
/// Errors: the first exception that `count` throws.
template <class Tally, class Count>
Tally over_pairs(std::uint64_t pairs, unsigned threads, const Count& count) {
  constexpr std::uint64_t block = 256;
  std::atomic<std::uint64_t> next = 0;
  std::mutex mutex;
  Tally sum{};
  std::exception_ptr error;
  const auto work = [&] {
    Tally own{};
    try {
      for (std::uint64_t first = next.fetch_add(block); first < pairs; first = next.fetch_add(block))
        for (std::uint64_t i = first; i < std::min(first + block, pairs); ++i) count(own, i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
      next = pairs;
      return;
    }
    const std::lock_guard lock(mutex);
    sum += own;
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
  return sum;
}

}  // namespace study
