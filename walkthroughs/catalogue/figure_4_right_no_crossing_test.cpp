#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_4_objects.hpp"

namespace walkthroughs {

Walkthrough figure_4_right_no_crossing_test() {
  Scene scene = figure_4_right_scene();
  scene.options.crossing_test = gjk::CrossingTest::off;
  return {.name = "figure-4-right-no-crossing-test",
          .title = "Figure 4, right, without the crossing test",
          .source = "ARL-TR-7474, Section 3.1.2",
          .summary = "the search goes A, E, F and ends when it runs out of points",
          .scenes = {scene},
          .remarks = {{Remark::At::region_tested, 2,
                       "it lies beyond E, in R2, which only the crossing test would have noticed"},
                      {Remark::At::end, 4, "with the test of Section 3.1.3 it would have ended at E in iteration 2"}}};
}

}  // namespace walkthroughs
