#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_4_objects.hpp"

namespace walkthroughs {

/// Both sets side by side as the report prints them. The right one goes on to F, which Section 3.1.2 tells before
/// Section 3.1.3 introduces the crossing test; so both are shown without it.
Walkthrough figure_4() {
  Scene left = figure_4_left_scene(), right = figure_4_right_scene();
  left.options.crossing_test = right.options.crossing_test = gjk::CrossingTest::off;
  return {.name = "figure-4",
          .title = "Figure 4: two difference sets",
          .source = "ARL-TR-7474, Section 3.1.2",
          .summary = "both sets, iteration by iteration: the left one contains the origin, the right one does not",
          .layout = Layout::in_step,
          .scenes = {left, right}};
}

}  // namespace walkthroughs
