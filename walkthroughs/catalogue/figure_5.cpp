#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_4_objects.hpp"

namespace walkthroughs {

Walkthrough figure_5() {
  return {.name = "figure-5",
          .title = "Figure 5: was the origin crossed?",
          .source = "ARL-TR-7474, Section 3.1.3",
          .summary = "the move from A to E in both sets of Figure 4, close up: crossed and not crossed",
          .layout = Layout::close_ups,
          .scenes = {figure_4_left_scene(), figure_4_right_scene()},
          .close_up = CloseUp{.iteration = 2,
                              .direction = "In both sets the search goes from A along d, toward the origin.",
                              .support = "In both sets the farthest point along d is E.",
                              .crossing = "On the left the move to E passes the origin; on the right it stops short of "
                                          "it, so the origin is not in the difference."}};
}

}  // namespace walkthroughs
