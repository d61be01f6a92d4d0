/// What a page asks before it shows a decision, made from the trace alone: what the algorithm may find there is what its lines
/// and the skipped regions say, and what it has found is the right answer.
#pragma once

#include <vector>

#include "walkthroughs/page/question.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// Returns: the questions about the searches of a story, scene by scene in the order of the events: at each crossing test that was
/// applied, each simplex that was processed, and on the way on from triangles and tetrahedra, where there is more than one; of a
/// proof at each feature that is kept. Of a search with a mistake beside the report's one question: which line is wrong.
std::vector<Question> questions_of(const Story& story);

}  // namespace walkthroughs
