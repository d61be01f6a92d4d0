/// The page over all walkthroughs of a run.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/page/index_entry.hpp"

namespace walkthroughs {

/// Returns: the page, in UTF-8, to stand in the folder that holds one for each walkthrough; groups as the report goes, within
/// each the order of the entries.
/// `compare_url`: where two of them can be compared; empty where they cannot.
std::string index_html(const std::vector<IndexEntry>& entries, const std::string& compare_url = "");

}  // namespace walkthroughs
