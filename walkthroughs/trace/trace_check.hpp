/// Does a trace agree with itself? Looked at event by event, from the trace alone: no search is run.
///
/// What is checked, event by event:
///  C1. The order of Algorithm 1; iterations count up by one; the search ends when it must and not before.
///  C2. A search goes along the direction chosen last; the first direction is that of the scene.
///  C3. w = a - b, to the bit; a and b are farthest points of their objects; `new` holds where no earlier w is the same.
///  C4. The value of the crossing test is w·d, and its verdict follows from it (Eq. 9).
///  C5. A simplex consists of vertices found before: identical, and in the order that the roles say.
///  C6. Each region is one that Algorithms 2-5 look at there (trace_rules.hpp). Normals and values are what formulas and
///      expressions say, and verdicts follow from values.
///  C7. The direction chosen, and what is kept, follow from the last region.
///  C8. Status and reason follow from how the search ended, and so does the proof of separation.
///
///  Of a scene that is certified, C9 to C13 of trace_certified.hpp.
///
/// Numbers that only were copied must be identical; numbers that were computed may differ by what rounding can
/// explain (trace_expression.hpp). A search with a mistake is held to the mistake that its scene names (trace_mistakes.hpp).
/// The words in `why` and `reason` of regions are free.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/trace/trace_certified.hpp"
#include "walkthroughs/trace/trace_contradiction.hpp"
#include "walkthroughs/trace/trace_expression.hpp"
#include "walkthroughs/trace/trace_rules.hpp"

namespace walkthroughs {

/// The events of one scene, given one by one.
class TraceCheck {
 public:
  /// `scene` must outlive the check.
  explicit TraceCheck(const Scene& scene);

  /// Errors: Contradiction, about the first thing that is wrong with this event. The check is over then.
  void operator()(const gjk::Event<double>& event);

  /// Returns: whether the search has finished, so that nothing may follow.
  bool is_finished() const { return expected_now().empty(); }
  /// Returns: the kinds of event of which one must come next, in words.
  std::string expected() const;

 private:
  struct Ending {
    gjk::Status status;
    gjk::Reason reason;
  };
  /// What an iteration began with.
  struct State {
    Point direction;
    gjk::Simplex<double> simplex;
    std::size_t vertices_known;
  };
  using Vertex = gjk::Vertex<double>;

  const std::vector<std::size_t>& expected_now() const { return certified_ ? certified_->expected() : expected_; }
  int expected_iteration(std::size_t kind) const;
  using Simplex = gjk::Simplex<double>;

  void check(const gjk::SearchStarted<double>& event);
  void check(const gjk::SupportFound<double>& event);
  void check(const gjk::CrossingTested<double>& event);
  void check(const gjk::VertexAdded<double>& event);
  void check(const gjk::RegionTested<double>& event);
  void check(const gjk::SimplexReduced<double>& event);
  void check(const gjk::DirectionChosen<double>& event);
  void check(const gjk::Finished<double>& event);
  void check(const auto&) {}  // only what is certified tells others

  gjk::Crossing crossing_that_follows(const gjk::CrossingTested<double>& event) const;
  void decide_after_crossing(const gjk::CrossingTested<double>& event);
  bool is_missed(double reach) const;
  bool reach_counts_as_zero() const;
  bool reach_may_be_crossed() const;
  void go_on(const RuleStep& step);
  void begin_search();
  int iteration_that_began_so() const;
  void end_outside(gjk::Reason reason);
  void check_separation(const gjk::Result<double>& result) const;
  void check_cycle(const gjk::Result<double>& result) const;
  bool has(const Point& w) const;

  const Scene& scene_;
  std::vector<std::size_t> expected_{event_index<gjk::SearchStarted>};  ///< one of these comes next
  std::vector<Ending> endings_;  ///< one of these is how a search that ends next ends
  int iteration_ = 0;
  Point direction_ = Point::Zero();
  Vertex vertex_;       ///< found last
  bool is_new_ = true;  ///< whether it was
  gjk::Crossing crossing_ = gjk::Crossing::crossed;
  RoundedScalar reach_{0};     ///< vertex_.w·direction_: exact where the trace tells it
  std::vector<Point> known_;   ///< each place found so far, once
  std::vector<State> states_;  ///< with which each iteration began
  Simplex simplex_;
  std::vector<gjk::RegionTested<double>> told_;  ///< of simplex_ as it is being processed
  RuleStep step_;                                ///< how far the rule for simplex_ has come, or how it ended
  std::optional<CertifiedCheck> certified_;      ///< of a scene that is certified, once its first search has finished
};

}  // namespace walkthroughs
