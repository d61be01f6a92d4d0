/// A question about a search, with choices of which one is right.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace walkthroughs {

struct Choice {
  std::string text;    ///< here and below with the markup of render/font.hpp
  std::string reason;  ///< why it is right, or why the search has not gone there: a value, or why it need not be asked
  std::string
      hint;  ///< of the reason what leaves open which choice is right; empty where nothing does, and of the right one
  std::string asked = {};  ///< "AB_n·AO" where the reason is that one number; else empty
  std::string label = {};  ///< "R3" of "R3: beyond edge AB"; empty where the region has none
  int place = 10;          ///< the key of a region is its number; those of one place stand in order of the alphabet
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
      choices;        ///< in the order of their regions, else of the alphabet, lines in their own; no two alike
  std::size_t right;  ///< the one of them that is what the trace did
};

}  // namespace walkthroughs
