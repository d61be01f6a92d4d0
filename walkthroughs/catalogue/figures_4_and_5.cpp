// Figure 4, both sets and each by itself, and the close-up of Figure 5.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_objects.hpp"

namespace walkthroughs::catalogue {
namespace {

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

Walkthrough figure_4_left() {
  return {.name = "figure-4-left",
          .title = "Figure 4, left: the objects intersect",
          .source = "ARL-TR-7474, Section 3.1.2",
          .summary = "the difference contains the origin; the search goes A, E, G, F",
          .scenes = {figure_4_left_scene()},
          .remarks = {{Remark::At::support_found, 2, "F is not returned, because E lies farther along d"},
                      {Remark::At::support_found, 3, "straight down would have found F, but the slant finds G"}}};
}

Walkthrough figure_4_right() {
  return {.name = "figure-4-right",
          .title = "Figure 4, right: the objects are apart",
          .source = "ARL-TR-7474, Section 3.1.3",
          .summary = "the origin is not crossed at E, so the search ends there (Eq. 9)",
          .scenes = {figure_4_right_scene()},
          .remarks = {{Remark::At::end, 2, "Section 3.1.2 does not use the test yet and goes on to F"}}};
}

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

Walkthrough figure_5() {
  return {.name = "figure-5",
          .title = "Figure 5: was the origin crossed?",
          .source = "ARL-TR-7474, Section 3.1.3",
          .summary = "the move from A to E in both sets of Figure 4, close up: crossed and not crossed",
          .layout = Layout::close_ups,
          .scenes = {figure_4_left_scene(), figure_4_right_scene()},
          .close_up = CloseUp{.iteration = 2,
                              .direction = "In both sets the search goes from A along d, toward the origin.",
                              .support = "In both sets the support point along d is E.",
                              .crossing = "On the left the move to E passes the origin. On the right it stops short of "
                                          "it, so the right set does not contain it."}};
}

}  // namespace

std::vector<Walkthrough> figures_4_and_5() {
  return {figure_4(), figure_4_left(), figure_4_right(), figure_4_right_no_crossing_test(), figure_5()};
}

}  // namespace walkthroughs::catalogue
