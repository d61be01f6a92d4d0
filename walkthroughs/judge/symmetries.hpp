/// What may be done to a pair of sets of points without changing whether they meet.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "walkthroughs/pairs/dice.hpp"

namespace walkthroughs::judge {

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
std::optional<PointPair> after(Symmetry symmetry, const PointPair& pair, Dice& dice);

}  // namespace walkthroughs::judge
