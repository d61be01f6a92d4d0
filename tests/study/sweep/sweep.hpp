/// Asks all pairs of some families in every way: families → questions → tallies.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/study/pairs/pairs.hpp"
#include "tests/study/sweep/tally.hpp"

namespace study {

inline constexpr std::uint64_t most_pairs = 1'000'000'000'000;  ///< of a family, that may be asked

/// How many pairs of a family are asked. Slow scalars are asked about the first few of them, and of these the certificates are
/// multiplied out.
struct Part {
  const Family* family;
  std::uint64_t pairs, slow_pairs;
};

/// This process asks about the pairs whose index leaves the remainder `index` (from 0) when divided by `count`.
struct Shard {
  std::uint64_t index = 0, count = 1;
  bool operator==(const Shard&) const = default;
};

/// Returns: how many of the first `pairs` of a family that are.
inline std::uint64_t pairs_of_shard(std::uint64_t pairs, const Shard& shard) {
  return pairs > shard.index ? (pairs - shard.index - 1) / shard.count + 1 : 0;
}

struct Plan {
  std::uint64_t seed = 1;
  std::vector<Part> parts;
  std::vector<const Method*> methods;
  std::vector<int> limits;  ///< ascending; pairs are asked with the last
  Shard shard = {};
  unsigned threads = 1;
  std::uint64_t timed_pairs = 2048;  ///< of each family, besides being asked once
};

/// What one method made of one family.
struct Row : Cell {
  std::string family, rules, scalar, zero_test;
};

/// Called now and then, from any thread but never from two at once.
using Progress = std::function<void(std::uint64_t done, std::uint64_t all)>;

/// Returns: families in the order of the plan, and within each the methods. The tallies depend on seed, parts, methods and limits
/// alone; not on the number of threads.
///
/// Errors: what the oracle throws, with family and index.
std::vector<Row> sweep(const Plan& plan, const Progress& progress = {});

}  // namespace study
