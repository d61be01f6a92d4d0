/// One family of pairs, asked of all contenders.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/peers/contender.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/oracle.hpp"

namespace peers {

struct Score {
  int false_positives = 0, false_negatives = 0;
  int undecided = 0;          ///< or an exception
  int failed = 0;             ///< crashed or timed out
  int not_asked = 0;          ///< after too many of these
  std::string first_failure;  ///< "pair 17: no answer within 1 s"; empty where nothing failed
  double nanoseconds = 0;     ///< per query: the median of the repeats; 0 where some pair had no answer
};

struct Match {
  std::string family;
  std::size_t pairs = 0, meet = 0;
  std::size_t raced = 0;           ///< pairs that were timed: the first ones
  std::vector<Score> scores = {};  ///< in the order of the contenders
  std::size_t lost = 0;            ///< pairs on which the first contender is not right though a peer is
};

struct MatchSettings {
  std::uint64_t seed = 7474;
  std::size_t pairs = 1000;  ///< at most; a family may have fewer
  int repeats = 15;
};

/// So many corners of all pairs together, of 24 bytes each, stay in the cache of a core while they are timed.
inline constexpr std::size_t corners_raced = std::size_t(1) << 14;

/// Of one number at least.
double median(std::vector<double> values);

/// Time that this process has had the processor, in nanoseconds: what others do on the machine does not count.
double processor_time();

Match play(const study::Family& family, const std::vector<Contender>& contenders, const MatchSettings& settings);

/// The shapes that the aim is about: triangles, tetrahedra, boxes, hulls of 32 and of 256 points.
std::vector<study::Family> everyday_families();

/// The study's other families.
std::vector<study::Family> hard_families();

}  // namespace peers
