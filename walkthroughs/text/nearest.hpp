/// Suggestions for words that nobody knows.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace walkthroughs {

/// Returns: a candidate that begins with `word`, else the one that takes the fewest letters to reach from it (Levenshtein
/// distance); the first of several.
/// Requires: at least one candidate.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace walkthroughs
