/// What the index says of a walkthrough. The data of its page begin with that, so that an index can be made of the pages
/// that are there.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "walkthroughs/page/page_pictures.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

using PageJson = nlohmann::ordered_json;

/// Returns: name, title, section; a sentence, with markup; the answers, one for each scene that differs; how many steps there
/// are; the last frame of each iteration, of a search; the frame that stands for it all, and what is shown of its picture.
PageJson index_entry(const Story& story, const PagePictures& pictures);

/// Returns: a script that sets window.gjkstep to `entry` and `story`; it may stand in a page, too, as no text in it ends a
/// script element.
std::string story_script(const PageJson& entry, const PageJson& story);

/// Returns: the entry; nothing where there is none that could be of gjkstep. `text`: the first bytes of such a script or of
/// a page that holds one, whoever has written them.
std::optional<PageJson> entry_in(std::string_view text);

/// Returns: JSON as a script of any page may have it.
std::string json_in_script(const PageJson& json);

/// Returns: of a region's walkthrough the iteration that it is about: that of the test which it explains, else of what it
/// explains first; nothing of others.
std::optional<int> told_iteration(const Walkthrough& w);

}  // namespace walkthroughs
