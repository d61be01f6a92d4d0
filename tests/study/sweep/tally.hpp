/// What came of many queries of one family by one method. Adding tallies is all that merging takes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "tests/study/methods/method.hpp"
#include "tests/study/truth/judgement.hpp"

namespace study {

/// [k] is how many queries took k iterations.
using Histogram = std::vector<std::uint64_t>;

void count(Histogram& histogram, int iterations, std::uint64_t queries = 1);
void add(Histogram& sum, const Histogram& more);
std::uint64_t total(const Histogram& histogram);

/// The queries are asked once, with the largest limit. What a smaller limit L would have answered follows: a query that
/// ends within L iterations ends alike, any other is undecided.
struct Tally {
  std::array<std::array<Histogram, answers>, 2> queries;  ///< by truth, then by answer
  std::array<std::uint64_t, proofs> proven{};             ///< the truths about these pairs, by Proof
  Histogram returns;                ///< of queries without an answer: by the iteration in which a state came back
  std::uint64_t out_of_range = 0;   ///< not asked: a number has no counterpart in the scalar
  std::uint64_t not_askable = 0;    ///< not asked: the scalar has no such shape
  std::uint64_t truth_changed = 0;  ///< rounding to the scalar made the sets touch, or parted them
  std::uint64_t exceptions = 0;     ///< the query threw
  Histogram fallback_iterations;    ///< of certified queries, in their second search; 0 where they needed none
  std::uint64_t certificates = 0, false_certificates = 0;  ///< multiplied out in fractions; of these, which do not hold

  void count(const Judgement& judgement, const Outcome& outcome);
  Tally& operator+=(const Tally& more);
  bool operator==(const Tally&) const = default;
};

/// A tally, as a reader asks for it: at one iteration limit.
struct Counts {
  std::uint64_t pairs = 0;            ///< that were asked
  std::uint64_t hits = 0;             ///< pairs that have a point in common
  std::uint64_t false_positives = 0;  ///< of the others
  std::uint64_t false_negatives = 0;  ///< of the hits
  std::uint64_t undecided = 0;
  std::uint64_t unusable = 0;  ///< undecided ones whose search direction became zero, infinite or not a number
  std::uint64_t in_doubt = 0;  ///< undecided ones about points that are known too badly
  std::uint64_t cycles = 0;  ///< undecided ones that came back to a state within the limit: they go in circles for ever
  Histogram hit_iterations, miss_iterations;  ///< by truth; undecided queries count with the iterations they took

  std::uint64_t wrong() const { return false_positives + false_negatives; }
  bool operator==(const Counts&) const = default;
};

Counts counts_at(const Tally& tally, int limit);

/// Times of batches, see turns.hpp. Kept apart from the counts, because no two runs agree.
struct Timing {
  std::uint64_t queries = 0, nanoseconds = 0;

  Timing& operator+=(const Timing& more);
};

using Timings = std::map<int, Timing>;  ///< by iteration limit

/// Of certified queries, each timed alone: that the clock is read once is part of each.
struct TimesAlone {
  Timing one_search = {}, two_searches = {};  ///< that needed no second search, and that did
  std::uint64_t slowest_pair = 0;             ///< its index
  std::uint64_t slowest = 0;                  ///< its nanoseconds, the least of five askings; 0 where nothing was asked

  TimesAlone& operator+=(const TimesAlone& more);
};

/// All of it.
struct Cell {
  Tally tally;
  Timings timings;
  TimesAlone alone;  ///< where answers are certified

  Cell& operator+=(const Cell& more);
};

}  // namespace study
