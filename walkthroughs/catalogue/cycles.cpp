// Two pairs of integer points on which Algorithm 5 goes round in a circle, in exact arithmetic too: it takes the first
// face that sees the origin and never looks at the others, so what it keeps need not be what lies closest to the origin.

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs {
namespace {

Walkthrough about(const std::string& name, const std::string& title, const std::string& summary, Points a, Points b,
                  const std::string& ending) {
  return {.name = name,
          .title = title,
          .source = "ARL-TR-7474, Algorithm 5",
          .summary = summary,
          .naming = Naming::roles,
          .scenes = {{.name = name,
                      .a = {"tetrahedron", std::move(a)},
                      .b = {"polytope", std::move(b)},
                      .dimension = Dimension::space}},
          .remarks = {{Remark::At::end,
                       9,
                       ending,
                       {},
                       "Algorithm 5 takes the first face that sees the origin, not the nearest: nothing keeps it from "
                       "coming back"}}};
}

}  // namespace

Walkthrough cycle_separated() {
  return about("cycle-separated", "Apart, and the search goes round in a circle",
               "a pair that does not intersect, on which the search never ends by itself",
               points({{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}}), points({{-1, 3, 2}, {0, 10, 4}, {8, 9, 0}}),
               "these objects do not intersect, which it would never find out");
}

Walkthrough cycle_intersecting() {
  return about("cycle-intersecting", "Together, and the search goes round in a circle",
               "a pair that does intersect, which the report's limit would answer with \"no collision\"",
               points({{274, -351, 0}, {95, -20, 0}, {104, 344, 0}, {346, 81, -2}}),
               points({{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}}),
               "at its limit Algorithm 1 answers \"no collision\", but these objects do intersect");
}

}  // namespace walkthroughs
