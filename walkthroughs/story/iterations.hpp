/// What happened in each iteration of a search, in few words: a table of the whole.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// In the letters that its vertices have there. What did not happen is empty.
struct IterationTold {
  int number;
  std::size_t last = 0;                   ///< of its events
  std::vector<std::string> found = {};    ///< the direction, the support point, how far that reaches
  std::vector<std::string> decided = {};  ///< each region or proof, then the number that decided
  std::string simplex = {};               ///< that is left at its end, "[B, A]"
  std::string next = {};                  ///< the formula of the next direction, or the answer
};

/// Returns: the iterations of the search of a scene.
std::vector<IterationTold> iterations_told(const Story& story, std::size_t scene);

}  // namespace walkthroughs::story
