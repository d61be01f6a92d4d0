/// Stories and their events, for the tests of frames and captions.
#pragma once

#include "tests/walkthroughs/support.hpp"

namespace walkthroughs::test {

/// Returns: what a picture of this event would be about; nothing where it does not change the picture.
inline std::optional<Focus> focus_of(const gjk::Event<double>& event) {
  struct {
    std::optional<Focus> operator()(const gjk::SearchStarted<double>&) { return {}; }
    std::optional<Focus> operator()(const gjk::VertexAdded<double>&) { return {}; }
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
  } which;
  return std::visit(which, event);
}

/// The walkthroughs that tell one search from beginning to end.
inline std::vector<Story> whole_searches() {
  std::vector<Story> stories;
  for (const Walkthrough& w : catalogue())
    if (w.layout == Layout::search) stories.push_back(tell(w));
  return stories;
}

/// Returns: the events that have a frame, in order.
inline std::vector<gjk::Event<double>> shown(const Trace& trace) {
  std::vector<gjk::Event<double>> events;
  std::ranges::copy_if(trace.events, std::back_inserter(events), [](const auto& e) { return focus_of(e).has_value(); });
  return events;
}

}  // namespace walkthroughs::test
