/// The index: what it says of a walkthrough, and the pages over all of them. The data of a walkthrough's page begin
/// with its entry, so that an index can be made of the pages that are there.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::page {

using PageJson = nlohmann::ordered_json;

/// The pictures that a page shows, one a frame; drawn already, or to be drawn.
struct PagePictures {
  std::function<std::string(std::size_t frame, int turn)>
      url;                ///< of a picture, seen from the page; `turn` 0: the usual view
  render::Size page;      ///< on which they are laid out,
  render::Box part;       ///< and what of it is shown
  double text_scale = 1;  ///< of their text, which that of the page follows
  int turns = 0;          ///< further views of each, all around
  bool is_dark = false;   ///< drawn on a dark ground
};

/// Returns: name, title, section; a sentence, with markup; the answer of each scene; how many steps there are; the last
/// frame of each iteration, of a search; the frame that stands for it all, and what is shown of its picture.
PageJson index_entry(const Story& story, const PagePictures& pictures);

/// Returns: a script that sets window.gjkstep to `entry` and `story`; it may stand in a page, too, as no text in it
/// ends a script element.
std::string story_script(const PageJson& entry, const PageJson& story);

/// Returns: the entry; nothing where there is none that could be of gjkstep. `text`: the first bytes of such a script
/// or of a page that holds one, whoever has written them.
std::optional<PageJson> entry_in(std::string_view text);

/// Returns: JSON as a script of any page may have it.
std::string json_in_script(const PageJson& json);

/// Returns: of a region's walkthrough the iteration that it is about: that of the test which it explains, else of what
/// it explains first; nothing of others.
std::optional<int> told_iteration(const Walkthrough& w);

/// Returns: the entries as [{"title", "entries"}], grouped as the report goes; no group is empty, within each is their
/// order.
PageJson in_groups(const std::vector<PageJson>& entries);

/// Returns: a page of the viewer, "index.html" or "compare.html", with the entries in it, in UTF-8. It is to stand in
/// the folder that holds one for each walkthrough. Requires: each has, beside what index_entry() says, its
/// "picture_url".
std::string page_over(const std::vector<PageJson>& entries, const std::string& viewer_page);

}  // namespace walkthroughs::page
