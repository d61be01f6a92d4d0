/// The page on which two walkthroughs of a run step together.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/page/index_page.hpp"

namespace walkthroughs {

/// Returns: the walkthroughs that can be compared: those that show a search.
std::vector<IndexEntry> comparable(const std::vector<IndexEntry>& entries);

/// Returns: the page, in UTF-8, to stand beside the index. Requires: two entries or more, all comparable.
std::string compare_html(const std::vector<IndexEntry>& entries);

}  // namespace walkthroughs
