#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs {

/// Algorithm 1 goes on to process the simplex after it has found P·dir < 0, and what it finds there may overwrite the
/// answer. Two unit balls ten apart are enough: the search finds the same point twice.
Walkthrough as_printed_spheres() {
  const Scene printed{.name = "as printed",
                      .a = {"disk a", Ball{{0, 0, 0}, 1}},
                      .b = {"disk b", Ball{{10, 0, 0}, 1}},
                      .rules = RuleSet::as_printed};
  Scene intended = printed;
  intended.name = "as intended";
  intended.rules = RuleSet::as_intended;
  return {
      .name = "as-printed-spheres",
      .title = "Algorithm 1 as printed, and as its text means it",
      .source = "ARL-TR-7474, Section 3.1.4",
      .summary = "two spheres far apart: read literally, Algorithm 1 finds a collision",
      .layout = Layout::until_they_part,
      .naming = Naming::roles,
      .scenes = {printed, intended},
      .remarks = {{Remark::At::region_tested, 2,
                   "wrongly: A and B are the same point, so every product with AB is zero, wherever the origin is"}}};
}

}  // namespace walkthroughs
