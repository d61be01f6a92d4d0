/// What is counted for the report's claims. Every count depends on seed and number of pairs alone.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/claims/effort.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/pairs/pair.hpp"
#include "tests/study/sweep/rate.hpp"

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

  /// Returns: how many are asked. Of hard families it is a tenth: their regions take fractions to decide.
  std::uint64_t pairs(const ClaimsOptions& options) const;
  bool asks_all(const ClaimsOptions& options) const { return size && pairs(options) == *size; }
};
const std::vector<Shape>& claim_shapes();
const Shape& claim_shape(const std::string& name);

ShapeEffort measure_effort(const Shape& shape, const ClaimsOptions& options);

/// Those of points of whole numbers: doubles hold the differences, so that GJK in fractions can be looked at, too.
const std::vector<std::string>& whole_number_shapes();

/// Returns: of GJK in fractions, without what is about edges. Of so few pairs as take seconds: a fiftieth.
Shortcuts measure_in_fractions(const Shape& shape, const ClaimsOptions& options);

// -- Möller's test: Section 4 -----------------------------------------------------------------------------------------

/// GJK and Möller's test compute in the same scalar; distances are snapped by Möller's alone.
enum class Way { double_computed, float_computed, double_snapped, float_snapped };
inline constexpr std::size_t ways = 4;

enum class RulesAsked { as_intended, as_printed };

/// Of a pair about which GJK and Möller's test disagree: how the triangles lie, by exact arithmetic.
enum class Contact {
  common_vertex,
  edges,         ///< the report's two: one common point, inside an edge of each, and not in one plane
  beyond_plane,  ///< apart: all of one triangle lies on one side of the other's plane
  something_else,
};
inline constexpr std::size_t contacts = 4;

/// What GJK and Möller's test say about the same pairs. An undecided GJK says no, as Algorithm 1 does.
struct Comparison {
  std::uint64_t both_yes = 0, both_no = 0, undecided = 0;
  std::array<Rate, contacts> only_gjk, only_moller;  ///< which says that they meet; the rate counts where that is right

  Rate only_gjk_of(Contact contact) const { return only_gjk[static_cast<std::size_t>(contact)]; }
  Rate all_only_gjk() const;
  Rate all_only_moller() const;
  Rate agreement() const;
  Rate gjk_right() const;  ///< of the disagreements

  Comparison& operator+=(const Comparison& other);
};

/// A kind of random pairs of triangles. All coordinates are floats: float and double are given the same numbers.
struct TriangleKind {
  std::string name;  ///< "whole numbers 0 … 100"
  std::function<Pair(std::uint64_t seed, std::uint64_t index)> make;
};

/// The report's first, then coordinates of ever more digits.
const std::vector<TriangleKind>& triangle_kinds();
const TriangleKind& common_vertex_kind();

struct MollerCounts {
  std::uint64_t pairs = 0, meet = 0, edges_touch = 0;    ///< `edges_touch` as Contact::edges
  std::array<std::array<Comparison, ways>, 2> compared;  ///< by RulesAsked, Way
  std::array<Rate, ways> common_vertex_seen;  ///< of pairs with a common vertex: Möller's test says they meet

  const Comparison& of(Way way, RulesAsked rules = RulesAsked::as_intended) const {
    return compared[static_cast<std::size_t>(rules)][static_cast<std::size_t>(way)];
  }
  MollerCounts& operator+=(const MollerCounts& other);
};

MollerCounts measure_moller(const TriangleKind& kind, const ClaimsOptions& options);

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
