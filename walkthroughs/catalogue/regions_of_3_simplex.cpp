// ABC, ACD and ADB stand for faces, and "the ACn of ABC" for the normal of the edge AC in the plane of the face ABC.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/region_walkthrough.hpp"

namespace walkthroughs {
namespace {

using At = Remark::At;

std::vector<RegionRow> face_abc() {
  return {{.name = "face-abc",
           .title = "the origin lies above ABC",
           .summary = "the first face sees the origin and is kept: D is dropped",
           .text = "the origin lies above the face ABC",
           .scene = in_space(polyhedron("tetrahedron", {{-1, 0, -1}, {3, 4, -1}, {2, -2, -2}, {1, 0, 3}}),
                             polyhedron("triangle", {{-2, -3, -1}, {2, -1, -2}, {1, -2, 2}})),
           .remarks = {{At::region_tested, 4,
                        "the first face that sees the origin is taken, and no other face is looked at", "ABC"},
                       {At::direction_chosen, 4, "d is the normal with which the face was tested"}}},
          {.name = "face-abc-edge-ac",
           .title = "the origin lies above ABC, beyond AC",
           .summary = "of the face ABC only the edge AC is kept: B and D are dropped",
           .text = "the origin lies above the face ABC and beyond its edge AC",
           .scene = in_space(polyhedron("tetrahedron", {{2, 3, 2}, {-2, -3, 0}, {-1, -3, 4}, {-2, 3, 1}}),
                             polyhedron("triangle", {{-1, 0, -1}, {-3, 3, 0}, {1, 2, -3}})),
           .remarks = {{At::region_tested, 4, "ACn = ABCn×AC lies in the plane of ABC and points out of it across AC",
                        "ABC AC"},
                       {At::direction_chosen, 4, "d is found as in R7 of a triangle"}}},
          {.name = "face-abc-edge-ab",
           .title = "the origin lies above ABC, beyond AB",
           .summary = "of the face ABC only the edge AB is kept: C and D are dropped",
           .text = "the origin lies above the face ABC and beyond its edge AB",
           .scene = in_space(polyhedron("triangle a", {{-2, 2, -1}, {-1, 1, -5}, {2, 2, 0}}),
                             polyhedron("triangle b", {{-1, 0, -3}, {-3, 1, 1}, {1, -2, 4}})),
           .remarks = {{At::region_tested, 4, "ABn = AB×ABCn lies in the plane of ABC and points out of it across AB",
                        "ABC AB"},
                       {At::direction_chosen, 4, "the same as in R3 of a triangle"}}}};
}

std::vector<RegionRow> face_acd() {
  return {{.name = "face-acd",
           .title = "the origin lies above ACD",
           .summary = "ABC does not see the origin, ACD does and is kept: B is dropped",
           .text = "the origin lies above the face ACD",
           .scene = in_space(polyhedron("triangle a", {{0, 3, -2}, {3, -2, -1}, {-1, -1, -2}}),
                             polyhedron("triangle b", {{2, 2, 0}, {0, -1, -1}, {2, 0, 3}})),
           .remarks = {{At::region_tested, 4, "ACDn = AC×AD: in the other order it would point into the tetrahedron",
                        "ACD"},
                       {At::reduced, 4, "in the next simplex this A will be B, while C and D keep their letters"}}},
          {.name = "face-acd-edge-ad",
           .title = "the origin lies above ACD, beyond AD",
           .summary = "of the face ACD only the edge AD is kept: B and C are dropped",
           .text = "the origin lies above the face ACD and beyond its edge AD",
           .scene = in_space(polyhedron("tetrahedron a", {{-2, -5, 4}, {2, 1, 0}, {-5, 0, -2}, {-1, 0, -3}}),
                             polyhedron("tetrahedron b", {{3, -3, 4}, {4, 3, 5}, {-1, 1, 2}, {1, 4, 1}})),
           .remarks = {{At::region_tested, 4, "ADn = ACDn×AD lies in the plane of ACD and points out of it across AD",
                        "ACD AD"}}},
          {.name = "face-acd-edge-ac",
           .title = "the origin lies above ACD, beyond AC",
           .summary = "of the face ACD only the edge AC is kept: B and D are dropped",
           .text = "the origin lies above the face ACD and beyond its edge AC",
           .scene = in_space(polyhedron("triangle a", {{2, 4, -4}, {0, -1, -1}, {3, -1, -3}}),
                             polyhedron("triangle b", {{1, 2, 3}, {2, 2, -2}, {4, 0, 4}})),
           .remarks = {{At::region_tested, 4, "this ACn = AC×ACDn belongs to ACD: the ACn of ABC is another vector",
                        "ACD AC"}}}};
}

std::vector<RegionRow> face_adb() {
  return {{.name = "face-adb",
           .title = "the origin lies above ADB",
           .summary = "only the last face sees the origin and is kept: C is dropped, B becomes the oldest",
           .text = "the origin lies above the face ADB",
           .scene = in_space(polyhedron("triangle", {{0, 0, -4}, {3, 0, 1}, {0, -4, 0}}),
                             polyhedron("tetrahedron", {{0, 2, -3}, {1, -1, 2}, {-1, 3, 3}, {-2, -3, -1}})),
           .remarks = {{At::region_tested, 4, "ADBn = AD×AB: in the other order it would point into the tetrahedron",
                        "ADB"},
                       {At::reduced, 4, "in the order [D, B, A] BC×BD would point away from the next A"}}},
          {.name = "face-adb-edge-ab",
           .title = "the origin lies above ADB, beyond AB",
           .summary = "of the face ADB only the edge AB is kept: C and D are dropped",
           .text = "the origin lies above the face ADB and beyond its edge AB",
           .scene = in_space(polyhedron("triangle a", {{3, 3, 3}, {4, 3, -3}, {0, 3, -4}}),
                             polyhedron("triangle b", {{1, 2, 5}, {4, 4, 5}, {3, 1, 2}})),
           .remarks = {{At::region_tested, 4, "this ABn = ADBn×AB belongs to ADB: the ABn of ABC is another vector",
                        "ADB AB"}}},
          {.name = "face-adb-edge-ad",
           .title = "the origin lies above ADB, beyond AD",
           .summary = "of the face ADB only the edge AD is kept: B and C are dropped",
           .text = "the origin lies above the face ADB and beyond its edge AD",
           .scene = in_space(polyhedron("triangle a", {{-4, 3, -2}, {-5, -3, -3}, {0, 1, 3}}),
                             polyhedron("triangle b", {{-4, 1, 3}, {-2, 0, 4}, {2, 2, 4}})),
           .remarks = {{At::region_tested, 4, "this ADn = AD×ADBn belongs to ADB: the ADn of ACD is another vector",
                        "ADB AD"}}}};
}

std::vector<RegionRow> inside_and_boundaries() {
  return {{.name = "inside",
           .title = "the origin lies inside",
           .summary = "none of the three faces that meet A sees the origin: the objects intersect",
           .text = "the origin lies in the tetrahedron",
           .scene = in_space(polyhedron("triangle a", {{0, 0, 2}, {2, -1, -2}, {-1, -2, -1}}),
                             polyhedron("triangle b", {{1, -2, 0}, {0, 1, -3}, {3, 1, -1}})),
           .remarks = {{At::region_tested, 4, "ABC, ACD and ADB do not see it, and BCD has been left behind", "ABCD"}}},
          {.name = "on-face",
           .title = "the origin lies on a face",
           .summary = "the normal of the face ACD gives zero, which is not above: the objects intersect",
           .text = "the origin lies on the face ACD",
           .scene = in_space(
               polyhedron("octahedron", {{2, 1, 0}, {-2, -1, 0}, {-1, 2, 0}, {1, -2, 0}, {0, 0, 2}, {0, 0, -2}}),
               polyhedron("pyramid", {{0, 1, 0}, {-1, 3, 2}, {0, 1, 4}, {1, -1, 2}, {4, 3, 2}})),
           .remarks = {{At::region_tested, 4, "ACDn·AO = 0: the origin lies in the plane of ACD, not above it", "ACD"},
                       {At::region_tested, 4,
                        "a face belongs to the tetrahedron, so this case needs no test of its own", "ABCD"}}},
          {.name = "in-plane-of-face",
           .title = "the origin lies in the plane of a face, but not on the face",
           .summary = "the normal of ABC gives zero, but another face sees the origin",
           .text = "the origin lies in the plane of ABC, outside the triangle",
           .scene = in_space(polyhedron("triangle a", {{-4, 1, 3}, {0, 0, -3}, {3, 3, 2}}),
                             polyhedron("triangle b", {{0, 0, 1}, {5, -2, 3}, {2, -1, -3}})),
           .remarks = {{At::region_tested, 4,
                        "ABCn·AO = 0: the origin lies in the plane of ABC, but outside the triangle", "ABC"},
                       {At::region_tested, 4, "another face sees the origin, so the zero for ABC did not mean contact",
                        "ACD"}}},
          {.name = "a-is-origin",
           .title = "A is the origin",
           .summary = "every product with AO is zero: no face sees the origin, the objects touch at one point",
           .text = "A is the origin",
           .scene = in_space(polyhedron("triangle", {{-2, 0, 2}, {-3, 0, -2}, {1, -3, 1}}),
                             polyhedron("tetrahedron", {{-1, 3, 2}, {-2, 0, 2}, {1, 2, 0}, {-1, 2, -2}})),
           .remarks = {{At::region_tested, 4, "AO = 0 makes all three products zero, which is not above", "ABCD"},
                       {At::end, 4, "they touch at one point, (−2, 0, 2), and touching counts as intersecting"}}}};
}

std::vector<RegionRow> impossible() {
  return {{.name = "skipped-features",
           .title = "eight features need no test",
           .summary = "B, C, D, BC, CD, DB and BCD are left behind, A is ruled out by the crossing test",
           .text = "B, C, D, BC, CD, DB, BCD and A; skipped, because the search left BCD and crossed the origin",
           .scene = in_space(polyhedron("triangle", {{1, 1, 1}, {-1, -3, 2}, {-1, -2, -2}}),
                             polyhedron("tetrahedron", {{0, 3, -1}, {0, -2, 0}, {2, 3, 2}, {-2, 2, 2}})),
           .remarks = {{At::direction_chosen, 3, "it leaves the whole triangle behind, with its corners and edges"},
                       {At::region_tested, 4, "seven features of BCD and the corner A are not even looked at", "ABC"},
                       {At::region_tested, 4,
                        "the same results would come from beyond BCD, but the search left BCD on the "
                        "other side",
                        "ABCD"}}}};
}

}  // namespace

std::vector<Walkthrough> regions_of_3_simplex() {
  std::vector<RegionRow> rows = face_abc();
  for (const auto& more : {face_acd(), face_adb(), inside_and_boundaries(), impossible()})
    rows.insert(rows.end(), more.begin(), more.end());
  return region_walkthroughs(3, std::move(rows));
}

}  // namespace walkthroughs
