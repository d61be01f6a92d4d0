/// Which numbers of a search rounding has made so wrong that something else is decided by them.
#pragma once

#include <optional>
#include <string>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {

/// Each number is computed once more in fractions, from the points and the direction that the search had. What it had rounded
/// before, and what a float cannot hold, is not counted. Nothing is said of mistakes, which are wrong on purpose, and of the
/// exact fallback.
///
/// `now`: the moment after the event.
/// Returns: "ABn·AO = 0" where the number that the event tells has another sign; "ABC does not hold the origin" where it is said
/// to; "P·d = 1, but (2, 3)·d = 5" where another point of sets of points is farther; nothing where the event is right.
std::optional<std::string> exact_otherwise(const gjk::Event<double>& event, const Moment& now, const Scene& scene,
                                           const Names& names);

/// Returns: whether the hull of these points of the difference holds the origin, in fractions: that of some of them does which
/// do not depend on each other.
bool holds_origin_exactly(const Simplex& simplex);

}  // namespace walkthroughs::story
