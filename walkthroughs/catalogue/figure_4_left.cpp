#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_4_objects.hpp"

namespace walkthroughs {

Walkthrough figure_4_left() {
  return {.name = "figure-4-left",
          .title = "Figure 4, left: the objects intersect",
          .source = "ARL-TR-7474, Section 3.1.2",
          .summary = "the difference contains the origin; the search goes A, E, G, F",
          .scenes = {figure_4_left_scene()},
          .remarks = {{Remark::At::support_found, 2, "F is not returned, because E lies slightly farther"},
                      {Remark::At::support_found, 3, "straight down would have found F, but the slant finds G"}}};
}

}  // namespace walkthroughs
