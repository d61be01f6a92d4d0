/// The viewer of pages: HTML, CSS and JavaScript that stand beside this file, and that the build puts into the program.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::page {

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

/// Returns: the page with the files in it that it asks for, in the place where it does: these, and those of the viewer.
std::string with_inside(std::string html, std::map<std::string, std::string> files);

/// Returns: the elements, a line each; without URL the text as code.
std::string html_of(const std::vector<PageLink>& links);

}  // namespace walkthroughs::page
