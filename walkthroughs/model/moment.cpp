#include "walkthroughs/model/moment.hpp"

#include <algorithm>
#include <variant>

namespace walkthroughs::model {
namespace {

/// One overload for each event.
class Replay {
 public:
  explicit Replay(Moment& now) : now(now) {}

  void operator()(const gjk::SearchStarted<double>& event) {
    now.direction = {.expression = {}, .value = event.direction, .from = {}};
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
    if (now.proof) begin_fallback_iteration(event);
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
  void operator()(const gjk::FilterTried<double>& event) { now.proof = event; }
  void operator()(const gjk::SignTaken<double>& event) { now.signs.push_back(event); }
  void operator()(const gjk::FeatureKept<double>& event) {
    now.kept = event;
    now.simplex = event.after;
  }
  void operator()(const gjk::Certified<double>& event) { now.certified = event.result; }

 private:
  Moment& now;

  /// Nothing is left of the first search but where it has been.
  void begin_fallback_iteration(const gjk::VertexAdded<double>& event) {
    if (now.result) now.guess = now.result->status;
    now.in_exact_fallback = true;
    now.iteration = event.iteration;
    now.result.reset();
    now.crossing.reset();
    now.regions.clear();
    now.reduction.reset();
    now.signs.clear();
    now.kept.reset();
    const Point& w = event.simplex.point(gjk::Role::A);
    if (now.found && now.found->w != w) now.found.reset();
    if (std::ranges::count(now.known, w) == 0) now.known.push_back(w);
  }
};

}  // namespace

void advance(Moment& now, const gjk::Event<double>& event) { std::visit(Replay(now), event); }

Moment replay(const Trace& trace, std::size_t count) {
  Moment now;
  for (std::size_t i = 0; i < count; ++i) advance(now, trace.events[i]);
  return now;
}

gjk::Status answer_of(const Trace& trace) {
  if (const auto* end = std::get_if<gjk::Certified<double>>(&trace.events.back())) return end->result.status;
  return std::get<gjk::Finished<double>>(trace.events.back()).result.status;
}

}  // namespace walkthroughs::model
