#include "walkthroughs/model/moment.hpp"

#include <algorithm>
#include <variant>

namespace walkthroughs {
namespace {

/// One overload for each event.
struct Replay {
  Moment& now;

  void operator()(const gjk::SearchStarted<double>& event) {
    now.direction = {.expression = "", .value = event.direction, .from = {}};
  }
  void operator()(const gjk::SupportFound<double>& event) {
    now.iteration = event.iteration;
    now.found = event.vertex;
    now.added = false;
    if (std::ranges::count(now.known, event.vertex.w) == 0) now.known.push_back(event.vertex.w);
    now.crossing.reset();
    now.regions.clear();
    now.reduction.reset();
  }
  void operator()(const gjk::CrossingTested<double>& event) { now.crossing = event; }
  void operator()(const gjk::VertexAdded<double>& event) {
    now.added = true;
    now.before = now.processed;
    now.simplex = now.processed = event.simplex;
    const Point& newest = event.simplex.point(gjk::Role::A);
    for (int i = 0; i + 1 < event.simplex.size(); ++i) now.segments.emplace_back(event.simplex[i].w, newest);
  }
  void operator()(const gjk::RegionTested<double>& event) { now.regions.push_back(event); }
  void operator()(const gjk::SimplexReduced<double>& event) {
    now.reduction = event;
    now.simplex = event.after;
  }
  void operator()(const gjk::DirectionChosen<double>& event) {
    now.direction = {.expression = event.expression, .value = event.direction, .from = now.simplex};
    now.found.reset();
  }
  void operator()(const gjk::Finished<double>& event) { now.result = event.result; }
};

}  // namespace

Moment replay(const Trace& trace, std::size_t count) {
  Moment now;
  for (std::size_t i = 0; i < count; ++i) std::visit(Replay{now}, trace.events[i]);
  return now;
}

}  // namespace walkthroughs
