/// Questions about pictures: what will the search decide? Whoever can tell from the picture alone has seen the decision.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace quiz {

/// The moment before a decision: which frame of a walkthrough shows it, and what the search decides next.
struct Question {
  walkthroughs::Walkthrough walkthrough;
  std::size_t frame;
  std::string kind;    ///< "space, triangle: below"
  std::string text;    ///< what is asked
  std::string answer;  ///< one of the words that the legend gives for it
};

/// Returns: at least `count` questions about random scenes, as many of each kind, in an order that tells nothing.
/// Deterministic. Requires: count >= 1.
std::vector<Question> questions(std::size_t count, std::uint64_t seed);

/// Returns: what readers are told before they look: the letters, the signs, and the words for answers.
std::string legend();

}  // namespace quiz
