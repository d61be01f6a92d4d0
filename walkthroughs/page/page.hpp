/// A walkthrough as a page: its data, and the viewer that steps through them. Without JavaScript its pictures and
/// captions stand below each other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "walkthroughs/page/index_entry.hpp"
#include "walkthroughs/page/viewer.hpp"

namespace walkthroughs::page {

/// Where a page comes from, and what is near.
struct PageSurroundings {
  std::string command = {};            ///< that made it
  std::vector<PageLink> sources = {};  ///< what it was made of, such as a scene file; its trace
  std::vector<PageLink> ways = {};     ///< to the index, and to the walkthroughs before and after
  bool has_files_beside = false;       ///< else the page holds all that it needs
  /// Returns: the URL of another walkthrough's page; empty where there is none.
  std::function<std::string(const std::string& name)> page_of = [](const std::string&) { return std::string(); };
};

inline constexpr const char *page_file = "index.html", *story_file = "story.js", *events_file = "events.js";

/// Returns: the names of all files that a page may have.
std::vector<std::string> page_file_names();

/// Returns: what a page shows: entry of the index apart, each frame with its pictures, captions, numbers and running
/// lines, and the questions that can be asked before a frame.
PageJson page_data(const Story& story, const PagePictures& pictures, const PageSurroundings& around);

/// Returns: the files of a page, last the one to open, which asks for the others. They ask for nothing else but the
/// pictures. Data are scripts, as pages that are files themselves may read nothing else; texts in them are data, never
/// HTML.
std::vector<PageFile> page_files(const Story& story, const PagePictures& pictures, const PageSurroundings& around);

}  // namespace walkthroughs::page
