/// Which numbers of a search rounding has made so wrong that something else is decided by them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {

/// Each number is computed once more in fractions, from the points and the direction that the search had. What it had rounded
/// before, and what a float cannot hold, is not counted. Nothing is said of mistakes, which are wrong on purpose, and of the
/// exact fallback.
///
/// `now`: the moment after the event.
/// Returns: "ABn·AO = 0" where the number that the event tells has another sign; "P·d = 1, but (2, 3)·d = 5" where another point
/// of sets of points is farther; nothing where the event is right.
std::optional<std::string> exact_otherwise(const gjk::Event<double>& event, const Moment& now, const Scene& scene,
                                           const Names& names);

/// Returns: whether the hull of these points of the difference holds the origin, in fractions; false of dependent points, too.
bool holds_origin_exactly(const Simplex& simplex);

/// What rounding does to a search, in words; the numbers are found.
struct WrongTurn {
  std::string cause;        ///< why the first wrong decision is made: a clause
  std::string ending = {};  ///< how that ended the search: a clause for the last caption, or empty
};

/// Returns: remarks on `trace`, the search of `scene`: one at the first event that is otherwise in exact arithmetic, and one at
/// the end where there is an ending to tell. Errors: std::logic_error where there is no such event.
std::vector<Remark> remarks_on(const WrongTurn& turn, const Scene& scene, const Trace& trace);

}  // namespace walkthroughs::story
