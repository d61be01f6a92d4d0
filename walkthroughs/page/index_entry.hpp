/// What the index says of a walkthrough. Its page holds that, too, so that an index can be made of the pages that are there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/page/page_pictures.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// A walkthrough on that page. Keeps no story.
struct IndexEntry {
  std::string name, title, section;
  std::string sentence;  ///< with markup
  std::string answer;    ///< "intersecting", one for each scene that differs; empty where no search is shown
  std::size_t steps = 0;
  std::vector<std::size_t> iteration_ends;  ///< frames; empty where no search is shown
  std::size_t picture = 0;                  ///< the frame that stands for it
  std::string picture_url;                  ///< seen from the index
  std::string cut;                          ///< the style that shows what its pages show of it, see cut_out()
  bool is_dark = false;                     ///< whether they are drawn on a dark ground
};

/// Returns: what the index says of a walkthrough, but for where its picture is.
IndexEntry index_entry(const Story& story, const PagePictures& pictures);

/// Returns: it as JSON, but for where its picture is.
std::string entry_json(const IndexEntry& entry);

/// As an element of a page.
std::string entry_element(const IndexEntry& entry);

/// Returns: what a page says of itself, but for where its picture is; nothing where it is none of gjkstep's.
/// `page`: its first bytes, whoever has written them.
std::optional<IndexEntry> entry_of(std::string_view page);

/// Returns: of a region's walkthrough the iteration that it is about: that of the test which it explains, else of what it explains
/// first; nothing of others.
std::optional<int> told_iteration(const Walkthrough& w);

}  // namespace walkthroughs
