/// What is said of letters that the font does not have.
#pragma once

#include <set>
#include <string>

namespace walkthroughs {

/// Returns: "the font has no sign for 漢 (U+6F22), 字 (U+5B57): boxes stand in their place"; of many the first few, and how
/// many more. Characters that would not show, or change what does, are named by their codes alone. Requires: at least one.
std::string missing_letters(const std::set<char32_t>& codes);

}  // namespace walkthroughs
