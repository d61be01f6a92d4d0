#include "walkthroughs/page/index_groups.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace walkthroughs {
namespace {

struct Known {
  std::string_view prefix, title;
};

/// As the report goes; a walkthrough belongs to the first whose prefix its name has, and what has none is the user's own.
constexpr std::array<Known, 14> groups{{{"figure-", "Figures of the report"},
                                        {"regions/0-simplex", "Regions of a 0-simplex, a vertex"},
                                        {"regions/1-simplex", "Regions of a 1-simplex, a segment"},
                                        {"regions/2-simplex", "Regions of a 2-simplex, a triangle"},
                                        {"regions/3-simplex", "Regions of a 3-simplex, a tetrahedron"},
                                        {"vehicle-and-threat/", "In space: vehicles and threats"},
                                        {"cycle-", "Where it goes wrong"},
                                        {"as-printed-", "Where it goes wrong"},
                                        {"failures/", "Where it goes wrong"},
                                        {"complete/", "The remedy: rules that end"},
                                        {"certified/", "Answers that are proven"},
                                        {"eager-", "A shortcut of ours"},
                                        {"mistakes/", "Mistakes"},
                                        {"", "Scenes of your own"}}};

std::string_view title_for(const IndexEntry& entry) {
  return std::ranges::find_if(groups, [&](const Known& group) { return entry.name.starts_with(group.prefix); })->title;
}

}  // namespace

std::vector<IndexGroup> in_groups(const std::vector<IndexEntry>& entries) {
  std::vector<IndexGroup> found;
  for (const Known& group : groups) {
    if (!found.empty() && found.back().title == group.title) continue;
    IndexGroup next{group.title, {}};
    std::ranges::copy_if(entries, std::back_inserter(next.entries),
                         [&](const IndexEntry& entry) { return title_for(entry) == group.title; });
    if (!next.entries.empty()) found.push_back(std::move(next));
  }
  return found;
}

}  // namespace walkthroughs
