#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/region_walkthrough.hpp"

namespace walkthroughs {
namespace {

using At = Remark::At;

std::vector<RegionRow> beyond_an_edge() {
  return {
      {.name = "r3",
       .title = "the origin lies in R3",
       .summary = "the origin lies beyond AB: C is dropped",
       .text = "R3: the origin lies beyond AB",
       .scene = in_the_plane(polygon("quadrilateral", {{1, 2}, {-1, 3}, {-1, 1}, {2, 0}}),
                             polygon("triangle", {{0, -1}, {-1, 2}, {-2, -1}})),
       .remarks = {{At::region_tested, 3, "ABn lies in the plane of the triangle and points out of it across AB", "R3"},
                   {At::reduced, 3, "C lies on the far side of AB"},
                   {At::direction_chosen, 3,
                    "ABn would do in the plane, but not in space, where the origin may lie above "
                    "or below the triangle"}}},
      {.name = "r7",
       .title = "the origin lies in R7",
       .summary = "the origin lies beyond AC: B is dropped",
       .text = "R7: the origin lies beyond AC",
       .scene = in_the_plane(polygon("triangle", {{2, 0}, {1, 3}, {-2, 1}}),
                             polygon("parallelogram", {{0, -1}, {2, -4}, {3, -2}, {1, 1}})),
       .remarks = {{At::region_tested, 3, "ACn = ABCn×AC: in the other order it would point into the triangle", "R7"},
                   {At::reduced, 3, "[C, A] is listed oldest first, so A stays the newest"}}}};
}

std::vector<RegionRow> above_below_within() {
  return {{.name = "r1-above",
           .title = "the origin lies in R1, above the triangle",
           .summary = "the origin lies above ABC: nothing is dropped, the search goes along ABCn",
           .text = "R1: the origin lies above the triangle",
           .scene = in_space(polyhedron("pyramid", {{4, 3, 0}, {1, 4, 0}, {0, 1, 0}, {3, 0, 0}, {2, 2, 4}}),
                             polyhedron("triangle", {{3, 1, 4}, {2, 1, 1}, {3, -2, 2}})),
           .remarks = {{At::region_tested, 3, "above is the side to which ABCn = AB×AC points", "R1"},
                       {At::direction_chosen, 3,
                        "the order stays [C, B, A], so BC×BD of the next simplex will be ABCn and "
                        "point to its A"}}},
          {.name = "r1-below",
           .title = "the origin lies in R1, below the triangle",
           .summary = "the origin lies below ABC: A and B change places, the search goes along −ABCn",
           .text = "R1: the origin lies below the triangle",
           .scene = in_space(polyhedron("tetrahedron a", {{2, 1, -3}, {3, 1, 0}, {1, 3, 1}, {1, 0, -1}}),
                             polyhedron("tetrahedron b", {{2, 2, -2}, {2, 0, 1}, {4, -2, -2}, {0, 0, -1}})),
           .remarks = {{At::region_tested, 3, "below is the side to which −ABCn points", "R1"},
                       {At::reduced, 3,
                        "swapping A and B turns the normal round, so BC×BD of the next simplex will be −ABCn "
                        "and point to its A"},
                       {At::region_tested, 4, "without the swap the three normals would now point inward", "ABCD"}}},
          {.name = "r1-in-plane",
           .title = "the origin lies in R1, in the triangle",
           .summary = "the origin lies in the triangle itself: the objects intersect",
           .text = "R1: the origin lies in the triangle",
           .scene = in_the_plane(polygon("kite a", {{0, -1}, {-1, 0}, {-2, -1}, {-1, -3}}),
                                 polygon("kite b", {{-1, 2}, {-2, 0}, {-1, -1}, {0, 0}})),
           .remarks = {{At::region_tested, 3,
                        "neither R3 nor R7, which leaves R1, and ABCn·AO = 0: not above, not below", "R1"}}}};
}

std::vector<RegionRow> boundaries() {
  return {
      {.name = "on-edge",
       .title = "the origin lies on an edge",
       .summary = "the origin lies on AB: the edge tests say no, ABCn·AO is zero, the objects intersect",
       .text = "the origin lies on the edge AB",
       .scene = in_the_plane(polygon("rectangle", {{-2, -1}, {0, 1}, {-1, 2}, {-3, 0}}),
                             polygon("parallelogram", {{-1, 2}, {-2, 4}, {-3, 3}, {-2, 1}})),
       .remarks = {{At::region_tested, 3, "ABn·AO = 0: the origin lies on AB, and on the edge is not beyond it", "R3"},
                   {At::region_tested, 3, "an edge belongs to R1, so this case needs no test of its own", "R1"}}},
      {.name = "on-vertex",
       .title = "the origin is a vertex",
       .summary = "A is the origin: every product with AO is zero, the objects touch at one point",
       .text = "A is the origin",
       .scene = in_the_plane(polygon("triangle", {{-2, 2}, {-3, -1}, {-1, 0}}),
                             polygon("parallelogram", {{1, 3}, {-1, 3}, {-2, 2}, {0, 2}})),
       .remarks = {
           {At::region_tested, 3, "AO = 0 makes all three products zero, which leads to R1 and to the answer", "R1"},
           {At::end, 3, "they touch at one point, (−2, 2), and touching counts as intersecting"}}}};
}

std::vector<RegionRow> impossible() {
  return {
      {.name = "r2-cannot-happen",
       .title = "the origin cannot lie in R2",
       .summary = "R2 lies beyond A: where the origin lies there, the crossing test has ended the search",
       .text = "R2: beyond A; skipped, because the move to A crossed the origin",
       .scene = in_the_plane(polygon("triangle a", {{-2, -1}, {-2, -3}, {1, -3}}),
                             polygon("triangle b", {{-2, 0}, {2, 2}, {-1, 4}})),
       .remarks = {{At::end, 3,
                    "were P added as A, the origin would lie in R2: the crossing test has ended the search before"}}},
      {.name = "r4-cannot-happen",
       .title = "the origin cannot lie in R4",
       .summary = "R4 lies beyond B, next to R3: only the move that left BC tells them apart",
       .text = "R4: beyond B; skipped, because the search had ruled it out when it kept BC",
       .scene = in_the_plane(polygon("quadrilateral", {{-1, -2}, {1, 0}, {-1, 2}, {-2, -1}}),
                             polygon("triangle", {{-1, -3}, {-4, -1}, {-3, -5}})),
       .remarks = {{At::direction_chosen, 2, "it leaves behind what will be R4, R5 and R6"},
                   {At::region_tested, 3, "ABn·AO > 0 holds in R4 too, but the search left BC on the other side",
                    "R3"}}},
      {.name = "r5-cannot-happen",
       .title = "the origin cannot lie in R5",
       .summary = "R5 lies beyond BC, which the search has just left on the other side",
       .text = "R5: beyond BC; skipped, because the search left BC toward the origin",
       .scene = in_the_plane(polygon("triangle", {{-1, 2}, {-3, -2}, {0, -2}}),
                             polygon("quadrilateral", {{-3, 0}, {-1, -1}, {2, 3}, {0, 3}})),
       .remarks = {{At::direction_chosen, 2, "it leaves behind what will be R4, R5 and R6"},
                   {At::region_tested, 3,
                    "the same three results would come from R5, but the search left BC on the other "
                    "side",
                    "R1"}}},
      {.name = "r6-cannot-happen",
       .title = "the origin cannot lie in R6",
       .summary = "R6 lies beyond C, next to R7: only the move that left BC tells them apart",
       .text = "R6: beyond C; skipped, because the search had ruled it out when it kept BC",
       .scene = in_the_plane(polygon("quadrilateral", {{1, -3}, {2, -1}, {-3, 1}, {-3, -2}}),
                             polygon("triangle", {{4, -3}, {3, -1}, {1, -4}})),
       .remarks = {
           {At::direction_chosen, 2, "it leaves behind what will be R4, R5 and R6"},
           {At::region_tested, 3, "ACn·AO > 0 holds in R6 too, but the search left BC on the other side", "R7"}}}};
}

}  // namespace

std::vector<Walkthrough> regions_of_2_simplex() {
  std::vector<RegionRow> rows = beyond_an_edge();
  for (const auto& more : {above_below_within(), boundaries(), impossible()})
    rows.insert(rows.end(), more.begin(), more.end());
  return region_walkthroughs(2, std::move(rows));
}

}  // namespace walkthroughs
