/// What may be done to a pair of sets of points without changing whether they meet; and whether certified answers care.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string_view>

#include "tests/study/pairs/dice.hpp"
#include "walkthroughs/model/any_shape.hpp"

namespace study {

template <class S>
struct PairOfSets {
  walkthroughs::PointsOf<S> a, b;
};

/// Each does without rounding what its name says; some in one of many ways, as the dice fall.
enum class Symmetry { as_it_is, exchanged, permuted, repeated, turned, scaled, moved };
inline constexpr std::array<std::string_view, 7> symmetry_names{"as it is",
                                                                "A and B exchanged",
                                                                "points permuted",
                                                                "points repeated",
                                                                "turned with the cube",
                                                                "times a power of two",
                                                                "moved"};

/// Returns: the pair after that; nothing where its numbers leave no room for it, as for a move that rounds nothing.
template <class S>
std::optional<PairOfSets<S>> after(Symmetry symmetry, const PairOfSets<S>& pair, Dice& dice);

/// What came of asking about pairs after one symmetry, in one scalar.
struct SymmetryTally {
  std::uint64_t asked = 0, no_room = 0;
  std::uint64_t other_answers = 0;  ///< than the pair as it is has
  std::uint64_t unproven = 0;       ///< certificates that do not hold, multiplied out
  std::uint64_t second_searches = 0;
  SymmetryTally& operator+=(const SymmetryTally& more);
};

struct SymmetriesOptions {
  std::uint64_t pairs = 1000;  ///< of each family of points, and in each scalar
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::function<void(std::uint64_t done, std::uint64_t all)> progress = [](std::uint64_t, std::uint64_t) {};
};

/// Writes a table in Markdown. Returns: whether every answer is the same after everything, and proven.
bool write_symmetries(std::ostream& out, const SymmetriesOptions& options);

}  // namespace study
