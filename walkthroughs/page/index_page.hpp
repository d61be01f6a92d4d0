/// The page over all walkthroughs of a run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// A walkthrough on that page. Keeps no story.
struct IndexEntry {
  std::string name, title, section;
  std::string sentence;  ///< HTML
  std::string answer;    ///< "intersecting", one for each scene that differs; empty where no search is shown
  std::size_t steps = 0;
  std::vector<std::size_t> iteration_ends;  ///< frames; empty where no search is shown
  std::size_t picture = 0;                  ///< the frame that stands for it
  std::string picture_url;                  ///< seen from the index
  render::Size page;                        ///< on which its pictures are laid out,
  render::Box part;                         ///< and what of it is shown
  bool is_dark = false;                     ///< whether they are drawn on a dark ground
};

/// Returns: what the index says of a walkthrough, but for its pictures.
IndexEntry index_entry(const Story& story);

/// Returns: the page, in UTF-8, to stand in the folder that holds one for each walkthrough; groups as the report goes, within
/// each the order of the entries.
/// `compare_url`: where two of them can be compared; empty where they cannot.
std::string index_html(const std::vector<IndexEntry>& entries, const std::string& compare_url = "");

}  // namespace walkthroughs
