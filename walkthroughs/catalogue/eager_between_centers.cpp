#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs {

/// From one center to the other is a direction that separates most objects that are apart. Rules that test the first point,
/// too, need no second one then.
Walkthrough eager_between_centers() {
  const Scene eager =
      from_center_to_center({.name = "eager",
                             .a = {"triangle", points({{-3, -1, 0}, {0, -2, 0}, {0, 0, 0}})},
                             .b = {"quadrilateral", points({{2, 1, 0}, {4, 0, 0}, {5, 2, 0}, {3, 3, 0}})},
                             .rules = RuleSet::eager});
  Scene intended = eager;
  intended.name = "as intended";
  intended.rules = RuleSet::as_intended;
  return {.name = "eager-between-centers",
          .title = "The first point tested, too, and as the report has it",
          .source = "ARL-TR-7474, Section 3.1.3, varied",
          .summary = "two objects apart: from center to center, the first point may be proof enough",
          .layout = Layout::until_they_part,
          .naming = Naming::roles,
          .scenes = {eager, intended},
          .remarks = {{Remark::At::crossing_tested, 1,
                       "d leads from the center of the triangle to that of the quadrilateral, which separates most "
                       "objects that are apart"},
                      {Remark::At::end, 2, "the same answer, one move later"}}};
}

}  // namespace walkthroughs
