#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/region_walkthrough.hpp"

namespace walkthroughs {

std::vector<Walkthrough> regions_of_0_simplex() {
  using At = Remark::At;
  return region_walkthroughs(
      0,
      {{.name = "elsewhere",
        .title = "the origin lies elsewhere",
        .summary = "a point has no regions: the search goes from A back toward the origin",
        .text = "A is not the origin: the origin lies elsewhere",
        .scene = in_the_plane(polygon("quadrilateral", {{1, 1}, {0, 3}, {-2, 1}, {-1, 0}}),
                              polygon("triangle", {{0, -1}, {1, -4}, {3, -3}})),
        .remarks = {{At::region_tested, 1, "a point has no sides to test, so the only way to go is back along AO", "A"},
                    {At::direction_chosen, 1,
                     "only this search starts from a point, all later ones start from an edge or a face"}}},
       {.name = "a-is-origin",
        .title = "A is the origin",
        .summary = "the first point found is the origin: the objects touch at one point",
        .text = "A is the origin",
        .scene = in_the_plane(polygon("square", {{-2, 0}, {-1, -2}, {1, -1}, {0, 1}}),
                              polygon("triangle", {{1, -1}, {3, 0}, {2, 2}})),
        .remarks = {{At::region_tested, 1, "a direction AO = 0 could not be searched, so this is tested first", "A"},
                    {At::end, 1, "they touch at one point, (1, −1), and touching counts as intersecting"}}}});
}

}  // namespace walkthroughs
