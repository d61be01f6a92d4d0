/// The walkthroughs of a run, grouped as the report goes.
#pragma once

#include <string_view>
#include <vector>

#include "walkthroughs/page/index_entry.hpp"

namespace walkthroughs {

struct IndexGroup {
  std::string_view title;
  std::vector<IndexEntry> entries;
};

/// Returns: no empty group, each entry in one, within each in their order.
std::vector<IndexGroup> in_groups(const std::vector<IndexEntry>& entries);

}  // namespace walkthroughs
