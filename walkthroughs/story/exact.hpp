/// The same search without rounding: which of its decisions rounding has changed, and what is true. Only walkthroughs that
/// ask for it pay for it. And fractions as they are told.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::story {

/// What a search of rounded numbers does wrong, in words; the numbers are found.
struct WrongTurn {
  std::string cause;  ///< why the first wrong decision is made: a clause
  std::string truth;  ///< what this means for the pair: a clause for the last caption
};

/// Returns: what exact arithmetic answers about the scene's numbers as they stand. Requires: two sets of points.
gjk::Status exact_answer(const Scene& scene);

/// Returns: remarks on `trace`, the search of `scene`: one at the first decision that exact arithmetic makes otherwise, with
/// the exact number; one at the end, with a point that both objects hold, or how far apart they are at least.
///
/// Exact is the search from the scene's numbers as they stand; what comes before, such as rounding them to floats, is not
/// counted. Requires: two sets of points, and that exact arithmetic decides otherwise and comes to an answer.
/// Errors: std::logic_error where it does not.
std::vector<Remark> remarks_on(const WrongTurn& turn, const Scene& scene, const Trace& trace);

/// Returns: a fraction, "-3/2", as it is where it is short, and else "≈ 3.08e−33".
std::string short_fraction(const std::string& fraction);

/// Returns: infinite, or 0, where it is beyond doubles.
double nearest_double(const std::string& fraction);

}  // namespace walkthroughs::story
