/// A walkthrough as one HTML page: all of its steps, each with its picture and what is said of it. With JavaScript one
/// steps through them; without it they stand below each other.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "walkthroughs/page/page_pictures.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// Something beside the page: a file or another page.
struct PageLink {
  std::string url, text;
};

/// Where a page comes from, and what is near. What is empty is left out.
struct PageSurroundings {
  std::string command;            ///< that made it
  std::string trace_command;      ///< that prints its trace
  std::vector<PageLink> sources;  ///< what it was made of, such as a scene file
  std::vector<PageLink> ways;     ///< to the index, and to the walkthroughs before and after
  bool has_files = false;         ///< beside it: page_files(), and its trace where there is a command for that
  /// Returns: the URL of another walkthrough's page; empty where there is none.
  std::function<std::string(const std::string& name)> page_of = [](const std::string&) { return std::string(); };
};

/// Returns: the page, in UTF-8. It asks for nothing but its pictures and the files beside it. Texts of the story are data:
/// nothing in them is read as HTML.
std::string page_html(const Story& story, const PagePictures& pictures, const PageSurroundings& surroundings);

/// A file beside a page.
struct PageFile {
  std::string name, content;
};

inline constexpr const char *style_file = "page.css", *script_file = "page.js", *steps_file = "steps.js",
                            *events_file = "events.js", *quiz_file = "predict.js", *questions_file = "questions.js",
                            *trace_file = "trace.jsonl";
/// Of these what page_files() makes.
inline constexpr std::array files_asked_for{style_file,  script_file, steps_file,
                                            events_file, quiz_file,   questions_file};

/// Returns: what a page asks for that does not hold it all: its style, its script, and what that needs to know of the steps; and
/// what is loaded when a reader asks for it, the events, the questions, and the script that asks them (data as scripts, too: pages
/// that are files themselves may read nothing else).
std::vector<PageFile> page_files(const Story& story, const PagePictures& pictures,
                                 const PageSurroundings& surroundings);

}  // namespace walkthroughs
