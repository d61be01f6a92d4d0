/// What a page asks before it shows a decision: a question about a search, with choices of which one is right. Made
/// from the trace alone: what the algorithm may find there is what its lines and the skipped regions say, and what it
/// has found is right.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::page {

/// Where a choice can be pointed at in a picture of the difference.
struct Aim {
  Point at;          ///< in the difference, in the scene's own unit
  Point toward;      ///< from there it is moved a little that way, so that aims at one place do not cover each other
  std::string name;  ///< in a word or two: "R3", "above", "drop C"
  gjk::Roles face = {};    ///< in whose plane picture it is plain, where there is one;
  bool is_height = false;  ///< whether in that which shows the face edge-on
};

struct Choice {
  std::string text;  ///< here and below with the markup of render/font.hpp
  /// Why it is right, or why the search has not gone there: a value, or why it need not be asked.
  std::string reason = {};
  /// Of the reason what leaves open which choice is right; empty where nothing does, and of the right one.
  std::string hint = {};
  std::string asked = {};       ///< "AB_n·AO" where the reason is that one number; else empty
  std::string label = {};       ///< "R3" of "R3: beyond edge AB"; empty where the region has none
  std::optional<Aim> aim = {};  ///< nothing where it cannot be pointed at
  int place = 10;  ///< the key of a region is its number; those of one place stand in order of the alphabet
};

/// Adds the choice where there is none of its text.
inline void add_once(std::vector<Choice>& choices, Choice choice) {
  if (std::ranges::count(choices, choice.text, &Choice::text) == 0) choices.push_back(std::move(choice));
}

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
      choices;                ///< in the order of their regions, else of the alphabet, lines in their own; no two alike
  std::size_t right;          ///< the one of them that is what the trace did
  bool tells_before = false;  ///< whether its text tells the answer of the one before
  std::size_t frame = 0;      ///< that answers it; the one before shows what it is about
};

/// Returns: the questions about the searches of a story, scene by scene in the order of the events: at each crossing
/// test that was applied, each simplex that was processed, and on the way on from triangles and tetrahedra, where there
/// is more than one; of a proof at each feature that is kept. Of a search with a mistake beside the report's one
/// question: which line is wrong.
std::vector<Question> questions_of(const Story& story);

/// Returns: those which a frame answers, while the frame before it shows what is asked about. It does not where there is one frame an
/// iteration.
std::vector<Question> in_frames(const std::vector<Question>& questions, const Story& story);

/// Returns: in which line the mistake is. Among the lines that ran there is exactly one that the mistaken program has
/// otherwise: others that it has otherwise, too, are left out. Nothing where the searches do not part. Requires:
/// story.shows_mistake().
std::optional<Question> question_of_line(const Story& story);

/// Returns: where one practises a decision that one has got wrong: the name of a walkthrough of regions, but not `but`,
/// whose search comes to decide so, best one that is about that; else about the same face or feature. Of a mistake that
/// of the case which it gets wrong. Empty where there is none.
std::string practice_for(const Decision& decision, const std::string& but);

}  // namespace walkthroughs::page
