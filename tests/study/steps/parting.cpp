#include "tests/study/steps/parting.hpp"

#include <algorithm>

#include "tests/study/steps/own_steps.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace study {
namespace {

using Trace = walkthroughs::model::Trace;

const std::string own_name = "yours";

bool is_planar(const ToldRun& run) {
  const auto flat = [](const Body& body) {
    return std::ranges::all_of(std::get<Points>(body), [](const Vec& p) { return p[2] == 0; });
  };
  return flat(run.named.pair.a) && flat(run.named.pair.b) && run.steps.front().direction[2] == 0;
}

/// Returns: the simplex at the end of an iteration of a trace.
std::vector<Vec> simplex_after(const Trace& trace, int iteration) {
  std::vector<Vec> vertices;
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
  const std::vector<Vec> there = simplex_after(trace, iteration);
  const auto& told = run.steps[static_cast<std::size_t>(iteration) - 1].simplex;
  return there.size() == told.size() && std::ranges::all_of(told, [&](const Vec& v) {
           return std::ranges::any_of(there, [&](const Vec& w) { return (v - w).norm() <= 1e-9 * w.norm(); });
         });
}

/// Of the report's algorithm, begun as the program has.
walkthroughs::model::Scene scene_of(const ToldRun& run) {
  return {.name = "the report",
          .a = {"point set a", std::get<Points>(run.named.pair.a)},
          .b = {"point set b", std::get<Points>(run.named.pair.b)},
          .options = {.first_direction = run.steps.front().direction},
          .dimension = is_planar(run) ? walkthroughs::model::Dimension::plane : walkthroughs::model::Dimension::space};
}

}  // namespace

walkthroughs::story::Story Parting::story() const {
  walkthroughs::story::Story story = walkthroughs::story::tell(walkthrough, traces);
  std::erase_if(story.frames, [this](const auto& frame) { return frame.moments.front().iteration > iteration + 1; });
  if (words.empty()) return story;
  for (walkthroughs::story::Frame& frame : story.frames) {
    if (frame.focus == walkthroughs::story::Focus::parting)
      frame.caption = frame.headline = "Here the two runs part: " + words + ".";
    for (walkthroughs::story::Fact& fact : frame.facts)
      if (fact.text.starts_with(own_name + ": "))  // what comes of a wrong step may be true again
        fact.mark = frame.focus == walkthroughs::story::Focus::parting ? walkthroughs::story::Fact::Mark::no
                                                                       : walkthroughs::story::Fact::Mark::none;
  }
  return story;
}

std::optional<Parting> parting_of(const ToldRun& run, const StepsChecked& checked) {
  if (checked.iteration == 0) return std::nullopt;
  const walkthroughs::model::Scene right = scene_of(run);
  for (const std::size_t m : checked.mistakes) {
    walkthroughs::model::Walkthrough walkthrough =
        walkthroughs::catalogue::beside_the_report(static_cast<walkthroughs::wrong_on_purpose::Mistake>(m), right);
    std::vector<Trace> traces{walkthroughs::model::run(walkthrough.scenes[0]),
                              walkthroughs::model::run(walkthrough.scenes[1])};
    if (goes_there(traces[0], run, checked.iteration))
      return Parting{std::move(walkthrough), std::move(traces), checked.iteration};
  }
  walkthroughs::model::Scene own = right;
  own.name = own_name;
  return Parting{{.name = "parting",
                  .title = "Your steps, and the report's algorithm",
                  .source = "ARL-TR-7474, Section 3",
                  .summary = "the first step that the report's algorithm would not make",
                  .layout = walkthroughs::model::Layout::until_they_part,
                  .naming = walkthroughs::model::Naming::roles,
                  .scenes = {std::move(own), right}},
                 {own_steps(run), rightly_from(run, checked.iteration)},
                 checked.iteration,
                 checked.words};
}

}  // namespace study
