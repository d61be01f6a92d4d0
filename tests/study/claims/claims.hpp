/// What is counted for the report's claims. Every count depends on seed and number of pairs alone.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/claims/effort.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/sweep/csv.hpp"

namespace study {

struct ClaimsOptions {
  std::uint64_t pairs = 1'000'000, seed = 1;
  unsigned threads = 2;
  std::function<void(const std::string&)> progress = [](const std::string&) {};  ///< called with what is counted next
};

/// Returns: claims-effort.csv, claims-moller.csv and claims-mistakes.csv, of which report/report.py makes claims.md. They depend on
/// pairs, seed and compiler alone.
std::vector<Csv> claims_csv(const ClaimsOptions& options);

/// Numbers by name: the columns of a row.
template <class Name, std::size_t n>
struct Counters {
  std::array<std::int64_t, n> numbers{};

  std::int64_t& operator[](Name name) { return numbers[static_cast<std::size_t>(name)]; }
  std::int64_t operator[](Name name) const { return numbers[static_cast<std::size_t>(name)]; }
  Counters& operator+=(const Counters& more) {
    for (std::size_t i = 0; i < n; ++i) numbers[i] += more.numbers[i];
    return *this;
  }
};

/// Rows that are added to each other one by one.
template <class Row, std::size_t n>
struct Rows : std::array<Row, n> {
  Rows& operator+=(const Rows& more) {
    for (std::size_t i = 0; i < n; ++i) (*this)[i] += more[i];
    return *this;
  }
};

// -- Effort: Sections 3.2 and 3.3 -------------------------------------------------------------------------------------

/// Random shapes are what everyday queries are like; hits and misses are told apart by GJK's answer. Hard families are made so
/// that rounding or the search itself is tried; there double can be wrong, so that they are told apart by the truth. Where points are
/// of whole numbers doubles hold the differences, so that GJK in fractions can be looked at, too.
enum class Hardness { random, hard, hard_whole };

/// The shapes that effort is counted for, with the words for a family of pairs of them.
struct Shape {
  std::string name, what;
  Hardness hardness;
  std::optional<std::uint64_t> size;  ///< how many pairs there are, where all can be listed
  std::function<Pair(std::uint64_t seed, std::uint64_t index)> make;

  /// Returns: how many are asked. Of hard families it is a tenth: their regions take fractions to decide.
  std::uint64_t pairs(const ClaimsOptions& options) const;
};
const std::vector<Shape>& claim_shapes();

/// GJK in double, as intended.
EffortCounts count_effort(const Shape& shape, const ClaimsOptions& options);

/// Of shapes of whole numbers. Returns: of GJK in fractions, where the origin lies. Of so few pairs as take seconds: a fiftieth.
EffortCounts count_in_fractions(const Shape& shape, const ClaimsOptions& options);

// -- Möller's test: Section 4 -----------------------------------------------------------------------------------------

/// GJK and Möller's test compute in the same scalar; distances are snapped by Möller's alone.
inline constexpr std::array way_names{"double", "float", "double, snapped", "float, snapped"};
inline constexpr std::array rules_compared{"as intended", "as printed"};

// clang-format off
/// What GJK and Möller's test say about the same pairs. An undecided GJK says no, as Algorithm 1 does. Of those about which
/// they disagree: which one says that they meet, how often that is right, and how the triangles lie by exact arithmetic. To *touch
/// so* is the report's two: one common point, inside an edge of each, and not in one plane.
enum class Compared {
  pairs, meet, touch_so, share_a_vertex, share_seen_by_moller,  // of all pairs; the last of those that share a vertex
  both_yes, both_no, undecided,
  only_gjk, only_gjk_right, only_gjk_touch_so, only_gjk_share_a_vertex,
  only_moller, only_moller_right, only_moller_beyond_plane,  // all of one triangle on one side of the other's plane
};
inline constexpr std::array compared_names{
    "pairs", "meet", "touch_so", "share_a_vertex", "share_seen_by_moller", "both_yes", "both_no", "undecided",
    "only_gjk", "only_gjk_right", "only_gjk_touch_so", "only_gjk_share_a_vertex",
    "only_moller", "only_moller_right", "only_moller_beyond_plane"};
// clang-format on

/// By rules, then by way.
using Comparison = Counters<Compared, compared_names.size()>;
using Comparisons = Rows<Rows<Comparison, way_names.size()>, rules_compared.size()>;

/// A kind of random pairs of triangles. All coordinates are floats: float and double are given the same numbers.
struct TriangleKind {
  std::string name;  ///< "whole numbers 0 … 100"
  std::function<Pair(std::uint64_t seed, std::uint64_t index)> make;
};

/// The report's first, then coordinates of ever more digits, and last triangles made to have a common vertex.
const std::vector<TriangleKind>& triangle_kinds();

Comparisons compare_with_moller(const TriangleKind& kind, const ClaimsOptions& options);

// -- Mistakes: Section 1 ----------------------------------------------------------------------------------------------

// clang-format off
enum class OfMistake {
  asked,
  fails,                           // Algorithm 1 answers wrongly with the mistake (undecided is "no"), and rightly without
  wrong_yes, wrong_no, undecided,  // decided, and wrong; no answer
  changed,                         // the run asked for other directions than without the mistake
  changed_meeting, healed_meeting, changed_apart, healed_apart,  // by the truth; healed: the answer is right
  extra_iterations,                // over the runs that heal
};
inline constexpr std::array of_mistake_names{
    "asked", "fails", "wrong_yes", "wrong_no", "undecided", "changed", "changed_meeting", "healed_meeting",
    "changed_apart", "healed_apart", "extra_iterations"};
// clang-format on

/// By mistake, in the order of mistakes().
struct MistakeCounts : std::vector<Counters<OfMistake, of_mistake_names.size()>> {
  MistakeCounts& operator+=(const MistakeCounts& more);
};

/// The report's random triangles, tetrahedra, and triangles on a grid of 6 × 6 × 6 points, which touch often.
inline constexpr std::array mistaken_pairs{"triangles", "tetrahedra", "grid"};
MistakeCounts count_mistakes(const std::string& pairs, const ClaimsOptions& options);

}  // namespace study
