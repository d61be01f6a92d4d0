#include "tests/study/steps/parting.hpp"

#include <algorithm>

#include "tests/study/methods/mistakes.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace study {
namespace {

using Trace = walkthroughs::Trace;

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

walkthroughs::Scene scene_of(const ToldRun& run, const std::string& name, const gjk::Options<double>& options) {
  return {.name = name,
          .a = {"point set a", std::get<Points>(run.named.pair.a)},
          .b = {"point set b", std::get<Points>(run.named.pair.b)},
          .options = options,
          .dimension = is_planar(run) ? walkthroughs::Dimension::plane : walkthroughs::Dimension::space};
}

}  // namespace

walkthroughs::Story Parting::story() const {
  walkthroughs::Story story = walkthroughs::tell(walkthrough, traces);
  std::erase_if(story.frames, [this](const auto& frame) { return frame.moments.front().iteration > iteration + 1; });
  const std::string mistake = walkthrough.scenes.front().name + ": ";
  for (auto& frame : story.frames)
    for (auto& fact : frame.facts)
      if (fact.text.starts_with(mistake)) fact.mark = walkthroughs::Fact::Mark::no;
  return story;
}

std::optional<Parting> parting_of(const ToldRun& run, const StepsChecked& checked) {
  if (checked.iteration == 0) return std::nullopt;
  const gjk::Options<double> options{.first_direction = run.steps.front().direction};
  const gjk::PointSet<double> a(std::get<Points>(run.named.pair.a)), b(std::get<Points>(run.named.pair.b));
  for (const std::size_t m : checked.mistakes) {
    Trace wrong = mistakes()[m].trace_from(options.first_direction, a, b);
    if (!goes_there(wrong, run, checked.iteration)) continue;
    Trace right;
    gjk::collision<double>(a, b, options, right);
    const std::string number = "M" + std::to_string(m + 1);
    walkthroughs::Walkthrough walkthrough{
        .name = "parting",
        .title = number + ", and the report's algorithm",
        .source = "ARL-TR-7474, Section " + mistakes()[m].section,
        .summary = mistakes()[m].name,
        .layout = walkthroughs::Layout::until_they_part,
        .naming = walkthroughs::Naming::roles,
        .scenes = {scene_of(run, number, options), scene_of(run, "the report", options)}};
    return Parting{std::move(walkthrough), {std::move(wrong), std::move(right)}, checked.iteration};
  }
  return std::nullopt;
}

}  // namespace study
