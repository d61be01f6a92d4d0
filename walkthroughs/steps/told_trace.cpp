#include "walkthroughs/steps/told_trace.hpp"

#include <optional>
#include <utility>

#include "core/gjk.hpp"
#include "walkthroughs/steps/differences.hpp"

namespace walkthroughs::steps {
namespace {

using Simplex = gjk::Simplex<double>;
using Vertex = gjk::Vertex<double>;

constexpr int most_iterations = 100;  // of the report's algorithm, after what was told

/// One iteration after the other: what the program tells, or what the report does in its place.
class Steps {
 public:
  explicit Steps(const ToldRun& run) : run_(run), a_(run.pair.a), b_(run.pair.b), differences_(a_, b_) {
    trace_(gjk::SearchStarted<double>{.direction = run.steps.front().direction, .why = gjk::FirstDirection::as_told});
  }

  /// As told.
  void follow(int iteration) {
    const ToldStep& step = step_of(iteration);
    const Simplex before = with_newest(iteration, step.direction, newest_of(step));
    const Next right = next_of(before);
    simplex_ = {};
    for (const Vec& w : step.simplex) simplex_.add(vertex_at(w));
    if (right.reduced && are_same(right.reduced->after, simplex_))
      add(iteration, *right.reduced);
    else if (!are_same(before, simplex_))
      add(iteration, reduced(before));
    if (iteration == count()) return;
    const Vec& d = step_of(iteration + 1).direction;
    const bool is_right = right.chosen && parallel(right.chosen->direction, d);
    add(iteration, is_right
                       ? *right.chosen
                       : gjk::DirectionChosen<double>{.expression = gjk::Expression::Form::as_told, .direction = d});
  }

  /// As the report has it, from that iteration to its end.
  void correct(int iteration) {
    const ToldStep& step = step_of(iteration);
    const Vec own = newest_of(step).w;
    Vec d = step.direction;
    Vertex newest = differences_.reaches(own, d) ? vertex_at(own) : farthest_along(d);
    for (const int most = iteration + most_iterations;; ++iteration) {
      if (iteration > 1 && newest.w.dot(d) < 0) {
        add(iteration, gjk::SupportFound<double>{.direction = d, .vertex = newest});
        return finish(iteration, gjk::Status::separated, gjk::Reason::origin_not_crossed);
      }
      const Simplex before = with_newest(iteration, d, newest);
      const Next right = next_of(before);
      simplex_ = right.reduced ? right.reduced->after : before;
      if (right.reduced) add(iteration, *right.reduced);
      if (right.chosen) add(iteration, *right.chosen);
      if (right.contains_origin)
        return finish(iteration, gjk::Status::intersecting, gjk::Reason::simplex_contains_origin);
      if (!right.chosen) return finish(iteration, gjk::Status::undecided, gjk::Reason::unusable_direction);
      if (iteration == most) return finish(iteration, gjk::Status::undecided, gjk::Reason::iteration_limit);
      d = right.chosen->direction;
      newest = vertex_at(farthest_along(d).w);
    }
  }

  void finish_as_told() {
    const gjk::Status said = run_.said.value_or(gjk::Status::undecided);
    finish(count(), said,
           said == gjk::Status::intersecting ? gjk::Reason::simplex_contains_origin
           : said == gjk::Status::separated  ? gjk::Reason::origin_not_crossed
                                             : gjk::Reason::iteration_limit);
  }

  int count() const { return static_cast<int>(run_.steps.size()); }
  Trace take() { return std::move(trace_); }

 private:
  /// What the report makes of a simplex.
  struct Next {
    std::optional<gjk::SimplexReduced<double>> reduced;
    std::optional<gjk::DirectionChosen<double>> chosen;
    bool contains_origin = false;

    void operator()(const gjk::SimplexReduced<double>& event) { reduced = event; }
    void operator()(const gjk::DirectionChosen<double>& event) { chosen = event; }
    template <class E>
    void operator()(const E&) {}
  };

  static Next next_of(Simplex simplex) {
    Next next;
    const bool contains = gjk::process<gjk::AsIntended>(simplex, gjk::CrossingTest::on, next).contains_origin();
    next.contains_origin = contains;
    return next;
  }

  bool are_same(const Simplex& x, const Simplex& y) const {
    if (x.size() != y.size()) return false;
    for (int i = 0; i < x.size(); ++i)
      if (!differences_.are_same(x[i].w, y[i].w)) return false;
    return true;
  }

  bool has(const Simplex& simplex, const Vec& w) const {
    for (int i = 0; i < simplex.size(); ++i)
      if (differences_.are_same(simplex[i].w, w)) return true;
    return false;
  }

  template <class E>
  void add(int iteration, E event) {
    event.iteration = iteration;
    trace_(std::move(event));
  }

  void finish(int iteration, gjk::Status status, gjk::Reason reason) {
    gjk::Result<double> result;
    result.status = status;
    result.reason = reason;
    result.iterations = iteration;
    result.simplex = simplex_;
    add(iteration, gjk::Finished<double>{.result = result});
  }

  const ToldStep& step_of(int iteration) const { return run_.steps[static_cast<std::size_t>(iteration) - 1]; }

  Simplex with_newest(int iteration, const Vec& direction, const Vertex& newest) {
    add(iteration, gjk::SupportFound<double>{.direction = direction, .vertex = newest});
    Simplex simplex = simplex_;
    if (simplex.size() < 4) simplex.add(newest);  // else it has not been reduced, and that is what is wrong
    add(iteration, gjk::VertexAdded<double>{.simplex = simplex});
    return simplex;
  }

  /// The one that the simplex before has not; the farthest, where it is the one that was left out.
  Vertex newest_of(const ToldStep& step) const {
    for (const Vec& w : step.simplex)
      if (!has(simplex_, w)) return vertex_at(w);
    return farthest_along(step.direction);
  }

  Vertex farthest_along(const Vec& d) const {
    const gjk::PointSet<double> a(a_), b(b_);
    return gjk::MinkowskiDifference<double, gjk::PointSet<double>, gjk::PointSet<double>>{a, b}.vertex(d);
  }

  /// The points of both sets whose difference it is.
  Vertex vertex_at(const Vec& w) const {
    Vertex vertex{{w, std::nullopt}, {Vec::Zero(), std::nullopt}, w};
    for (const Vec& p : a_)
      for (const Vec& q : b_)
        if (differences_.are_same(p - q, w)) vertex = {{p, std::nullopt}, {q, std::nullopt}, w};
    return vertex;
  }

  gjk::SimplexReduced<double> reduced(const Simplex& before) const {
    gjk::SimplexReduced<double> event{.before = before, .after = simplex_, .kept = {}};
    for (int i = 0; i < before.size(); ++i)
      if (has(simplex_, before[i].w)) event.kept.add(static_cast<gjk::Role>(before.size() - 1 - i));
    return event;
  }

  const ToldRun& run_;
  const Points &a_, &b_;
  Differences differences_;
  Trace trace_;
  Simplex simplex_;
};

}  // namespace

Trace told_trace(const ToldRun& run) {
  Steps steps(run);
  for (int i = 1; i <= steps.count(); ++i) steps.follow(i);
  steps.finish_as_told();
  return steps.take();
}

Trace rightly_from(const ToldRun& run, int iteration) {
  Steps steps(run);
  for (int i = 1; i < iteration; ++i) steps.follow(i);
  steps.correct(iteration);
  return steps.take();
}

}  // namespace walkthroughs::steps
