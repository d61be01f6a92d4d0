// Searches by the report's rules that go round for ever; and rules that are not the report's as its text means them: the complete
// rules, Algorithm 1 as printed, and eager ones.

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::catalogue {
namespace {

Scene by_rules(RuleSet rules, const std::string& name, Scene scene) {
  scene.name = name;
  scene.rules = rules;
  return scene;
}

// -- Two pairs of integer points on which the report's rules go round in a circle, in exact arithmetic, too ----------------

Scene cycling_apart(const std::string& name) {
  return scene_of("tetrahedron", {{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}}, "polytope",
                  {{-1, 3, 2}, {0, 10, 4}, {8, 9, 0}}, name);
}

Scene cycling_together(const std::string& name) {
  return scene_of("tetrahedron", {{274, -351, 0}, {95, -20, 0}, {104, 344, 0}, {346, 81, -2}}, "polytope",
                  {{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}}, name);
}

/// The rules take the first edge or face that sees the origin and never look at the others, so what they keep need not be what
/// lies nearest to the origin, and nothing keeps them from coming back.
Walkthrough endless(const Scene& scene, const std::string& title, const std::string& summary,
                    const std::string& ending) {
  return search_of(
      scene.name, title, "Algorithm 5", summary, scene,
      {{Remark::At::end,
        9,
        ending,
        {},
        "Algorithms 4 and 5 take the first edge or face that sees the origin, not the nearest. Of a million random "
        "pairs of triangles 4 go round. The complete rules end, but where numbers round. A certified answer always "
        "does"}});
}

constexpr const char* nothing_skipped = "Section 3.2, every region of A";

Walkthrough by_complete_rules(const Scene& scene, const std::string& title, const std::string& summary) {
  return search_of(scene.name, title, nothing_skipped, summary, by_rules(RuleSet::complete, scene.name, scene),
                   {{Remark::At::end,
                     7,
                     "the report's rules never find this out",
                     {},
                     "each simplex was nearer to the origin than the one before, so none could come back"}});
}

Walkthrough complete_beside_the_report() {
  Walkthrough both = search_of(
      "complete/beside-the-report", "The report's rules go round, the complete rules end", nothing_skipped,
      "what the report's history saves, and what it costs: one pair, both sets of rules", cycling_apart("the report"));
  both.scenes.push_back(by_rules(RuleSet::complete, "complete", both.scenes[0]));
  both.layout = Layout::in_step;
  both.naming = Naming::fixed;
  return both;
}

// -- Two searches that part --------------------------------------------------------------------------------------------

/// Algorithm 1 goes on to process the simplex after it has found P·dir < 0, and what it finds there may overwrite the
/// answer. Two unit balls ten apart are enough: the search finds the same point twice.
Walkthrough as_printed_spheres() {
  const Scene scene{.name = "as meant", .a = {"disk a", Ball{{0, 0, 0}, 1}}, .b = {"disk b", Ball{{10, 0, 0}, 1}}};
  return until_they_part(
      by_rules(RuleSet::as_printed, "as printed", scene),
      search_of(
          "as-printed-spheres", "Algorithm 1 as printed, and as its text means it", "Section 3.1.4",
          "two spheres far apart: read literally, Algorithm 1 finds a collision", scene,
          {{.at = Remark::At::region_tested,
            .iteration = 2,
            .text = "wrongly: A and B are the same point, so every product with AB is zero, wherever the origin is",
            .contradicts = true}}));
}

/// From one center to the other is a direction that separates most objects that are apart. Rules that test the first point,
/// too, need no second one then.
Walkthrough eager_between_centers() {
  const Scene scene = from_center_to_center(scene_of("triangle", {{-3, -1}, {0, -2}, {0, 0}}, "quadrilateral",
                                                     {{2, 1}, {4, 0}, {5, 2}, {3, 3}}, "the report"));
  return until_they_part(
      by_rules(RuleSet::eager, "eager", scene),
      search_of("eager-between-centers", "The first point tested, too, and as the report has it",
                "Section 3.1.3, varied",
                "two objects apart: from center to center, the first point may be proof enough", scene,
                {{Remark::At::crossing_tested, 1,
                  "d leads from the center of the triangle to that of the quadrilateral, which separates most "
                  "objects that are apart"},
                 {Remark::At::end, 2, "the same answer, one move later"}}));
}

}  // namespace

std::vector<Walkthrough> other_rules() {
  return {endless(cycling_apart("cycle-separated"), "Apart, and the search goes round in a circle",
                  "a pair that does not intersect, on which the search never ends by itself",
                  "without a limit Algorithm 1 would not end"),
          endless(cycling_together("cycle-intersecting"), "Together, and the search goes round in a circle",
                  "a pair that does intersect, which the report's limit would answer with \"no collision\"",
                  "at its limit Algorithm 1 answers \"no collision\""),
          by_complete_rules(cycling_apart("complete/cycle-separated"), "Every region of A asked: the cycle is broken",
                            "the pair of cycle-separated, by rules that keep the feature nearest to the origin"),
          by_complete_rules(cycling_together("complete/cycle-intersecting"),
                            "Together, found where the report's rules go round",
                            "the pair of cycle-intersecting, by rules that keep the feature nearest to the origin"),
          complete_beside_the_report(),
          as_printed_spheres(),
          eager_between_centers()};
}

}  // namespace walkthroughs::catalogue
