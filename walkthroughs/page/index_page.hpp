/// The pages over all walkthroughs of a run: the index, and the one on which two of them step together.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/page/index_entry.hpp"

namespace walkthroughs {

/// Returns: the entries as [{"title", "entries"}], grouped as the report goes; no group is empty, within each is their order.
PageJson in_groups(const std::vector<PageJson>& entries);

/// Returns: a page of the viewer, "index.html" or "compare.html", with the entries in it, in UTF-8. It is to stand in the
/// folder that holds one for each walkthrough. Requires: each has, beside what index_entry() says, its "picture_url".
std::string page_over(const std::vector<PageJson>& entries, const std::string& viewer_page);

}  // namespace walkthroughs
