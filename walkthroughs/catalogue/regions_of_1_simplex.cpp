// Figure 6 names the sides of AB, Algorithm 3 treats them alike ("R3 or R4"). Here R3 is the left side of the move from B to
// A and R4 the right side, so that R3 of the segment AB is on the same side as R3 of the triangle ABC in Figure 7.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/region_walkthrough.hpp"

namespace walkthroughs {
namespace {

using At = Remark::At;

std::vector<RegionRow> sides() {
  return {{.name = "r3",
           .title = "the origin lies in R3",
           .summary = "the origin lies to the left of the move from B to A",
           .text = "R3: the origin lies to the left of the move from B to A",
           .scene = in_the_plane(polygon("triangle a", {{-2, 3}, {-3, 1}, {0, 0}}),
                                 polygon("triangle b", {{-1, -2}, {2, -2}, {0, 1}})),
           .remarks = {{At::region_tested, 2, "it lies to the left of the move from B to A, in R3", "R3 or R4"},
                       {At::direction_chosen, 2, "AB×AO×AB is perpendicular to AB and points to the origin's side"}}},
          {.name = "r4",
           .title = "the origin lies in R4",
           .summary = "the origin lies to the right of the move from B to A: the same expression as for R3",
           .text = "R4: the origin lies to the right of the move from B to A",
           .scene = in_the_plane(polygon("quadrilateral", {{0, -3}, {1, -1}, {-2, 0}, {-2, -2}}),
                                 polygon("triangle", {{1, 0}, {3, 1}, {0, 3}})),
           .remarks = {{At::region_tested, 2, "it lies to the right of the move from B to A, in R4", "R3 or R4"},
                       {At::direction_chosen, 2, "AB×AO×AB serves R3 and R4 alike, while AO might lead back to B"}}}};
}

std::vector<RegionRow> boundaries() {
  return {{.name = "on-segment",
           .title = "the origin lies on AB",
           .summary = "AB and AO are parallel, AB×AO×AB is zero: the objects intersect",
           .text = "the origin lies on the segment AB",
           .scene = in_the_plane(polygon("parallelogram", {{-2, -1}, {-1, -3}, {0, 0}, {-1, 2}}),
                                 polygon("triangle", {{0, 1}, {1, 3}, {-2, 2}})),
           .remarks = {{At::region_tested, 2, "AB and AO are parallel, so AB×AO = 0 and no direction is left to search",
                        "AB"},
                       {At::end, 2, "a search along the zero vector would have no meaning, hence the test for zero"}}},
          {.name = "a-is-origin",
           .title = "A is the origin",
           .summary = "AO is zero, and with it AB×AO×AB: the objects touch at one point",
           .text = "A is the origin",
           .scene = in_the_plane(polygon("parallelogram", {{-1, -2}, {0, -1}, {-1, 1}, {-2, 0}}),
                                 polygon("triangle", {{-1, 1}, {2, 3}, {0, 4}})),
           .remarks = {{At::region_tested, 2,
                        "A is the origin: AO = 0, and the test for the segment covers this case too", "AB"},
                       {At::end, 2, "they touch at one point, (−1, 1), and touching counts as intersecting"}}}};
}

std::vector<RegionRow> impossible() {
  return {
      {.name = "r1-cannot-happen",
       .title = "the origin cannot lie in R1",
       .summary = "R1 lies beyond B, and the search has just left B toward the origin",
       .text = "R1: beyond B; skipped, because the search left B toward the origin",
       .scene = in_the_plane(polygon("quadrilateral", {{-1, -3}, {1, -1}, {0, 2}, {-3, -1}}),
                             polygon("triangle", {{1, 3}, {0, 1}, {3, 2}})),
       .remarks = {{At::direction_chosen, 1, "the search turns its back on what will be R1, beyond B"},
                   {At::region_tested, 2,
                    "this test would not notice R1, but the move from B to A went along BO, away from R1",
                    "R3 or R4"}}},
      {.name = "r2-cannot-happen",
       .title = "the origin cannot lie in R2",
       .summary = "R2 lies beyond A: where the origin lies there, the crossing test has ended the search",
       .text = "R2: beyond A; skipped, because the move to A crossed the origin",
       .scene = in_the_plane(polygon("triangle", {{1, 2}, {-1, 2}, {0, -1}}),
                             polygon("rhombus", {{-3, -2}, {-1, -3}, {-2, -1}, {-4, 0}})),
       .remarks = {{At::end, 2,
                    "were P added as A, the origin would lie in R2: the crossing test has ended the search before"}}}};
}

}  // namespace

std::vector<Walkthrough> regions_of_1_simplex() {
  std::vector<RegionRow> rows = sides();
  for (const auto& more : {boundaries(), impossible()}) rows.insert(rows.end(), more.begin(), more.end());
  return region_walkthroughs(1, std::move(rows));
}

}  // namespace walkthroughs
