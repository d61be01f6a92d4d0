#include "walkthroughs/steps/parting.hpp"

#include <algorithm>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/steps/differences.hpp"
#include "walkthroughs/steps/told_trace.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace walkthroughs::steps {
namespace {

const std::string own_name = "yours";

bool is_planar(const ToldRun& run) {
  const auto flat = [](const Points& points) {
    return std::ranges::all_of(points, [](const Vec& p) { return p[2] == 0; });
  };
  return flat(run.pair.a) && flat(run.pair.b) && run.steps.front().direction[2] == 0;
}

/// Returns: the simplex at the end of an iteration of a trace.
Vertices simplex_after(const Trace& trace, int iteration) {
  Vertices vertices;
  const auto take = [&](const gjk::Simplex<double>& simplex) {
    vertices.clear();
    for (int i = 0; i < simplex.size(); ++i) vertices.push_back(simplex[i].w);
  };
  for (const auto& event : trace.events) {
    if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&event); e && e->iteration == iteration) take(e->simplex);
    if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event); e && e->iteration == iteration)
      take(e->after);
  }
  return vertices;
}

/// Whether both have the same vertices then, in any order.
bool goes_there(const Trace& trace, const ToldRun& run, int iteration) {
  const Differences differences(run.pair.a, run.pair.b);
  const Vertices there = simplex_after(trace, iteration);
  const Vertices& told = run.steps[static_cast<std::size_t>(iteration) - 1].simplex;
  return there.size() == told.size() &&
         std::ranges::all_of(told, [&](const Vec& v) { return differences.has(there, v); });
}

/// Of the report's algorithm, begun as the program has.
Scene scene_of(const ToldRun& run) {
  return {.name = "the report",
          .a = {"point set a", run.pair.a},
          .b = {"point set b", run.pair.b},
          .options = {.first_direction = run.steps.front().direction},
          .dimension = is_planar(run) ? Dimension::plane : Dimension::space};
}

}  // namespace

Story Parting::story() const {
  Story story = tell(walkthrough, traces);
  std::erase_if(story.frames, [this](const auto& frame) { return frame.moments.front().iteration > iteration + 1; });
  if (words.empty()) return story;
  for (Frame& frame : story.frames) {
    if (frame.focus == Focus::parting) frame.caption = frame.headline = "Here the two runs part: " + words + ".";
    for (Fact& fact : frame.facts)
      if (fact.text.starts_with(own_name + ": "))  // what comes of a wrong step may be true again
        fact.mark = frame.focus == Focus::parting ? Fact::Mark::no : Fact::Mark::none;
  }
  return story;
}

std::optional<Parting> parting_of(const ToldRun& told, const StepFinding& finding) {
  ToldRun run = told;
  run.steps.erase(std::ranges::find_if_not(run.steps, &ToldStep::is_of_numbers), run.steps.end());
  if (finding.iteration > static_cast<int>(run.steps.size())) return std::nullopt;
  const Scene right = scene_of(run);
  for (const std::size_t m : finding.mistakes) {
    Walkthrough walkthrough = beside_the_report(static_cast<wrong_on_purpose::Mistake>(m), right);
    std::vector<Trace> traces{model::run(walkthrough.scenes[0]), model::run(walkthrough.scenes[1])};
    walkthrough.name = parting_name;
    if (goes_there(traces[0], run, finding.iteration))
      return Parting{std::move(walkthrough), std::move(traces), finding.iteration};
  }
  Scene own = right;
  own.name = own_name;
  return Parting{{.name = parting_name,
                  .title = "Your steps, and the report's algorithm",
                  .source = "ARL-TR-7474, Section 3",
                  .summary = "the first step that the report's algorithm would not make",
                  .layout = Layout::until_they_part,
                  .naming = Naming::roles,
                  .scenes = {std::move(own), right}},
                 {told_trace(run), rightly_from(run, finding.iteration)},
                 finding.iteration,
                 finding.words};
}

}  // namespace walkthroughs::steps
