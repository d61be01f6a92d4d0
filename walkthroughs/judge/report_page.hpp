/// What was found about a program, as a page: the verdict, probable causes, and pictures of its worst pairs.
#pragma once

#include <map>
#include <string>

#include "walkthroughs/judge/judged_text.hpp"
#include "walkthroughs/page/page.hpp"

namespace walkthroughs::judge {

/// The picture that stands for a walkthrough whose page lies beside.
struct ShownPicture {
  std::string url, step;     ///< its own, and that of the step of the page that it shows; both seen from this page
  std::string alt, caption;  ///< without markup
  PageJson cut;              ///< what of it is shown, as index_entry() says it
};

/// Returns: the page, in UTF-8, the walkthrough called parting_name above the worst pairs. It asks for nothing but pictures. `pictures`: by the names of their walkthroughs; of a pair that
/// is saved as 1.json that is "1". Requires: report.shown; a picture for each pair that can be drawn.
std::string report_page(const Report& report, const std::map<std::string, ShownPicture>& pictures);

}  // namespace walkthroughs::judge
