/// What is told of a search with a mistake, beside its events.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// Returns: the line of the report's algorithm that the mistake has otherwise, and that was running when the report's search came to
/// that event, the first that differs; null where that is none, as in a trace whose searches are not of one pair.
const wrong_on_purpose::WrongLine* line_gone_wrong(Mistake mistake, const Trace& right, std::size_t event);

/// Returns: what the mistaken program has there, in these letters.
std::string wrong_text(const wrong_on_purpose::WrongLine& line, const Names& names);

/// A mistake in words for the frame where the two searches part and for the last one.
struct ToldMistake {
  std::string meaning;
  std::optional<std::string> lines;  ///< "Algorithm 2: if AO = 0; here: not asked"
  /// How the mistaken search ended beside the right one, and how many random pairs it takes to notice that mistake: without the
  /// full stop.
  std::string ending;
  bool is_wrong_there;
  bool ends_wrongly;  ///< whether Algorithm 1 would then say what is not true, or the search says nothing
};

/// Returns: that of the first of two searches which have that many events in common; nothing where there is none, or it does not
/// show.
std::optional<ToldMistake> mistake_told(const Story& story, std::size_t common);

}  // namespace walkthroughs::story
