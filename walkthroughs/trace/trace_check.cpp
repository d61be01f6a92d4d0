#include "walkthroughs/trace/trace_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/trace/farthest.hpp"
#include "walkthroughs/trace/trace_mistakes.hpp"
#include "walkthroughs/trace/trace_nearest.hpp"
#include "walkthroughs/trace/trace_region.hpp"

namespace walkthroughs {
namespace {

using gjk::Crossing;
using gjk::CrossingTest;
using gjk::Reason;
using gjk::Status;

void require_identical(const Point& found, const Point& expected, const std::string& key, const std::string& source) {
  if (!is_identical(found, expected))
    throw Contradiction(in_quotes(key) + " is " + written(found) + ", but " + source + " is " + written(expected));
}

/// Returns: a - b in numbers of that scalar. Subtracted in floats, not in doubles that are rounded after: GCC 12 leaves out
/// the roundings of x.cast<float>().cast<double>().
Point difference(const Point& a, const Point& b, Scalar scalar) {
  if (scalar == Scalar::binary64) return a - b;
  const gjk::Vec3<float> w = a.cast<float>() - b.cast<float>();
  return w.cast<double>();
}

// -- Comparing --------------------------------------------------------------------------------------------------------

using walkthroughs::is_identical;

bool is_identical(const std::optional<int>& i, const std::optional<int>& j) { return i == j; }

template <Record R>
bool is_identical(const R& x, const R& y) {
  const auto has_same = [&](const auto&... fields) {
    return (is_identical(x.*fields.member, y.*fields.member) && ...);
  };
  return std::apply(has_same, FieldsOf<R>::list);
}

void require_identical(const gjk::Simplex<double>& found, const gjk::Simplex<double>& expected, const std::string& key,
                       const std::string& source) {
  require(found.size() == expected.size(), in_quotes(key) + " has " + std::to_string(found.size()) +
                                               " vertices, but there are " + std::to_string(expected.size()) + " in " +
                                               source);
  for (int i = 0; i < found.size(); ++i)
    require(is_identical(found[i], expected[i]),
            "vertex " + std::to_string(i) + " of " + in_quotes(key) + " is not that of " + source);
}

}  // namespace

// -- The course of the search -----------------------------------------------------------------------------------------

TraceCheck::TraceCheck(const Scene& scene) : scene_(scene) {}

std::string TraceCheck::expected() const {
  std::string list;
  for (const std::size_t kind : expected_now()) list += (list.empty() ? "" : " or ") + in_quotes(event_names[kind]);
  return list;
}

void TraceCheck::operator()(const gjk::Event<double>& event) {
  const auto kind = event.index();
  if (std::ranges::count(expected_now(), kind) == 0)
    throw Contradiction(in_quotes(event_names[kind]) + (is_finished()
                                                            ? " follows, but the search of this scene has finished"
                                                            : " cannot follow here; expected " + expected()));
  const int iteration = std::visit([](const auto& e) { return e.iteration; }, event);
  require(iteration == expected_iteration(kind), "'iteration' is " + std::to_string(iteration) + "; expected " +
                                                     std::to_string(expected_iteration(kind)) +
                                                     ", as they count up by one");
  if (certified_)
    (*certified_)(event);
  else
    std::visit([this](const auto& e) { check(e); }, event);
}

int TraceCheck::expected_iteration(std::size_t kind) const {
  if (certified_) return certified_->iteration_of_next(kind);
  return kind == event_index<gjk::SupportFound> ? iteration_ + 1 : iteration_;
}

void TraceCheck::check(const gjk::SearchStarted<double>& event) {
  require_identical(event.direction, scene_.options.first_direction, "direction", "the scene's 'first_direction'");
  direction_ = event.direction;
  begin_search();
}

/// Algorithm 1 is at the top of its loop. A search that has come back to where it was may also go round: those that were
/// written before that was noticed did.
void TraceCheck::begin_search() {
  expected_ = {event_index<gjk::Finished>};
  if (iteration_ >= scene_.options.iteration_limit) {
    endings_ = {{Status::undecided, Reason::iteration_limit}};
  } else if (!gjk::is_usable_direction(direction_)) {
    endings_ = {{Status::undecided, Reason::unusable_direction}};
  } else if (iteration_that_began_so() != 0) {
    endings_ = {{Status::undecided, Reason::cycle}};
    expected_.push_back(event_index<gjk::SupportFound>);
  } else {
    expected_ = {event_index<gjk::SupportFound>};
  }
}

/// Returns: the first iteration that began with the simplex and the direction of now; 0 where none did.
int TraceCheck::iteration_that_began_so() const {
  const auto is_now = [this](const State& earlier) {
    if (earlier.direction != direction_ || earlier.simplex.size() != simplex_.size()) return false;
    for (int i = 0; i < simplex_.size(); ++i)
      if (earlier.simplex[i].w != simplex_[i].w) return false;
    return scene_.options.crossing_test == CrossingTest::on || earlier.vertices_known == known_.size();
  };
  const auto found = std::ranges::find_if(states_, is_now);
  return found == states_.end() ? 0 : static_cast<int>(found - states_.begin()) + 1;
}

void TraceCheck::check(const gjk::SupportFound<double>& event) {
  ++iteration_;
  states_.push_back({direction_, simplex_, known_.size()});
  require_identical(event.direction, direction_, "direction", "the direction chosen last");
  const gjk::Vertex<double>& v = event.vertex;
  require_identical(v.w, difference(v.a.point, v.b.point, scene_.scalar), "w", "a - b");
  const std::string against_a = objection_to(v.a, scene_.a, direction_, scene_.scalar);
  require(against_a.empty(), "'a' " + against_a);
  const bool is_backward = scene_.mistake == Mistake::wrong_side_of_b;
  const std::string against_b =
      objection_to(v.b, scene_.b, is_backward ? direction_ : Point(-direction_), scene_.scalar);
  require(against_b.empty(), "'b' " + against_b);
  require_new(event, known_);
  vertex_ = v;
  is_new_ = event.is_new;
  reach_ = dot({v.w}, {direction_}, scene_.scalar);
  expected_ = {event_index<gjk::CrossingTested>};
}

/// Eq. 9.
bool TraceCheck::is_missed(double reach) const {
  return scene_.mistake == Mistake::touching_is_apart ? !(reach > 0) : reach < 0;
}

Crossing TraceCheck::crossing_that_follows(const gjk::CrossingTested<double>& event) const {
  if (scene_.options.crossing_test == CrossingTest::off) return Crossing::switched_off;
  if (simplex_.size() == 0 && gjk::first_point(scene_.rules) == gjk::FirstPoint::taken_as_it_is)
    return Crossing::first_point;
  const bool is_negative = event.value && is_missed(*event.value);
  return is_negative && !(event.verdict == Crossing::crossed && reach_counts_as_zero()) ? Crossing::not_crossed
                                                                                        : Crossing::crossed;
}

void TraceCheck::check(const gjk::CrossingTested<double>& event) {
  const Crossing verdict = crossing_that_follows(event);
  const bool is_applied = verdict == Crossing::crossed || verdict == Crossing::not_crossed;
  require(event.value.has_value() == is_applied, is_applied
                                                     ? "'value' is missing: the crossing test applies here"
                                                     : "'value' is given, but the crossing test does not apply here");
  if (event.value) {
    require(agrees(*event.value, reach_),
            "'value' is " + number_text(*event.value) + ", but w·direction is " + number_text(reach_.value));
    reach_ = {*event.value};
  }
  require(event.verdict == verdict,
          "'verdict' is " + in_quotes(words_of::of(event.verdict)) +
              (event.value ? ", but the value " + number_text(*event.value) : ", but the test") + " says " +
              in_quotes(words_of::of(verdict)));
  crossing_ = verdict;
  decide_after_crossing(event);
}

/// Without the crossing test the trace does not tell w·d. Where it is too close to zero to know its sign, both ways of
/// going on are accepted.
void TraceCheck::decide_after_crossing(const gjk::CrossingTested<double>& event) {
  expected_ = {event_index<gjk::VertexAdded>};
  const bool ends_if_not_crossed = gjk::not_crossed(scene_.rules) == gjk::NotCrossed::answer_at_once;
  if (event.verdict == Crossing::not_crossed && ends_if_not_crossed) {
    expected_ = {event_index<gjk::Finished>};
    end_outside(Reason::origin_not_crossed);
  } else if (event.verdict == Crossing::switched_off && !is_new_) {
    if (!has(vertex_.w) && !reach_.may_be_negative()) return;
    const bool must_end = has(vertex_.w) || !reach_may_be_crossed();
    expected_ = must_end ? std::vector{event_index<gjk::Finished>}
                         : std::vector{event_index<gjk::VertexAdded>, event_index<gjk::Finished>};
    end_outside(Reason::no_new_vertex);
  }
}

void TraceCheck::check(const gjk::VertexAdded<double>& event) {
  simplex_.add(vertex_);
  require_identical(event.simplex, simplex_, "simplex", "the simplex before with the vertex found");
  step_ = {};
  told_.clear();
  expected_ = {event_index<gjk::RegionTested>};
}

void TraceCheck::check(const gjk::RegionTested<double>& event) {
  const bool is_complete = scene_.rules == RuleSet::complete && simplex_.size() > 1;
  std::vector<RuleRow> rows =
      is_complete ? complete_rows(told_, simplex_.size()) : rows_at(step_.place, simplex_.size());
  if (scene_.mistake) make_mistake(*scene_.mistake, simplex_.size(), rows);
  const RuleStep next = step_after(event, simplex_, rows, scene_);
  told_.push_back(event);
  go_on(next);
}

/// Returns: whether w·d may count as zero, though it may not be zero.
bool TraceCheck::reach_counts_as_zero() const {
  return scene_.zero_test == ZeroTest::relative &&
         may_count_as_zero(reach_.value, length_of(vertex_) * direction_.lpNorm<1>(), scene_.scalar);
}

void TraceCheck::go_on(const RuleStep& step) {
  step_ = step;
  expected_ = {!step.is_end             ? event_index<gjk::RegionTested>
               : step.direction.empty() ? event_index<gjk::Finished>
               : step.kept.empty()      ? event_index<gjk::DirectionChosen>
                                        : event_index<gjk::SimplexReduced>};
  if (!step.is_end || !step.direction.empty()) return;
  const bool is_tested = scene_.options.crossing_test == CrossingTest::on;
  endings_.clear();
  if (!is_tested && reach_.may_be_negative()) end_outside(Reason::origin_not_crossed);
  if (is_tested || reach_may_be_crossed() || std::isnan(reach_.value))
    endings_.push_back({Status::intersecting, Reason::simplex_contains_origin});
}

// -- What follows from them -------------------------------------------------------------------------------------------

void TraceCheck::check(const gjk::SimplexReduced<double>& event) {
  require_identical(event.before, simplex_, "before", "the simplex as it was");
  const std::string dropped = gjk::detail::letters_beside(step_.kept, simplex_.size());
  const auto require_word = [](std::string_view found, std::string_view expected, const char* key) {
    require(found == expected,
            in_quotes(key) + " is " + in_quotes(found) + "; after this region it is " + in_quotes(expected));
  };
  require_word(event.kept, step_.kept, "kept");
  require_word(event.dropped, dropped, "dropped");
  Simplex kept;
  for (const char name : step_.kept) kept.add(simplex_[static_cast<gjk::Role>(name - 'A')]);
  require_identical(event.after, kept, "after", "the simplex that 'kept' says");
  expected_ = {event_index<gjk::DirectionChosen>};
}

/// The letters of the expression are those of the simplex before it was reduced.
void TraceCheck::check(const gjk::DirectionChosen<double>& event) {
  require(event.expression == step_.direction,
          "'expression' is " + in_quotes(event.expression) + "; after this region it is " + in_quotes(step_.direction));
  const std::string formula = scene_.mistake ? formula_of(event.expression, *scene_.mistake, told_) : event.expression;
  const RoundedVector expected = evaluate(formula, simplex_, scene_.scalar);
  require(agrees(event.direction, expected), "'direction' is " + written(event.direction) + ", but " +
                                                 event.expression + " is " + written(expected.value));
  if (!step_.kept.empty()) {
    Simplex kept;
    for (const char name : step_.kept) kept.add(simplex_[static_cast<gjk::Role>(name - 'A')]);
    simplex_ = kept;
  }
  if (crossing_ == Crossing::not_crossed) {  // as printed: the simplex was processed all the same
    expected_ = {event_index<gjk::Finished>};
    return end_outside(Reason::origin_not_crossed);
  }
  direction_ = event.direction;
  begin_search();
}

// -- The end ----------------------------------------------------------------------------------------------------------

/// The origin was not found; only a finite w·d < 0 proves that it is not there.
void TraceCheck::end_outside(Reason reason) {
  endings_.clear();
  if (!std::isfinite(reach_.value)) {
    endings_ = {{Status::undecided, Reason::unusable_direction}};
    return;
  }
  if (reach_.may_be_negative() || is_missed(reach_.value)) endings_.push_back({Status::separated, reason});
  if (reach_may_be_crossed() && scene_.mistake != Mistake::touching_is_apart)
    endings_.push_back({Status::undecided, reason});
}

void TraceCheck::check(const gjk::Finished<double>& event) {
  const gjk::Result<double>& result = event.result;
  const auto words = [](Status status, Reason reason) {
    return in_quotes(words_of::of(status)) + " because of " + in_quotes(words_of::of(reason));
  };
  std::string possible;
  bool is_possible = false;
  for (const Ending& ending : endings_) {
    is_possible = is_possible || (ending.status == result.status && ending.reason == result.reason);
    possible += (possible.empty() ? "" : " or ") + words(ending.status, ending.reason);
  }
  require(is_possible, "the search ends here " + possible + ", not " + words(result.status, result.reason));
  require(result.iterations == iteration_,
          "'iterations' is " + std::to_string(result.iterations) + ", but there were " + std::to_string(iteration_));
  require_identical(result.simplex, simplex_, "simplex", "the last one");
  require(result.separation.has_value() == (result.status == Status::separated),
          "'separation' is there exactly where the status is 'separated'");
  if (result.separation) check_separation(result);
  check_cycle(result);
  expected_.clear();
  if (scene_.certified) certified_.emplace(scene_, result, known_);
}

void TraceCheck::check_cycle(const gjk::Result<double>& result) const {
  require(result.cycle_start.has_value() == (result.reason == Reason::cycle),
          "'cycle_start' is there exactly where the reason is 'cycle'");
  if (!result.cycle_start) return;
  const int start = iteration_that_began_so();
  require(*result.cycle_start == start, "'cycle_start' is " + std::to_string(*result.cycle_start) +
                                            ", but it was iteration " + std::to_string(start) +
                                            " that began as the next would");
}

void TraceCheck::check_separation(const gjk::Result<double>& result) const {
  const gjk::Separation<double>& proof = *result.separation;
  require_identical(proof.direction, direction_, "separation.direction", "the direction of the last search");
  require(is_identical(proof.vertex, vertex_), "'separation.vertex' is not the vertex found last");
  require(is_missed(proof.support_value), "'separation.support_value' is " + number_text(proof.support_value) +
                                              ", which is not below 0 and proves nothing");
  require(agrees(proof.support_value, reach_), "'separation.support_value' is " + number_text(proof.support_value) +
                                                   ", but w·direction is " + number_text(reach_.value));
}

bool TraceCheck::reach_may_be_crossed() const { return reach_.may_be_positive_or_zero() || reach_counts_as_zero(); }

bool TraceCheck::has(const Point& w) const {
  for (int i = 0; i < simplex_.size(); ++i)
    if (simplex_[i].w == w) return true;
  return false;
}

}  // namespace walkthroughs
