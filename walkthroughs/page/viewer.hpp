/// The files of the viewer, as they stand beside this one: HTML, CSS and JavaScript, which the build puts into the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace walkthroughs {

/// A file of a page; or what stands in it in place of {{name}}.
struct PageFile {
  std::string name, content;
};

/// What leads to a file or another page.
struct PageLink {
  std::string url, text;
};

/// Returns: the content of one of them. Requires: there is one of that name.
std::string viewer_file(std::string_view name);

/// Returns: the text with its places filled. What a filling says is taken as it is, also where it looks like a place.
/// Requires: a filling for each place.
std::string filled(std::string_view text, const std::vector<PageFile>& fillings);

/// Returns: the page with those files in it that it asks for, in the place where it does.
std::string with_inside(std::string html, const std::vector<PageFile>& files);

/// Returns: the elements, a line each; without URL the text as code.
std::string html_of(const std::vector<PageLink>& links);

}  // namespace walkthroughs
