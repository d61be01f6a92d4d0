// The report's rules take the first edge or face that sees the origin and never look at the others, so what they keep need
// not be what lies nearest to the origin, and nothing keeps them from coming back.

#include "walkthroughs/catalogue/cycles.hpp"

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::catalogue {
namespace {

constexpr const char* why_how_often_and_what_helps =
    "Algorithms 4 and 5 take the first edge or face that sees the origin, not the nearest: nothing keeps the search "
    "from coming back. Of a million random pairs of triangles 4 go round. Another first direction may help. The "
    "complete rules end, but where numbers round. A certified answer always does";

Walkthrough about(const Scene& scene, const std::string& title, const std::string& summary, const std::string& ending) {
  return {.name = scene.name,
          .title = title,
          .source = "ARL-TR-7474, Algorithm 5",
          .summary = summary,
          .naming = Naming::roles,
          .scenes = {scene},
          .remarks = {{Remark::At::end, 9, ending, {}, why_how_often_and_what_helps}}};
}

}  // namespace

Scene cycling_apart(const std::string& name) {
  return {.name = name,
          .a = {"tetrahedron", points({{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}})},
          .b = {"polytope", points({{-1, 3, 2}, {0, 10, 4}, {8, 9, 0}})},
          .dimension = Dimension::space};
}

Scene cycling_together(const std::string& name) {
  return {.name = name,
          .a = {"tetrahedron", points({{274, -351, 0}, {95, -20, 0}, {104, 344, 0}, {346, 81, -2}})},
          .b = {"polytope", points({{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}})},
          .dimension = Dimension::space};
}

std::vector<Walkthrough> endless_searches() {
  return {about(cycling_apart("cycle-separated"), "Apart, and the search goes round in a circle",
                "a pair that does not intersect, on which the search never ends by itself",
                "these objects do not intersect, which it would never find out"),
          about(cycling_together("cycle-intersecting"), "Together, and the search goes round in a circle",
                "a pair that does intersect, which the report's limit would answer with \"no collision\"",
                "at its limit Algorithm 1 answers \"no collision\", but these objects do intersect")};
}

}  // namespace walkthroughs::catalogue
