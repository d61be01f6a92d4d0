// The walkthroughs regions/…: each shows one case of Section 3.2, reached by a real search on two real objects.

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::catalogue {
namespace {

using At = Remark::At;

/// One row of the catalogue.
struct RegionRow {
  std::string name;   ///< "r3"; the walkthrough is "regions/2-simplex-r3"
  std::string title;  ///< "case R3"; headed by "2-simplex: "
  std::string summary;
  std::string text;  ///< of the RegionCase
  Scene scene;
  std::vector<Remark> remarks;  ///< in the letters of the simplex that is being processed
};

// -- A vertex ---------------------------------------------------------------------------------------------------------

std::vector<RegionRow> at_vertex() {
  return {
      {.name = "elsewhere",
       .title = "case elsewhere",
       .summary = "a point has no regions: the search goes from A back toward the origin",
       .text = "A is not the origin: the origin lies elsewhere",
       .scene = scene_of("quadrilateral", {{1, 1}, {0, 3}, {-2, 1}, {-1, 0}}, "triangle", {{0, -1}, {1, -4}, {3, -3}}),
       .remarks = {{At::region_tested, 1, "points have no sides to test, so the only way to go is back along AO", "A"},
                   {At::direction_chosen, 1,
                    "only this search starts from a point, all later ones start from an edge or a face"}}},
      {.name = "a-is-origin",
       .title = "case at A",
       .summary = "the first point found is the origin: the objects touch at one point",
       .text = "A is the origin",
       .scene = scene_of("square", {{-2, 0}, {-1, -2}, {1, -1}, {0, 1}}, "triangle", {{1, -1}, {3, 0}, {2, 2}}),
       .remarks = {{At::region_tested, 1, "the direction AO = 0 could not be searched, so this is tested first", "A"},
                   {At::end, 1, "they touch at one point, (1, −1), and touching counts as intersecting"}}}};
}

// -- A segment -----------------------------------------------------------------------------------------------------------

// Figure 6 names the sides of AB, Algorithm 3 treats them alike ("R3 or R4"). Here R3 is the left side of the move from B to
// A and R4 the right side, so that R3 of the segment AB is on the same side as R3 of the triangle ABC in Figure 7.

std::vector<RegionRow> beside_segment() {
  return {
      {.name = "r3",
       .title = "case R3",
       .summary = "the origin lies to the left of the move from B to A",
       .text = "R3: the origin lies to the left of the move from B to A",
       .scene = scene_of("triangle a", {{-2, 3}, {-3, 1}, {0, 0}}, "triangle b", {{-1, -2}, {2, -2}, {0, 1}}),
       .remarks = {{At::region_tested, 2, "it lies to the left of the move from B to A, in R3", "R3 or R4"},
                   {At::direction_chosen, 2, "(AB×AO)×AB is perpendicular to AB and points to the origin's side"}}},
      {.name = "r4",
       .title = "case R4",
       .summary = "the origin lies to the right of the move from B to A: the same expression as for R3",
       .text = "R4: the origin lies to the right of the move from B to A",
       .scene = scene_of("quadrilateral", {{0, -3}, {1, -1}, {-2, 0}, {-2, -2}}, "triangle", {{1, 0}, {3, 1}, {0, 3}}),
       .remarks = {{At::region_tested, 2, "it lies to the right of the move from B to A, in R4", "R3 or R4"},
                   {At::direction_chosen, 2, "(AB×AO)×AB serves R3 and R4 alike, while AO might lead back to B"}}}};
}

std::vector<RegionRow> on_segment() {
  return {
      {.name = "on-segment",
       .title = "case on AB",
       .summary = "AB and AO are parallel, (AB×AO)×AB is zero: the objects intersect",
       .text = "the origin lies on the segment AB",
       .scene = scene_of("parallelogram", {{-2, -1}, {-1, -3}, {0, 0}, {-1, 2}}, "triangle", {{0, 1}, {1, 3}, {-2, 2}}),
       .remarks = {{At::region_tested, 2, "AB and AO are parallel, so AB×AO = 0 and no direction is left to search",
                    "AB"},
                   {At::end, 2, "the zero vector is no direction to search along, hence the test for zero"}}},
      {.name = "a-is-origin",
       .title = "case at A",
       .summary = "AO is zero, and with it (AB×AO)×AB: the objects touch at one point",
       .text = "A is the origin",
       .scene = scene_of("parallelogram", {{-1, -2}, {0, -1}, {-1, 1}, {-2, 0}}, "triangle", {{-1, 1}, {2, 3}, {0, 4}}),
       .remarks = {
           {At::region_tested, 2, "A is the origin: AO = 0, and the test for the segment covers this case too", "AB"},
           {At::end, 2, "they touch at one point, (−1, 1), and touching counts as intersecting"}}}};
}

std::vector<RegionRow> skipped_around_segment() {
  return {
      {.name = "r1-cannot-happen",
       .title = "why the origin is not in R1",
       .summary = "R1 lies beyond B, and the search has just left B toward the origin",
       .text = "R1: beyond B; skipped, because the search left B toward the origin",
       .scene = scene_of("quadrilateral", {{-1, -3}, {1, -1}, {0, 2}, {-3, -1}}, "triangle", {{1, 3}, {0, 1}, {3, 2}}),
       .remarks = {{At::direction_chosen, 1, "the search turns its back on what will be R1, beyond B"},
                   {At::region_tested, 2,
                    "this test would not notice R1, but the move from B to A went along BO, away from R1",
                    "R3 or R4"}}},
      {.name = "r2-cannot-happen",
       .title = "why the origin is not in R2",
       .summary = "R2 lies beyond A: where the origin lies there, the crossing test has ended the search",
       .text = "R2: beyond A; skipped, because the move to A crossed the origin",
       .scene = scene_of("triangle", {{1, 2}, {-1, 2}, {0, -1}}, "rhombus", {{-3, -2}, {-1, -3}, {-2, -1}, {-4, 0}}),
       .remarks = {{At::end, 2,
                    "were P added as A, the origin would lie in R2: the crossing test has ended the search before"}}}};
}

// -- A triangle ----------------------------------------------------------------------------------------------------------

std::vector<RegionRow> beyond_edges_of_triangle() {
  return {
      {.name = "r3",
       .title = "case R3",
       .summary = "the origin lies beyond AB: C is dropped",
       .text = "R3: the origin lies beyond AB",
       .scene = scene_of("quadrilateral", {{1, 2}, {-1, 3}, {-1, 1}, {2, 0}}, "triangle", {{0, -1}, {-1, 2}, {-2, -1}}),
       .remarks =
           {{At::region_tested, 3, "ABn lies in the plane of the triangle and points out of it across AB", "R3"},
            {At::reduced, 3, "C lies on the far side of AB"},
            {At::direction_chosen, 3,
             "ABn would do in the plane, but not in space, where the origin may lie above or below the triangle"}}},
      {.name = "r7",
       .title = "case R7",
       .summary = "the origin lies beyond AC: B is dropped",
       .text = "R7: the origin lies beyond AC",
       .scene = scene_of("triangle", {{2, 0}, {1, 3}, {-2, 1}}, "parallelogram", {{0, -1}, {2, -4}, {3, -2}, {1, 1}}),
       .remarks = {{At::region_tested, 3, "ACn = ABCn×AC: in the other order it would point into the triangle", "R7"},
                   {At::reduced, 3, "[C, A] is listed oldest first, so A stays the newest"}}}};
}

std::vector<RegionRow> within_triangle() {
  return {
      {.name = "r1-above",
       .title = "case R1, above the triangle",
       .summary = "the origin lies above ABC: nothing is dropped, the search goes along ABCn",
       .text = "R1: the origin lies above the triangle",
       .scene = scene_of("pyramid", {{4, 3, 0}, {1, 4, 0}, {0, 1, 0}, {3, 0, 0}, {2, 2, 4}}, "triangle",
                         {{3, 1, 4}, {2, 1, 1}, {3, -2, 2}}),
       .remarks = {{At::region_tested, 3, "above is the side to which ABCn = AB×AC points", "R1"},
                   {At::direction_chosen, 3,
                    "the order stays [C, B, A], so BC×BD of the next simplex will be ABCn and point to its A"}}},
      {.name = "r1-below",
       .title = "case R1, below the triangle",
       .summary = "the origin lies below ABC: A and B change places, the search goes along −ABCn",
       .text = "R1: the origin lies below the triangle",
       .scene = scene_of("tetrahedron a", {{2, 1, -3}, {3, 1, 0}, {1, 3, 1}, {1, 0, -1}}, "tetrahedron b",
                         {{2, 2, -2}, {2, 0, 1}, {4, -2, -2}, {0, 0, -1}}),
       .remarks =
           {{At::region_tested, 3, "below is the side to which −ABCn points", "R1"},
            {At::reduced, 3,
             "swapping A and B turns the normal round, so BC×BD of the next simplex will be −ABCn and point to its A"},
            {At::region_tested, 4, "without the swap the three normals would now point inward", "ABCD"}}},
      {.name = "r1-in-plane",
       .title = "case R1, in the triangle",
       .summary = "the origin lies in the triangle itself: the objects intersect",
       .text = "R1: the origin lies in the triangle",
       .scene =
           scene_of("kite a", {{0, -1}, {-1, 0}, {-2, -1}, {-1, -3}}, "kite b", {{-1, 2}, {-2, 0}, {-1, -1}, {0, 0}}),
       .remarks = {{At::region_tested, 3, "neither R3 nor R7, which leaves R1: not above, not below", "R1"}}},
      {.name = "on-edge",
       .title = "case on an edge",
       .summary = "the origin lies on AB: the edge tests say no, ABCn·AO is zero, the objects intersect",
       .text = "the origin lies on the edge AB",
       .scene = scene_of("rectangle", {{-2, -1}, {0, 1}, {-1, 2}, {-3, 0}}, "parallelogram",
                         {{-1, 2}, {-2, 4}, {-3, 3}, {-2, 1}}),
       .remarks = {{At::region_tested, 3, "the origin lies on AB, and on the edge is not beyond it", "R3"},
                   {At::region_tested, 3, "an edge belongs to R1, so this case needs no test of its own", "R1"}}},
      {.name = "on-vertex",
       .title = "case at a vertex",
       .summary = "A is the origin: every product with AO is zero, the objects touch at one point",
       .text = "A is the origin",
       .scene = scene_of("triangle", {{-2, 2}, {-3, -1}, {-1, 0}}, "parallelogram", {{1, 3}, {-1, 3}, {-2, 2}, {0, 2}}),
       .remarks = {
           {At::region_tested, 3, "AO = 0 makes all three products zero, which leads to R1 and to the answer", "R1"},
           {At::end, 3, "they touch at one point, (−2, 2), and touching counts as intersecting"}}}};
}

std::vector<RegionRow> skipped_around_triangle() {
  return {
      {.name = "r2-cannot-happen",
       .title = "why the origin is not in R2",
       .summary = "R2 lies beyond A: where the origin lies there, the crossing test has ended the search",
       .text = "R2: beyond A; skipped, because the move to A crossed the origin",
       .scene = scene_of("triangle a", {{-2, -1}, {-2, -3}, {1, -3}}, "triangle b", {{-2, 0}, {2, 2}, {-1, 4}}),
       .remarks = {{At::end, 3,
                    "were P added as A, the origin would lie in R2: the crossing test has ended the search before"}}},
      {.name = "r4-cannot-happen",
       .title = "why the origin is not in R4",
       .summary = "R4 lies beyond B, next to R3: only the move that left BC tells them apart",
       .text = "R4: beyond B; skipped, because the search had ruled it out when it kept BC",
       .scene =
           scene_of("quadrilateral", {{-1, -2}, {1, 0}, {-1, 2}, {-2, -1}}, "triangle", {{-1, -3}, {-4, -1}, {-3, -5}}),
       .remarks = {{At::direction_chosen, 2, "it leaves behind what will be R4, R5 and R6"},
                   {At::region_tested, 3, "ABn·AO > 0 holds in R4 too, but the search left BC on the other side",
                    "R3"}}},
      {.name = "r5-cannot-happen",
       .title = "why the origin is not in R5",
       .summary = "R5 lies beyond BC, which the search has just left on the other side",
       .text = "R5: beyond BC; skipped, because the search left BC toward the origin",
       .scene =
           scene_of("triangle", {{-1, 2}, {-3, -2}, {0, -2}}, "quadrilateral", {{-3, 0}, {-1, -1}, {2, 3}, {0, 3}}),
       .remarks = {{At::direction_chosen, 2, "it leaves behind what will be R4, R5 and R6"},
                   {At::region_tested, 3,
                    "the same three results would come from R5, but the search left BC on the other side", "R1"}}},
      {.name = "r6-cannot-happen",
       .title = "why the origin is not in R6",
       .summary = "R6 lies beyond C, next to R7: only the move that left BC tells them apart",
       .text = "R6: beyond C; skipped, because the search had ruled it out when it kept BC",
       .scene =
           scene_of("quadrilateral", {{1, -3}, {2, -1}, {-3, 1}, {-3, -2}}, "triangle", {{4, -3}, {3, -1}, {1, -4}}),
       .remarks = {
           {At::direction_chosen, 2, "it leaves behind what will be R4, R5 and R6"},
           {At::region_tested, 3, "ACn·AO > 0 holds in R6 too, but the search left BC on the other side", "R7"}}}};
}

// -- A tetrahedron -------------------------------------------------------------------------------------------------------

// ABC, ACD and ADB stand for faces, and "the ACn of ABC" for the normal of the edge AC in the plane of the face ABC.

std::vector<RegionRow> above_ABC() {
  return {{.name = "face-abc",
           .title = "case above ABC",
           .summary = "the first face sees the origin and is kept: D is dropped",
           .text = "the origin lies above the face ABC",
           .scene = scene_of("tetrahedron", {{-1, 0, -1}, {3, 4, -1}, {2, -2, -2}, {1, 0, 3}}, "triangle",
                             {{-2, -3, -1}, {2, -1, -2}, {1, -2, 2}}),
           .remarks = {{At::region_tested, 4,
                        "the first face that sees the origin is taken, and no other face is looked at", "ABC"},
                       {At::direction_chosen, 4, "d is the normal with which the face was tested"}}},
          {.name = "face-abc-edge-ac",
           .title = "case above ABC, beyond AC",
           .summary = "of the face ABC only the edge AC is kept: B and D are dropped",
           .text = "the origin lies above the face ABC and beyond its edge AC",
           .scene = scene_of("tetrahedron", {{2, 3, 2}, {-2, -3, 0}, {-1, -3, 4}, {-2, 3, 1}}, "triangle",
                             {{-1, 0, -1}, {-3, 3, 0}, {1, 2, -3}}),
           .remarks = {{At::region_tested, 4, "ACn = ABCn×AC lies in the plane of ABC and points out of it across AC",
                        "ABC AC"},
                       {At::direction_chosen, 4, "d is found as in R7 of a triangle"}}},
          {.name = "face-abc-edge-ab",
           .title = "case above ABC, beyond AB",
           .summary = "of the face ABC only the edge AB is kept: C and D are dropped",
           .text = "the origin lies above the face ABC and beyond its edge AB",
           .scene = scene_of("triangle a", {{-2, 2, -1}, {-1, 1, -5}, {2, 2, 0}}, "triangle b",
                             {{-1, 0, -3}, {-3, 1, 1}, {1, -2, 4}}),
           .remarks = {{At::region_tested, 4, "ABn = AB×ABCn lies in the plane of ABC and points out of it across AB",
                        "ABC AB"},
                       {At::direction_chosen, 4, "the same as in R3 of a triangle"}}}};
}

std::vector<RegionRow> above_ACD() {
  return {{.name = "face-acd",
           .title = "case above ACD",
           .summary = "ABC does not see the origin, ACD does and is kept: B is dropped",
           .text = "the origin lies above the face ACD",
           .scene = scene_of("triangle a", {{0, 3, -2}, {3, -2, -1}, {-1, -1, -2}}, "triangle b",
                             {{2, 2, 0}, {0, -1, -1}, {2, 0, 3}}),
           .remarks = {{At::region_tested, 4, "ACDn = AC×AD: in the other order it would point into the tetrahedron",
                        "ACD"},
                       {At::reduced, 4, "in the next simplex this A will be B, while C and D keep their letters"}}},
          {.name = "face-acd-edge-ad",
           .title = "case above ACD, beyond AD",
           .summary = "of the face ACD only the edge AD is kept: B and C are dropped",
           .text = "the origin lies above the face ACD and beyond its edge AD",
           .scene = scene_of("tetrahedron a", {{-2, -5, 4}, {2, 1, 0}, {-5, 0, -2}, {-1, 0, -3}}, "tetrahedron b",
                             {{3, -3, 4}, {4, 3, 5}, {-1, 1, 2}, {1, 4, 1}}),
           .remarks = {{At::region_tested, 4, "ADn = ACDn×AD lies in the plane of ACD and points out of it across AD",
                        "ACD AD"}}},
          {.name = "face-acd-edge-ac",
           .title = "case above ACD, beyond AC",
           .summary = "of the face ACD only the edge AC is kept: B and D are dropped",
           .text = "the origin lies above the face ACD and beyond its edge AC",
           .scene = scene_of("triangle a", {{2, 4, -4}, {0, -1, -1}, {3, -1, -3}}, "triangle b",
                             {{1, 2, 3}, {2, 2, -2}, {4, 0, 4}}),
           .remarks = {{At::region_tested, 4,
                        "this ACn = AC×ACDn lies in the plane of ACD, the ACn of ABC in that of ABC", "ACD AC"}}}};
}

std::vector<RegionRow> above_ADB() {
  return {{.name = "face-adb",
           .title = "case above ADB",
           .summary = "only the last face sees the origin and is kept: C is dropped, B becomes the oldest",
           .text = "the origin lies above the face ADB",
           .scene = scene_of("triangle", {{0, 0, -4}, {3, 0, 1}, {0, -4, 0}}, "tetrahedron",
                             {{0, 2, -3}, {1, -1, 2}, {-1, 3, 3}, {-2, -3, -1}}),
           .remarks = {{At::region_tested, 4, "ADBn = AD×AB: in the other order it would point into the tetrahedron",
                        "ADB"},
                       {At::reduced, 4, "in the order [D, B, A] BC×BD would point away from the next A"}}},
          {.name = "face-adb-edge-ab",
           .title = "case above ADB, beyond AB",
           .summary = "of the face ADB only the edge AB is kept: C and D are dropped",
           .text = "the origin lies above the face ADB and beyond its edge AB",
           .scene = scene_of("triangle a", {{3, 3, 3}, {4, 3, -3}, {0, 3, -4}}, "triangle b",
                             {{1, 2, 5}, {4, 4, 5}, {3, 1, 2}}),
           .remarks = {{At::region_tested, 4,
                        "this ABn = ADBn×AB lies in the plane of ADB, the ABn of ABC in that of ABC", "ADB AB"}}},
          {.name = "face-adb-edge-ad",
           .title = "case above ADB, beyond AD",
           .summary = "of the face ADB only the edge AD is kept: B and C are dropped",
           .text = "the origin lies above the face ADB and beyond its edge AD",
           .scene = scene_of("triangle a", {{-4, 3, -2}, {-5, -3, -3}, {0, 1, 3}}, "triangle b",
                             {{-4, 1, 3}, {-2, 0, 4}, {2, 2, 4}}),
           .remarks = {{At::region_tested, 4,
                        "this ADn = AD×ADBn lies in the plane of ADB, the ADn of ACD in that of ACD", "ADB AD"}}}};
}

std::vector<RegionRow> within_tetrahedron() {
  return {{.name = "inside",
           .title = "case inside",
           .summary = "none of the three faces that meet A sees the origin: the objects intersect",
           .text = "the origin lies in the tetrahedron",
           .scene = scene_of("triangle a", {{0, 0, 2}, {2, -1, -2}, {-1, -2, -1}}, "triangle b",
                             {{1, -2, 0}, {0, 1, -3}, {3, 1, -1}}),
           .remarks = {{At::region_tested, 4, "ABC, ACD and ADB do not see it, and BCD has been left behind", "ABCD"}}},
          {.name = "on-face",
           .title = "case on a face",
           .summary = "the normal of the face ACD gives zero, which is not above: the objects intersect",
           .text = "the origin lies on the face ACD",
           .scene = scene_of("octahedron", {{2, 1, 0}, {-2, -1, 0}, {-1, 2, 0}, {1, -2, 0}, {0, 0, 2}, {0, 0, -2}},
                             "pyramid", {{0, 1, 0}, {-1, 3, 2}, {0, 1, 4}, {1, -1, 2}, {4, 3, 2}}),
           .remarks = {{At::region_tested, 4, "the origin lies in the plane of ACD, not above it", "ACD"},
                       {At::region_tested, 4,
                        "its faces belong to the tetrahedron, so this case needs no test of its own", "ABCD"}}},
          {.name = "in-plane-of-face",
           .title = "case in the plane of a face, but not on it",
           .summary = "the normal of ABC gives zero, but another face sees the origin",
           .text = "the origin lies in the plane of ABC, outside the triangle",
           .scene = scene_of("triangle a", {{-4, 1, 3}, {0, 0, -3}, {3, 3, 2}}, "triangle b",
                             {{0, 0, 1}, {5, -2, 3}, {2, -1, -3}}),
           .remarks = {{At::region_tested, 4, "the origin lies in the plane of ABC, but outside the triangle", "ABC"},
                       {At::region_tested, 4, "another face sees the origin, so the zero for ABC did not mean contact",
                        "ACD"}}},
          {.name = "a-is-origin",
           .title = "case at A",
           .summary = "every product with AO is zero: no face sees the origin, the objects touch at one point",
           .text = "A is the origin",
           .scene = scene_of("triangle", {{-2, 0, 2}, {-3, 0, -2}, {1, -3, 1}}, "tetrahedron",
                             {{-1, 3, 2}, {-2, 0, 2}, {1, 2, 0}, {-1, 2, -2}}),
           .remarks = {{At::region_tested, 4, "AO = 0 makes all three products zero, which is not above", "ABCD"},
                       {At::end, 4, "they touch at one point, (−2, 0, 2), and touching counts as intersecting"}}}};
}

std::vector<RegionRow> skipped_around_tetrahedron() {
  return {{.name = "skipped-features",
           .title = "eight features without a test",
           .summary = "B, C, D, BC, CD, DB and BCD are left behind, A is ruled out by the crossing test",
           .text = "B, C, D, BC, CD, DB, BCD and A; skipped, because the search left BCD and crossed the origin",
           .scene = scene_of("triangle", {{1, 1, 1}, {-1, -3, 2}, {-1, -2, -2}}, "tetrahedron",
                             {{0, 3, -1}, {0, -2, 0}, {2, 3, 2}, {-2, 2, 2}}),
           .remarks = {
               {At::direction_chosen, 3, "it leaves the whole triangle behind, with its corners and edges"},
               {At::region_tested, 4, "seven features of BCD and the corner A are not even looked at", "ABC"},
               {At::region_tested, 4,
                "the same results would come from beyond BCD, but the search left BCD on the other side", "ABCD"}}}};
}

// -- All ------------------------------------------------------------------------------------------------------------

/// Section 3.2.1 is about the 0-simplex, Section 3.2.2 about the 1-simplex, and so on.
Walkthrough region_walkthrough(int dimension_of_simplex, const RegionRow& row) {
  const std::string simplex = std::to_string(dimension_of_simplex) + "-simplex";
  const std::string section = "3.2." + std::to_string(dimension_of_simplex + 1);
  Walkthrough walkthrough = search_of("regions/" + simplex + "-" + row.name, simplex + ": " + row.title,
                                      "Section " + section, row.summary, row.scene, row.remarks);
  walkthrough.region_case = {row.text, section};
  return walkthrough;
}

}  // namespace

std::vector<Walkthrough> region_cases() {
  const std::pair<int, std::vector<RegionRow>> tables[] = {{0, at_vertex()},
                                                           {1, beside_segment()},
                                                           {1, on_segment()},
                                                           {1, skipped_around_segment()},
                                                           {2, beyond_edges_of_triangle()},
                                                           {2, within_triangle()},
                                                           {2, skipped_around_triangle()},
                                                           {3, above_ABC()},
                                                           {3, above_ACD()},
                                                           {3, above_ADB()},
                                                           {3, within_tetrahedron()},
                                                           {3, skipped_around_tetrahedron()}};
  std::vector<Walkthrough> all;
  for (const auto& [dimension, rows] : tables)
    for (const RegionRow& row : rows) all.push_back(region_walkthrough(dimension, row));
  return all;
}

}  // namespace walkthroughs::catalogue
