// The pairs on which the report's rules go round for ever, asked by the complete rules.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/cycles.hpp"

namespace walkthroughs {
namespace {

constexpr const char* source = "ARL-TR-7474, Section 3.2, nothing skipped";

Scene by_complete_rules(Scene scene) {
  scene.rules = RuleSet::complete;
  return scene;
}

Walkthrough about(const Scene& scene, const std::string& title, const std::string& summary) {
  return {.name = scene.name,
          .title = title,
          .source = source,
          .summary = summary,
          .naming = Naming::roles,
          .scenes = {by_complete_rules(scene)},
          .remarks = {{Remark::At::end,
                       7,
                       "the report's rules never find this out",
                       {},
                       "each simplex was nearer to the origin than the one before, so none could come back"}}};
}

Walkthrough beside_the_report() {
  return {.name = "complete/beside-the-report",
          .title = "The report's rules go round, the complete rules end",
          .source = source,
          .summary = "what the report's history saves, and what it costs: one pair, both sets of rules",
          .layout = Layout::in_step,
          .naming = Naming::fixed,
          .scenes = {cycling_apart("as intended"), by_complete_rules(cycling_apart("complete"))}};
}

}  // namespace

std::vector<Walkthrough> complete_rules() {
  return {about(cycling_apart("complete/cycle-separated"), "Every region asked, and the circle is broken",
                "the pair of cycle-separated, by rules that keep the feature nearest to the origin"),
          about(cycling_together("complete/cycle-intersecting"), "Together, found where the report's rules go round",
                "the pair of cycle-intersecting, by rules that keep the feature nearest to the origin"),
          beside_the_report()};
}

}  // namespace walkthroughs
