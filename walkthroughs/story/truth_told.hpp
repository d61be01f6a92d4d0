/// What is true of a scene, told beside what its search answers.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// Returns: "together", "apart" or "no answer".
std::string words_for_answer(gjk::Status answer);

/// Returns: what they do: "intersect" or "are apart". Requires: an answer.
std::string in_truth(gjk::Status answer);

/// What there is to tell of a scene beside what its search answers. All of it is empty where there is nothing.
struct TruthTold {
  std::string predicate;    ///< what the objects do in truth: "intersect"; empty where the search answers that
  std::vector<Fact> facts;  ///< why, and what else is to tell
  std::string note;         ///< without a picture: "In doubles: apart. In truth: together."
};

/// Requires: that the search of `scene` has answered `shown`.
TruthTold truth_told(const Truth& truth, const Scene& scene, gjk::Status shown);

}  // namespace walkthroughs::story
