// Rules that are not the report's as its text means them: the complete rules, Algorithm 1 as printed, and eager ones.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/cycles.hpp"

namespace walkthroughs::catalogue {
namespace {

Scene by_rules(RuleSet rules, const std::string& name, Scene scene) {
  scene.name = name;
  scene.rules = rules;
  return scene;
}

// -- The pairs on which the report's rules go round for ever, asked by the complete rules ------------------------------

constexpr const char* nothing_skipped = "ARL-TR-7474, Section 3.2, nothing skipped";

Walkthrough by_complete_rules(const Scene& scene, const std::string& title, const std::string& summary) {
  return {.name = scene.name,
          .title = title,
          .source = nothing_skipped,
          .summary = summary,
          .naming = Naming::roles,
          .scenes = {by_rules(RuleSet::complete, scene.name, scene)},
          .remarks = {{Remark::At::end,
                       7,
                       "the report's rules never find this out",
                       {},
                       "each simplex was nearer to the origin than the one before, so none could come back"}}};
}

Walkthrough complete_beside_the_report() {
  return {.name = "complete/beside-the-report",
          .title = "The report's rules go round, the complete rules end",
          .source = nothing_skipped,
          .summary = "what the report's history saves, and what it costs: one pair, both sets of rules",
          .layout = Layout::in_step,
          .naming = Naming::fixed,
          .scenes = {cycling_apart("as intended"), by_rules(RuleSet::complete, "complete", cycling_apart("complete"))}};
}

// -- Two searches that part --------------------------------------------------------------------------------------------

/// Algorithm 1 goes on to process the simplex after it has found P·dir < 0, and what it finds there may overwrite the
/// answer. Two unit balls ten apart are enough: the search finds the same point twice.
Walkthrough as_printed_spheres() {
  const Scene scene{.name = "as intended",
                    .a = {"disk a", Ball{{0, 0, 0}, 1}},
                    .b = {"disk b", Ball{{10, 0, 0}, 1}},
                    .rules = RuleSet::as_intended};
  return {
      .name = "as-printed-spheres",
      .title = "Algorithm 1 as printed, and as its text means it",
      .source = "ARL-TR-7474, Section 3.1.4",
      .summary = "two spheres far apart: read literally, Algorithm 1 finds a collision",
      .layout = Layout::until_they_part,
      .naming = Naming::roles,
      .scenes = {by_rules(RuleSet::as_printed, "as printed", scene), scene},
      .remarks = {{Remark::At::region_tested, 2,
                   "wrongly: A and B are the same point, so every product with AB is zero, wherever the origin is"}}};
}

/// From one center to the other is a direction that separates most objects that are apart. Rules that test the first point,
/// too, need no second one then.
Walkthrough eager_between_centers() {
  const Scene scene =
      from_center_to_center({.name = "as intended",
                             .a = {"triangle", points({{-3, -1, 0}, {0, -2, 0}, {0, 0, 0}})},
                             .b = {"quadrilateral", points({{2, 1, 0}, {4, 0, 0}, {5, 2, 0}, {3, 3, 0}})},
                             .rules = RuleSet::as_intended});
  return {.name = "eager-between-centers",
          .title = "The first point tested, too, and as the report has it",
          .source = "ARL-TR-7474, Section 3.1.3, varied",
          .summary = "two objects apart: from center to center, the first point may be proof enough",
          .layout = Layout::until_they_part,
          .naming = Naming::roles,
          .scenes = {by_rules(RuleSet::eager, "eager", scene), scene},
          .remarks = {{Remark::At::crossing_tested, 1,
                       "d leads from the center of the triangle to that of the quadrilateral, which separates most "
                       "objects that are apart"},
                      {Remark::At::end, 2, "the same answer, one move later"}}};
}

}  // namespace

std::vector<Walkthrough> other_rules() {
  return {by_complete_rules(cycling_apart("complete/cycle-separated"), "Every region asked, and the circle is broken",
                            "the pair of cycle-separated, by rules that keep the feature nearest to the origin"),
          by_complete_rules(cycling_together("complete/cycle-intersecting"),
                            "Together, found where the report's rules go round",
                            "the pair of cycle-intersecting, by rules that keep the feature nearest to the origin"),
          complete_beside_the_report(), as_printed_spheres(), eager_between_centers()};
}

}  // namespace walkthroughs::catalogue
