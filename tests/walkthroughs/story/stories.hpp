/// Stories and their events, for the tests of frames and captions.
#pragma once

#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::test {

using namespace program;

/// Returns: what a picture of this event would be about; nothing where it does not change the picture. That a vertex was
/// added changes it where letters are roles, which then move on.
inline std::optional<Focus> focus_of(const gjk::Event<double>& event, Naming naming) {
  struct {
    Naming naming;
    std::optional<Focus> operator()(const gjk::SearchStarted<double>&) { return {}; }
    std::optional<Focus> operator()(const gjk::VertexAdded<double>& e) {
      return naming == Naming::roles && e.simplex.size() > 1 ? std::optional(Focus::added) : std::nullopt;
    }
    std::optional<Focus> operator()(const gjk::SupportFound<double>&) { return Focus::support; }
    std::optional<Focus> operator()(const gjk::CrossingTested<double>& e) {
      return e.verdict == gjk::Crossing::crossed || e.verdict == gjk::Crossing::not_crossed
                 ? std::optional(Focus::crossing)
                 : std::nullopt;
    }
    std::optional<Focus> operator()(const gjk::RegionTested<double>& e) {
      return e.verdict == gjk::Verdict::skipped ? std::nullopt : std::optional(Focus::region);
    }
    std::optional<Focus> operator()(const gjk::SimplexReduced<double>&) { return Focus::reduction; }
    std::optional<Focus> operator()(const gjk::DirectionChosen<double>&) { return Focus::direction; }
    std::optional<Focus> operator()(const gjk::Finished<double>&) { return Focus::end; }
    std::optional<Focus> operator()(const gjk::FilterTried<double>&) { return {}; }  // these four: certified_test.cpp
    std::optional<Focus> operator()(const gjk::SignTaken<double>&) { return {}; }
    std::optional<Focus> operator()(const gjk::FeatureKept<double>&) { return {}; }
    std::optional<Focus> operator()(const gjk::Certified<double>&) { return {}; }
  } which{naming};
  return std::visit(which, event);
}

/// The walkthroughs that tell one search from beginning to end, and no proof, in letters of corners and of roles.
inline std::vector<Story> whole_searches() {
  std::vector<Story> stories;
  for (const Walkthrough& w : whole_catalogue())
    if (w.layout == Layout::search && !w.scenes[0].certified) stories.push_back(tell(w));
  return stories;
}

/// A direction chosen with which a search is where it was before: the same vertices in the same order, the same direction,
/// and without the crossing test, where points found before may end it, the same points found.
struct Return {
  std::size_t event;  ///< its place in the trace
  int to_iteration;   ///< the first that ended there
};

/// Returns: the first such event of a trace, looked for in the events alone; nothing where there is none.
inline std::optional<Return> first_return(const Trace& trace) {
  std::vector<std::pair<std::vector<Point>, int>> states;
  std::vector<Point> simplex, known;
  bool goes_by_known = false;
  const auto take = [&](const Simplex& s) {
    simplex.clear();
    for (int i = 0; i < s.size(); ++i) simplex.push_back(s[i].w);
  };
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    if (const auto* e = std::get_if<gjk::SupportFound<double>>(&trace.events[i]))
      if (!std::ranges::count(known, e->vertex.w)) known.push_back(e->vertex.w);
    if (const auto* e = std::get_if<gjk::CrossingTested<double>>(&trace.events[i]))
      goes_by_known = e->verdict == gjk::Crossing::switched_off;
    if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&trace.events[i])) take(e->simplex);
    if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&trace.events[i])) take(e->after);
    const auto* chosen = std::get_if<gjk::DirectionChosen<double>>(&trace.events[i]);
    if (!chosen) continue;
    std::vector<Point> state = simplex;
    state.push_back(chosen->direction);
    if (goes_by_known) state.insert(state.end(), known.begin(), known.end());
    for (const auto& [earlier, iteration] : states)
      if (earlier == state) return Return{i, iteration};
    states.emplace_back(std::move(state), chosen->iteration);
  }
  return std::nullopt;
}

/// Returns: the events of a story of one search that have a frame, in order.
inline std::vector<gjk::Event<double>> shown(const Story& story) {
  std::vector<gjk::Event<double>> events;
  for (const auto& event : story.tellings.at(0).trace.events)
    if (focus_of(event, story.walkthrough.naming)) events.push_back(event);
  return events;
}

}  // namespace walkthroughs::test
