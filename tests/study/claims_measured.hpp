/// What is counted for the report's claims. Every count depends on seed and number of pairs alone.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/effort.hpp"
#include "tests/study/mistakes.hpp"
#include "tests/study/moller_1997.hpp"
#include "tests/study/pair.hpp"
#include "tests/study/rate.hpp"

namespace study {

struct ClaimsOptions {
  std::uint64_t pairs = 1'000'000, seed = 1;
  unsigned threads = 2;
  std::function<void(const std::string&)> progress = {};  ///< called with what is counted next
};

// -- Effort: Sections 3.2 and 3.3 -------------------------------------------------------------------------------------

/// How many queries took how many of something.
class Distribution {
 public:
  void add(int k);
  Distribution& operator+=(const Distribution& other);

  std::uint64_t queries() const;
  /// Returns: how many took at least `least` and at most `most`.
  Rate between(int least, int most) const;
  double mean() const;
  int percentile_99() const;  ///< the least k that 99 % did not exceed
  int max() const;

 private:
  std::vector<std::uint64_t> counts_;
};

struct Cost {
  Distribution iterations, cross_products;

  Cost& operator+=(const Cost& other);
};

/// GJK in double, as intended.
struct ShapeEffort {
  Cost hits, misses, wrong, undecided;
  Distribution most_in_a_3simplex;  ///< of cross products, for each query
  Shortcuts shortcuts;

  std::uint64_t queries() const;
  /// Returns: how many queries were answered in at least `least` and at most `most` iterations.
  Rate answered_within(int least, int most) const;
  ShapeEffort& operator+=(const ShapeEffort& other);
};

/// Random shapes are what everyday queries are like. Hard families are made so that rounding or the search itself is
/// tried; there double can be wrong, so that hits and misses are told apart by the truth.
enum class Hardness { random, hard };

/// The shapes that effort is measured for, with the words for a family of pairs of them.
struct Shape {
  std::string name, what;
  Hardness hardness;
  std::optional<std::uint64_t> size;  ///< how many pairs there are, where all can be listed
  std::function<Pair(std::uint64_t seed, std::uint64_t index)> make;

  /// Returns: how many are asked. Of hard families it is a fifth: their regions take fractions to decide.
  std::uint64_t pairs(const ClaimsOptions& options) const;
  bool asks_all(const ClaimsOptions& options) const { return size && pairs(options) == *size; }
};
const std::vector<Shape>& claim_shapes();
const Shape& claim_shape(const std::string& name);

ShapeEffort measure_effort(const Shape& shape, const ClaimsOptions& options);

// -- Möller's test: Section 4 -----------------------------------------------------------------------------------------

/// The two tests that are compared, each in these ways.
enum class GjkWay { double_intended, float_intended, double_printed, float_printed };
enum class MollerWay { double_computed, float_computed, double_snapped, float_snapped };
inline constexpr std::size_t ways = 4;

/// What a GJK and a Möller say about the same pairs. An undecided GJK says no, as Algorithm 1 does.
struct Comparison {
  std::uint64_t both_yes = 0, both_no = 0;
  Rate only_gjk, only_moller;  ///< which of the two says that the triangles meet; the rate counts where that is right

  std::uint64_t pairs() const { return both_yes + both_no + disagreements(); }
  std::uint64_t disagreements() const { return only_gjk.trials + only_moller.trials; }
  std::uint64_t gjk_right() const { return only_gjk.count + only_moller.opposite().count; }
  void add(bool gjk, bool moller, bool truth);
  Comparison& operator+=(const Comparison& other);
};

/// A pair about which GJK in double, as intended, and a Möller disagree.
struct Disagreement {
  std::uint64_t index;
  MollerWay moller;
  bool gjk_says, truth;
  bool undecided;  ///< by GJK
  double depth;    ///< how far the intervals overlap; negative: how far they are apart; NaN where there are none
};

struct MollerCounts {
  std::array<std::array<Comparison, ways>, ways> compared;  ///< by GjkWay, MollerWay
  std::uint64_t meet = 0, undecided = 0, rounding_changes_truth = 0;
  std::vector<Disagreement> disagreements;

  const Comparison& of(GjkWay gjk, MollerWay moller) const {
    return compared[static_cast<std::size_t>(gjk)][static_cast<std::size_t>(moller)];
  }
  MollerCounts& operator+=(const MollerCounts& other);
};

MollerCounts measure_moller(const ClaimsOptions& options);

// -- Coarse coordinates: the two pairs of Section 4 -------------------------------------------------------------------

/// Random coordinates with few digits: k/divisor for k = 0 … levels - 1.
struct Coarseness {
  int levels, divisor;
  bool operator==(const Coarseness&) const = default;
};
const std::vector<Coarseness>& coarsenesses();

struct TouchCounts {
  std::uint64_t pairs = 0;
  Rate edges_touch;                       ///< the count: one common point, inside an edge of each, not in one plane
  std::array<Comparison, ways> compared;  ///< GJK as intended, in the scalar of the Möller
  std::array<std::uint64_t, ways> edges_touch_only_gjk{};  ///< of edges_touch: GJK says yes, Möller no

  TouchCounts& operator+=(const TouchCounts& other);
};

TouchCounts measure_touches(const Coarseness& coarseness, const ClaimsOptions& options);

// -- Mistakes: Section 1 ----------------------------------------------------------------------------------------------

struct MistakeCounts {
  Rate fails;  ///< Algorithm 1 answers wrongly with the mistake (undecided is "no"), and rightly without
  std::uint64_t wrong_yes = 0, wrong_no = 0;  ///< decided, and wrong
  std::uint64_t undecided = 0;                ///< no answer within 20 iterations
  Rate changed;                               ///< the run asked for other directions than without the mistake
  Rate heals_meeting, heals_apart;            ///< of the changed runs: the answer is right, by the truth of the pair
  std::int64_t extra_iterations = 0;          ///< over the runs that heal

  /// Returns: whether most changed runs end in the right answer, be it yes or no.
  bool mostly_heals() const;
  double mean_extra() const;
  MistakeCounts& operator+=(const MistakeCounts& other);
};

/// Pairs of one family, asked with every mistake, in the order of mistakes().
struct MistakeTable {
  std::vector<MistakeCounts> counts;

  MistakeTable& operator+=(const MistakeTable& other);
};

/// The families: the report's random triangles, tetrahedra, and triangles on a grid of 6 × 6 × 6 points, which touch often.
enum class TestPairs { triangles, tetrahedra, grid_triangles };
MistakeTable measure_mistakes(TestPairs pairs, const ClaimsOptions& options);

}  // namespace study
