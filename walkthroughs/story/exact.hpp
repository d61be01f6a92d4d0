/// What is true of a scene, told beside what its search answers. And the same search without rounding: which of its
/// decisions rounding has changed; only walkthroughs that ask for it pay for it. And fractions as they are told.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// What a search of rounded numbers does wrong, in words; the numbers are found.
struct WrongTurn {
  std::string cause;        ///< why the first wrong decision is made: a clause
  std::string ending = {};  ///< how that ended the search: a clause for the last caption, or empty
};

/// Returns: remarks on `trace`, the search of `scene`: one at the first decision that exact arithmetic makes otherwise, with
/// the exact number; and one at the end, where there is an ending to tell.
///
/// Exact is the search from the scene's numbers as they stand; what comes before, such as rounding them to floats, is not
/// counted. Requires: two sets of points, and that exact arithmetic decides otherwise and comes to an answer.
/// Errors: std::logic_error where it does not.
std::vector<Remark> remarks_on(const WrongTurn& turn, const Scene& scene, const Trace& trace);

/// Returns: "they intersect" or "they are apart". Requires: an answer.
std::string in_truth(gjk::Status answer);

/// What there is to tell of a scene beside what its search answers. The sentence is empty where there is nothing.
struct TruthTold {
  std::string sentence;  ///< "In doubles: apart. In truth: they intersect."
  std::vector<Fact> facts;
};

/// Requires: that the search of `scene` has answered `shown`.
TruthTold truth_told(const Truth& truth, const Scene& scene, gjk::Status shown);

/// Returns: a fraction, "-3/2", as it is where it is short, and else "≈ 3.08e−33".
std::string short_fraction(const std::string& fraction);

/// Returns: infinite, or 0, where it is beyond doubles.
double nearest_double(const std::string& fraction);

}  // namespace walkthroughs::story
