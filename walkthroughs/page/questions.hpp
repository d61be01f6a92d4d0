/// What a page asks before it shows a decision, made from the trace alone: what the algorithm may find there is what its lines
/// and the skipped regions say, and what it has found is the right answer.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

struct Choice {
  std::string text;    ///< here and below with the markup of render/font.hpp
  std::string reason;  ///< why it is right, or why the search has not gone there: a value, or why it need not be asked
  std::string
      hint;  ///< of the reason what leaves open which choice is right; empty where nothing does, and of the right one
};

/// Adds the choice where there is none of its text.
void add_once(std::vector<Choice>& choices, Choice choice);

/// What a decision was about, so that walkthroughs with the same one can be found.
struct Decision {
  enum class Kind { crossing, region, vertices, direction, line };
  Kind kind;
  int simplex_size;   ///< 0 for a crossing test, and a line of Algorithm 1
  std::string found;  ///< "crossed", or the last region that was chosen: "ABC > 0", "ADB AD > 0"; or the mistake
  friend bool operator==(const Decision&, const Decision&) = default;
};

struct Question {
  Decision decision;
  std::size_t scene;  ///< of the story,
  std::size_t event;  ///< of its trace, which answers it; what was told before may be known
  std::string text;
  std::vector<Choice>
      choices;        ///< in the order of their regions, else of the alphabet, lines in their own; no two alike
  std::size_t right;  ///< the one of them that is what the trace did
};

/// Returns: the questions about the searches of a story, scene by scene in the order of the events: at each crossing test that was
/// applied, each simplex that was processed, and on the way on from triangles and tetrahedra, where there is more than one; of a
/// proof at each feature that is kept. Of a search with a mistake beside the report's one question: which line is wrong.
std::vector<Question> questions_of(const Story& story);

}  // namespace walkthroughs
