/// What is told of a search with a mistake, beside its events.
#pragma once

#include <cstddef>
#include <string>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// Returns: the line of the report's algorithm that the mistake has otherwise, and that was running when the report's search came to
/// that event, the first that differs; null where that is none, as in a trace whose searches are not of one pair.
const wrong_on_purpose::WrongLine* line_gone_wrong(Mistake mistake, const Trace& right, std::size_t event);

/// Returns: "Algorithm 2: if AO = 0; here: not asked", in the letters of a picture.
std::string both_lines(const wrong_on_purpose::WrongLine& line, const Names& names);

/// Returns: what the mistaken program has there, in these letters.
std::string wrong_text(const wrong_on_purpose::WrongLine& line, const Names& names);

/// Returns: whether Algorithm 1 would then say what is not true, or the search says nothing.
bool ends_wrongly(const Trace& mistaken, const Trace& right);

/// Returns: how the mistaken search ended beside the right one, and how many random pairs it takes to notice that mistake: without the
/// full stop.
std::string how_it_ended(Mistake mistake, const Trace& mistaken, const Trace& right);

}  // namespace walkthroughs::story
