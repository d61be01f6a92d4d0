/// A walkthrough as a page: its data, and the viewer that steps through them. Without JavaScript its pictures and
/// captions stand below each other. And the pages over all walkthroughs.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/font.hpp"
#include "render/geometry.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::page {

// -- The viewer: HTML, CSS and JavaScript that stand beside this file, and that the build puts into the program -----------

/// A file of a page; or what stands in it in place of {{name}}.
struct PageFile {
  std::string name, content;
};

/// What leads to a file or another page.
struct PageLink {
  std::string url, text;
};

/// The names of the viewer's files, and what is in them.
extern const std::map<std::string, std::string> viewer_files;

/// Returns: the text with its places filled. What a filling says is taken as it is, also where it looks like a place.
/// Requires: a filling for each place.
std::string filled(std::string_view text, const std::vector<PageFile>& fillings);

/// Returns: the page with the files in it that it asks for, in the place where it does: these, and those of the viewer; its policy
/// lets in these, and nothing else that stands in it.
std::string with_inside(std::string html, std::map<std::string, std::string> files);

/// Returns: the elements, a line each; without URL the text as code.
std::string html_of(const std::vector<PageLink>& links);

// -- The index: what it says of a walkthrough ---------------------------------------------------------------------------

// The data of a walkthrough's page begin with its entry, so that an index can be made of the pages that are there.

using PageJson = nlohmann::ordered_json;

/// The pictures that a page shows, one a frame; drawn already, or to be drawn.
struct PagePictures {
  std::function<std::string(std::size_t frame, int turn)>
      url;                       ///< of a picture, seen from the page; `turn` 0: the usual view
  render::Size page = {};        ///< on which they are laid out,
  render::Box part = {};         ///< and what of it is shown
  double text_scale = 1;         ///< of their text, which that of the page follows
  int turns = 0;                 ///< further views of each, all around
  bool is_dark = false;          ///< drawn on a dark ground
  render::Font* font = nullptr;  ///< to draw graphs with, which stand in the data; without it there are none
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

/// Returns: the entries as [{"title", "entries"}], grouped as the report goes; no group is empty, within each is their
/// order.
PageJson in_groups(const std::vector<PageJson>& entries);

/// Returns: the place of its group among all.
std::size_t group_place(const std::string& name);

/// Returns: a page of the viewer, "index.html" or "compare.html", with the entries in it, in UTF-8. It is to stand in
/// the folder that holds one for each walkthrough. Requires: each has, beside what index_entry() says, its
/// "picture_url".
std::string page_over(const std::vector<PageJson>& entries, const std::string& viewer_page);

// -- The page of a walkthrough ------------------------------------------------------------------------------------------

/// Where a page comes from, and what is near.
struct PageSurroundings {
  std::string command = {};            ///< that made it
  std::vector<PageLink> sources = {};  ///< what it was made of, such as a scene file; its trace
  std::vector<PageLink> ways = {};     ///< to the index, and to the walkthroughs before and after
  bool has_files_beside = false;       ///< else the page holds all that it needs
  /// What the program in the page is asked to tell (live.hpp), and the URLs of page_programs(); null and none where there is no
  /// program.
  PageJson live = nullptr;
  std::vector<std::string> programs = {};
  /// Returns: the URL of another walkthrough's page; empty where there is none.
  std::function<std::string(const std::string& name)> page_of = [](const std::string&) { return std::string(); };
};

inline constexpr const char *page_file = "index.html", *story_file = "story.js", *events_file = "events.js";

/// Returns: the names of all files that a page may have.
std::vector<std::string> page_file_names();

/// Returns: scripts that set window.gjkstepProgram and window.gjkstepAllSearches to programs of live.hpp, compiled for pages: base64 of
/// them, deflated. The first is what a page asks, until it needs the other one. None where this was built without.
const std::vector<PageFile>& page_programs();

/// Returns: what a page shows: entry of the index apart, each frame with its pictures, captions, numbers and running
/// lines, and the questions that can be asked before a frame. `only`: briefly, of that frame alone; null in place of the others.
PageJson page_data(const Story& story, const PagePictures& pictures, const PageSurroundings& around,
                   std::optional<std::size_t> only = {});

/// Returns: the files of a page, last the one to open, which asks for the others. They ask for nothing else but the
/// pictures. Data are scripts, as pages that are files themselves may read nothing else; texts in them are data, never
/// HTML.
std::vector<PageFile> page_files(const Story& story, const PagePictures& pictures, const PageSurroundings& around);

}  // namespace walkthroughs::page
