/// A whole search on one page.
#pragma once

#include "walkthroughs/output/paper_sheet.hpp"

namespace walkthroughs::output {

/// One page: the objects, each iteration as a row of a table, with pictures where they fit, and the answer with its reason. Of many
/// iterations the first and the last. Of diagrams their pictures and captions.
struct Handout : Printed {
  double free_from = 0;      ///< down to the margin there is room for more, in points
  std::size_t left_out = 0;  ///< iterations
  std::size_t pictures = 0;
};

/// Letters have least_points or more, apart from subscripts, and diagrams that are too wide.
Handout handout_of(const StagedStory& story, const Look& look, render::Font& font);

/// handout.pdf, as handout_of() lays it out.
OneFile handout();

}  // namespace walkthroughs::output
