/// The Gilbert-Johnson-Keerthi collision test after ARL-TR-7474 (Breech 2015), Algorithm 1: do two convex sets have a
/// point in common? Headers only; needs C++20 and Eigen.
///
///     const auto result = gjk::collision<double>(shape_a, shape_b);                  // plain: no events, no heap
///     gjk::Trace<double> trace;
///     const auto again = gjk::collision<double>(shape_a, shape_b, options, trace);   // the same run, with its events
///
/// What the algorithm rests on (Section 3.4), as numbered properties. The tests quote them:
///  P1. The support function returns a support point: a point farthest in the direction given. It is never given the
///      zero vector.
///  P2. Every vertex of the simplex lies on the hull of the Minkowski difference. No point of the difference lies
///      farther in the direction in which the vertex was found. (A search that starts inside has one vertex that need
///      not lie there.)
///  P3. A is the vertex added last. The others stay in the order in which they were added. There are two exceptions:
///      Algorithm 4 moves below a triangle, and Algorithm 5 keeps a face.
///  P4. Normals point away from the simplex: no vertex of the triangle or tetrahedron lies on their side of A.
///  P5. Of four vertices, A lies in the direction of BC×BD. (Without the crossing test it may lie in their plane.)
///
/// Sets are closed: touching is intersecting.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "events.hpp"
#include "rules.hpp"

namespace gjk {

namespace detail {

/// For every scalar, the exact ones included: x - x is 0 except for infinities and NaN.
template <class S>
bool is_finite(const S& x) {
  return x - x == S(0);
}

/// One comparison for all three components: three cost some 2 % of a small query.
template <class S>
bool is_finite(const Vec3<S>& v) {
  const Vec3<S> zero = v - v;
  return zero.x() + zero.y() + zero.z() == S(0);
}

}  // namespace detail

/// Returns: whether a support function may be asked about `d` (P1): finite in every component and not zero.
template <class S>
bool is_usable_direction(const Vec3<S>& d) {
  return detail::is_finite(d) && !is_zero(d);
}

namespace detail {

/// Chooses among Algorithms 2-5 by the size of the simplex.
template <class Rules, class S, class Obs>
Next<S> process(Simplex<S>& simplex, Teller<Obs>& tell) {
  const Step<Rules, S, Obs> step(simplex, tell);
  switch (simplex.size()) {
    case 1: return Rules::process_0simplex(step);
    case 2: return Rules::process_1simplex(step);
    case 3: return Rules::process_2simplex(step);
    default: return Rules::process_3simplex(step);
  }
}

/// w·d of Eq. 9, for the vertex found along d.
template <class ZeroTest, class S>
auto reach(const Vertex<S>& vertex, const Vec3<S>& d) {
  return vector(vertex.w, ZeroTest::size(vertex), NoWords(NamedVector()))
      .dot(vector(d, ZeroTest::size(d), NoWords(NamedVector())));
}

/// One run of Algorithm 1. It writes its result where the caller will have it. A copy of the witness simplex and the
/// separating axis costs as much as an iteration.
template <class S, class Rules, class A, class B, class Obs>
class Search {
 public:
  Search(const A& a, const B& b, const Options<S>& options, Obs& observer, Result<S>& result)
      : difference_(Rules::template difference<S>(a, b)),
        options_(options),
        tell_(observer, options.crossing_test),
        direction_(options.inside ? Vec3<S>(options.inside->b - options.inside->a) : options.first_direction),
        result_(result) {}

  void run() {
    if constexpr (std::floating_point<S> && !Teller<Obs>::somebody_listens)
      search_in_one_piece();
    else
      search();
  }

 private:
  using ZeroTest = typename Rules::ZeroTest;
  using Reach = decltype(reach<ZeroTest>(std::declval<Vertex<S>>(), std::declval<Vec3<S>>()));

  /// For the plain call. Everything is inlined, the shapes, too. GCC 12 leaves the search in pieces otherwise. Queries
  /// of triangles then take a tenth longer and more, as tests/bench/peers measures them.
  ///
  /// Compiling takes a third longer. So nothing is inlined by force where GJKSTEP_COMPILED_SOONER is defined. Neither
  /// is it under sanitizers: their checks of all that is inlined take minutes.
#if defined(GJKSTEP_COMPILED_SOONER) || defined(__SANITIZE_ADDRESS__)
  void search_in_one_piece() { search(); }
#else
  [[gnu::flatten]] void search_in_one_piece() { search(); }
#endif

  void search() {
    tell_([&] { return SearchStarted<S>{.direction = direction_, .why = why_first_direction()}; });
    if (options_.inside && is_found_at(*options_.inside))
      return finish(Status::intersecting, Reason::simplex_contains_origin);
    while (result_.iterations < options_.iteration_limit) {
      if (!is_usable_direction(direction_)) return finish(Status::undecided, Reason::unusable_direction);
      if (result_.iterations >= first_to_compare && comes_back()) return finish(Status::undecided, Reason::cycle);
      tell_.enter_iteration(++result_.iterations);
      const Vertex<S> vertex = difference_.vertex(direction_);
      const Reach w_d = reach<ZeroTest>(vertex, direction_);
      std::optional<Reason> reason = reason_to_stop_at(vertex, w_d);
      if (!reason || goes_on_after(*reason)) {
        result_.simplex.add(vertex);
        tell_([&] { return VertexAdded<S>{.simplex = result_.simplex}; });
        const Next<S> next = process<Rules>(result_.simplex, tell_);
        if (next.contains_origin()) {
          if (may_be_believed(w_d)) return finish(Status::intersecting, Reason::simplex_contains_origin);
          reason = Reason::origin_not_crossed;
        } else if (!reason) {
          direction_ = next.direction();
        }
      }
      if (reason) return finish_outside(vertex, w_d, *reason);
    }
    return finish(Status::undecided, Reason::iteration_limit);
  }

  /// Algorithm 2 for a vertex that no support function has found. Returns: whether the origin is there.
  ///
  /// Here we differ from the report: this vertex lies within the difference, not on its hull (P2). No rule minds, since
  /// each rests on the moves. The first move leads from this vertex toward the origin, as it would from one of the
  /// hull.
  bool is_found_at(const PointOfEach<S>& inside) {
    const Vertex<S> start{inside.a, inside.b, inside.a - inside.b};
    if (remembers()) remember(start.w);
    result_.simplex.add(start);
    tell_([&] { return VertexAdded<S>{.simplex = result_.simplex}; });
    return Rules::process_0simplex(Step<Rules, S, Obs>(result_.simplex, tell_)).contains_origin();
  }

  /// Without an observer, most searches have ended before anything is compared.
  static constexpr int first_to_compare = Teller<Obs>::somebody_listens ? 0 : 8;

  static constexpr bool goes_on_after(Reason reason) {
    return reason == Reason::origin_not_crossed && Rules::not_crossed() == NotCrossed::process_the_simplex;
  }

  /// Section 3.1.3. Algorithm 1 prints the addition of the vertex first. Here the tests come first, which changes
  /// nothing.
  ///
  /// Without the crossing test a vertex seen before ends the search. There is one exception: a vertex dropped earlier
  /// that comes back from across the origin is progress. Ending there would leave intersecting sets undecided.
  std::optional<Reason> reason_to_stop_at(const Vertex<S>& vertex, const Reach& w_d) {
    const bool is_new = !remembers() || remember(vertex.w);
    tell_([&] { return SupportFound<S>{.direction = direction_, .vertex = vertex, .is_new = is_new}; });
    if (options_.crossing_test == CrossingTest::off) {
      tell_([] { return CrossingTested<S>{.value = {}, .verdict = Crossing::switched_off}; });
      const bool ran_out = !is_new && (has(vertex.w) || !Rules::crossed(w_d));
      return ran_out ? std::optional(Reason::no_new_vertex) : std::nullopt;
    }
    if (result_.simplex.size() == 0 && Rules::first_point() == FirstPoint::taken_as_it_is) {
      tell_([] { return CrossingTested<S>{.value = {}, .verdict = Crossing::first_point}; });
      return std::nullopt;
    }
    const Crossing verdict = Rules::crossed(w_d) ? Crossing::crossed : Crossing::not_crossed;
    tell_([&] { return CrossingTested<S>{.value = w_d.value, .verdict = verdict}; });
    return verdict == Crossing::crossed ? std::nullopt : std::optional(Reason::origin_not_crossed);
  }

  /// Returns: whether the rules are right to find the origin in the simplex. Where a segment points at the origin or a
  /// triangle is flat, they rely on Eq. 9: the last move has crossed the origin. Without the crossing test this is
  /// looked at here.
  bool may_be_believed(const Reach& w_d) const {
    return options_.crossing_test == CrossingTest::on || Rules::crossed(w_d);
  }

  /// The search stops without having found the origin. Only a finite w·d < 0 proves that the sets are apart. What is
  /// not a number proves nothing.
  void finish_outside(const Vertex<S>& vertex, const Reach& w_d, Reason reason) {
    if (!is_finite(w_d.value)) return finish(Status::undecided, Reason::unusable_direction);
    if (Rules::crossed(w_d)) return finish(Status::undecided, reason);
    result_.separation = Separation<S>{direction_, vertex, w_d.value};
    return finish(Status::separated, reason);
  }

  void finish(Status status, Reason reason) {
    result_.status = status;
    result_.reason = reason;
    tell_([&] { return Finished<S>{.result = result_}; });
  }

  /// What an iteration begins with. All later iterations follow from it. Only the run without the crossing test asks
  /// for the number of vertices seen.
  struct State {
    int iteration;
    Vec3<S> direction;
    Simplex<S> simplex;
    std::size_t vertices_seen;
  };

  bool is_now(const State& earlier) const {
    if (earlier.direction != direction_ || earlier.simplex.size() != result_.simplex.size()) return false;
    for (int i = 0; i < earlier.simplex.size(); ++i)
      if (earlier.simplex[i].w != result_.simplex[i].w) return false;
    return options_.crossing_test == CrossingTest::on || earlier.vertices_seen == seen_.size();
  }

  /// Returns: whether the next iteration would begin as an earlier one did. Writes which one.
  ///
  /// With an observer all earlier states are known. Without one a single state is (Brent 1980). It is replaced whenever
  /// it is as old as it was far from the start. So the search ends after at most three times as many iterations as the
  /// longest of these takes:
  ///  - the way into the cycle;
  ///  - once around it;
  ///  - the first comparison.
  [[gnu::noinline]] bool comes_back() {
    const auto now = [&] { return State{result_.iterations + 1, direction_, result_.simplex, seen_.size()}; };
    const State* same = nullptr;
    if constexpr (Teller<Obs>::somebody_listens) {
      const auto found = std::find_if(states_.begin(), states_.end(), [&](const State& each) { return is_now(each); });
      if (found != states_.end())
        same = &*found;
      else
        states_.push_back(now());
    } else {
      if (states_ && is_now(*states_))
        same = &*states_;
      else if (std::has_single_bit(static_cast<unsigned>(result_.iterations)))
        states_ = now();
    }
    if (same) result_.cycle_start = same->iteration;
    return same != nullptr;
  }

  /// Earlier vertices are kept only where somebody needs to know of them.
  bool remembers() const { return Teller<Obs>::somebody_listens || options_.crossing_test == CrossingTest::off; }

  /// Returns: whether no earlier vertex of this run lies at `w`.
  bool remember(const Vec3<S>& w) {
    for (const Vec3<S>& earlier : seen_)
      if (earlier == w) return false;
    seen_.push_back(w);
    return true;
  }

  bool has(const Vec3<S>& w) const {
    return std::any_of(result_.simplex.begin(), result_.simplex.end(), [&](const auto& each) { return each.w == w; });
  }

  FirstDirection why_first_direction() const {
    if (options_.inside) return FirstDirection::from_inside;
    return direction_ == Options<S>{}.first_direction ? FirstDirection::usual : FirstDirection::asked_for;
  }

  const decltype(Rules::template difference<S>(std::declval<const A&>(), std::declval<const B&>())) difference_;
  const Options<S>& options_;
  Teller<Obs> tell_;
  Vec3<S> direction_;
  std::vector<Vec3<S>> seen_;
  std::conditional_t<Teller<Obs>::somebody_listens, std::vector<State>, std::optional<State>> states_;
  Result<S>& result_;
};

}  // namespace detail

/// Asks the one of Algorithms 2-5 that belongs to the size of the simplex. It answers correctly only after the history
/// that Algorithm 1 gives it, see rules.hpp. `simplex`: becomes what is kept of it.
///
/// Requires: 1 <= size <= 4.
/// Observer: called with the events of this step. Their iteration is 0.
template <class Rules = AsIntended, class S, class Obs = const NobodyListens>
requires Observer<Obs, S> Next<S> process(Simplex<S>& simplex, CrossingTest crossing_test = CrossingTest::on,
                                          Obs&& observer = NobodyListens{}) {
  detail::Teller<std::remove_reference_t<Obs>> tell(observer, crossing_test);
  return detail::process<Rules>(simplex, tell);
}

/// Algorithm 1: do the convex sets `a` and `b` have a point in common?
///
/// Requires: finite shapes. S is float, double, long double or an exact number type.
/// Returns: the answer with its witness simplex or its separating axis. It is undecided
///  - at the iteration limit (at once, where that is below 1);
///  - where a search direction is zero, infinite or not a number;
///  - where the search goes round in a cycle.
///
/// With the crossing test on and without an observer it allocates nothing.
/// Observer: called with every event, see events.hpp. The run is the same with and without one, but for cycles. With an
/// observer a cycle is noticed at once, without one later.
/// Errors: none of its own. What a support function or the observer throws passes through.
///
/// An exact S answers correctly whenever it decides. In floating point the rules compare rounded products with zero, as
/// the report does:
///  - Sets that touch, or are coplanar in a plane askew, may be found apart or together.
///  - Products of up to four differences overflow or vanish where these are beyond about 1e±75 (double) or 1e±8
///    (float). The answers are then arbitrary.
template <class S = double, class Rules = AsIntended, Shape<S> A, Shape<S> B, class Obs = const NobodyListens>
requires Observer<Obs, S> Result<S> collision(const A& a, const B& b, const Options<S>& options = {},
                                              Obs&& observer = NobodyListens{}) {
  Result<S> result;
  detail::Search<S, Rules, A, B, std::remove_reference_t<Obs>>(a, b, options, observer, result).run();
  return result;
}

}  // namespace gjk
