#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_4_objects.hpp"

namespace walkthroughs {

Walkthrough figure_4_right() {
  return {.name = "figure-4-right",
          .title = "Figure 4, right: the objects are apart",
          .source = "ARL-TR-7474, Section 3.1.3",
          .summary = "the origin is not crossed at E, so the search ends there (Eq. 9)",
          .scenes = {figure_4_right_scene()},
          .remarks = {{Remark::At::end, 2, "Section 3.1.2 does not use the test yet and goes on to F"}}};
}

}  // namespace walkthroughs
