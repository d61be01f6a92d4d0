/// The templates of pages, which the build has put into the program, each from the file of its name beside this one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace walkthroughs {

namespace templates {
extern const std::string_view page_html, page_css, page_js, predict_js, index_html, index_css, index_js, compare_html,
    compare_css, compare_js, colors_css;
}  // namespace templates

/// What stands in a template in place of {{name}}.
struct Filling {
  std::string_view name;
  std::string text;
};

/// Returns: the template with its places filled. What a filling says is taken as it is, also where it looks like a place.
/// Requires: a filling for each place.
std::string filled(std::string_view page, const std::vector<Filling>& fillings);

/// Returns: text with the markup of render/font.hpp as HTML, subscripts and all; nothing in it is read as HTML.
std::string html_of(std::string_view text);

/// Returns: JSON as it may stand in a script element of any page: no text in it ends the element.
std::string json_for_html(std::string json);

}  // namespace walkthroughs
