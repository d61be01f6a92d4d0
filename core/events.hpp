/// Everything that GJK tells while it runs. A complete list of events replays, draws and checks a run without the
/// shapes.
///
/// Events are values. What follows from other values is a function here. What they are called is in event_words.hpp.
/// Roles and expressions use the report's letters for the simplex that is being processed. That is the one of the last
/// VertexAdded.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certificate.hpp"
#include "expression.hpp"

namespace gjk {

enum class FirstDirection { usual, asked_for, from_inside, as_told };

template <class S>
struct SearchStarted {
  int iteration = 0;
  Vec3<S> direction;
  FirstDirection why = FirstDirection::usual;
  friend bool operator==(const SearchStarted&, const SearchStarted&) = default;
};

/// Eqs. 5-8 were asked for the support point of the difference.
template <class S>
struct SupportFound {
  int iteration = 0;
  Vec3<S> direction;
  Vertex<S> vertex;
  bool is_new = true;  ///< no earlier vertex of this run lies at the same place
  friend bool operator==(const SupportFound&, const SupportFound&) = default;
};

enum class Crossing { crossed, not_crossed, first_point, switched_off };

/// Eq. 9 for the vertex just found.
template <class S>
struct CrossingTested {
  int iteration = 0;
  std::optional<S> value;  ///< w·d; empty exactly where the test was not applied
  Crossing verdict = Crossing::crossed;
  friend bool operator==(const CrossingTested&, const CrossingTested&) = default;
};

template <class S>
struct VertexAdded {
  int iteration = 0;
  Simplex<S> simplex;  ///< the vertex added is the newest
  friend bool operator==(const VertexAdded&, const VertexAdded&) = default;
};

/// What the value of a region test was compared with. A scalar is compared with 0, a vector with the zero vector.
enum class Relation { positive, negative, zero, not_zero, not_negative };

enum class Verdict { chosen, rejected, skipped, possible };

/// Why a region need not be asked about, or what the verdict means.
enum class RegionReason {
  // Skipped:
  left_behind,            ///< the search has just moved away from it, toward the origin
  ruled_out_before,       ///< when the search kept what is left beside A
  crossed_on_the_way,     ///< by the crossing test
  only_by_crossing_test,  ///< with which this run does without
  nearer_with_A,          ///< the move to A brought the simplex nearer to the origin
  // A compared with the origin:
  A_is_origin,
  origin_elsewhere,
  no_edge_leads_to_origin,
  // An edge:
  on_segment,
  on_line,  ///< without the crossing test the ends are not ruled out
  beside_segment,
  on_edge,
  nearest_on_edge,
  nearer_along_edge,
  no_nearer_along_edge,
  beyond_edge_in_plane,
  within_edge_in_plane,
  // A triangle:
  in_triangle,
  in_plane,  ///< without the crossing test
  above_triangle,
  below_triangle,
  above_face_within_edges,
  not_above_face,
  // A normal:
  normal_toward_origin,
  normal_not_toward_origin,
  // A tetrahedron:
  no_face_sees_origin,
};

/// `is`: what the numbers say.
/// `goes_on_as_if`: where a variant goes on otherwise, what it takes them to say.
struct Finding {
  RegionReason is = RegionReason::ruled_out_before;
  std::optional<RegionReason> goes_on_as_if = {};
  friend bool operator==(const Finding&, const Finding&) = default;
};

/// One region of Algorithms 2-5. Its verdict is
///  - `chosen` where the value stands in `relation` to zero,
///  - `rejected` where it does not,
///  - `possible` where it does and this alone does not decide. Only the complete rules (complete.hpp) say so.
///
/// Regions that the algorithm does not reach, because it has chosen one before, are not told.
template <class S>
struct RegionTested {
  int iteration = 0;
  int simplex_size = 0;
  Roles feature;                       ///< A, AB, ABC, ABCD, ...
  Roles face = {};                     ///< the face whose edge is tested (Algorithm 5); else empty
  Expression expression = {};          ///< "ABn·AO"; empty where nothing had to be computed
  Expression formula = {};             ///< how the normal in `expression` was made: "AB×ABCn"; else empty
  std::optional<Vec3<S>> normal = {};  ///< the value of `formula`
  std::variant<std::monostate, S, Vec3<S>> value = {};  ///< the value of `expression`
  Relation relation = Relation::positive;
  Verdict verdict = Verdict::skipped;
  Finding reason = {};
  friend bool operator==(const RegionTested&, const RegionTested&) = default;
};

/// The report's names of regions (Figs. 6 and 7).
enum class RegionLabel { none, R1, R2, R3, R4, R5, R6, R7, R3_or_R4 };

/// Returns: the report's name of the region that a test decides about. The report has none for
///  - a segment found to hold the origin,
///  - faces of a tetrahedron,
///  - what else the complete rules ask.
template <class S>
RegionLabel label_of(const RegionTested<S>& test) {
  using enum RegionLabel;
  const Roles& feature = test.feature;
  const bool is_tested = test.verdict != Verdict::skipped;
  if (test.simplex_size == 2) {
    if (feature.size() == 1) return feature == "A" ? R2 : R1;
    const bool is_height = test.expression.form == Expression::Form::dot;
    const bool is_on_it = (test.relation == Relation::zero) != test.reason.goes_on_as_if.has_value();
    return is_height || is_on_it ? none : R3_or_R4;
  }
  if (test.simplex_size != 3) return none;
  if (feature == "A") return R2;
  if (feature == "ABC") return R1;
  if (!is_tested) return feature == "B" ? R4 : feature == "BC" ? R5 : R6;
  const bool is_across = test.expression.X.kind == NamedVector::Kind::normal;
  return !is_across ? none : feature == "AB" ? R3 : R7;
}

/// Why vertices are kept, in their order.
enum class ReductionReason {
  beyond_edge,
  turned_below_triangle,  ///< A and B change places
  face_keeps_normal,
  nearest_on_edge,
  nearest_is_A,
  not_turned_below_triangle,  ///< wrong
  face_in_its_order,          ///< wrong
  as_told,                    ///< by another program, which gives no reason
};

template <class S>
struct SimplexReduced {
  int iteration = 0;
  Simplex<S> before, after;
  Roles kept;  ///< in `before`, oldest first: "CA"
  ReductionReason why = ReductionReason::as_told;

  /// Of `before`, oldest first; none where only the order changed.
  Roles dropped() const { return beside(kept, before.size()); }
  friend bool operator==(const SimplexReduced&, const SimplexReduced&) = default;
};

template <class S>
struct DirectionChosen {
  int iteration = 0;
  Expression expression;  ///< "AO", "AB×AO×AB", "ABCn", "−ABCn"
  Vec3<S> direction;
  friend bool operator==(const DirectionChosen&, const DirectionChosen&) = default;
};

template <class S>
struct Finished {
  int iteration = 0;
  Result<S> result;
  friend bool operator==(const Finished&, const Finished&) = default;
};

// -- Of certified_collision() (certified/certified.hpp), after those of its first search ------------------------------
//
// Its exact fallback also tells VertexAdded, SupportFound where it asks the support functions, and DirectionChosen; its
// iterations count on from those of the first search. Directions are rounded there, what is decided with them is not.

/// A number that a proof rests on.
struct FilterValue {
  Expression expression;  ///< "−w·d", "C·(B×A)"
  double value = 0;
  friend bool operator==(const FilterValue&, const FilterValue&) = default;
};

/// The filter was tried on what the first search had found, in the numbers of that search (C1, C2 of
/// certified/certified.hpp). The proof holds where all numbers are larger than `bound`, or all are smaller than -bound.
/// Of a direction the one number has to be larger.
template <class S>
struct FilterTried {
  int iteration = 0;
  Proof proof = Proof::direction;
  std::vector<FilterValue> numbers =
      {};            ///< none where the proof needs what was not found, or other numbers than these
  double bound = 0;  ///< more than all that was rounded
  bool holds = false;
  friend bool operator==(const FilterTried&, const FilterTried&) = default;
};

/// The exact fallback goes by the sign of a polynomial in the coordinates.
template <class S>
struct SignTaken {
  int iteration = 0;
  Expression expression;                 ///< "AB·AO", "ABn·AO", "ABCn·AO", "(AB×AO).x"; "w·d", "max w·d"
  Roles face = {};                       ///< in whose plane ABn lies, in order of the alphabet; else empty
  std::optional<Vertex<S>> vertex = {};  ///< w of w·d; of max w·d the one that reaches farthest, as far as is known
  double value = 0, error = 0;           ///< the polynomial lies within `error` of `value`, ...
  std::optional<int> power = {};  ///< ... both times two to this power, where they would be no doubles without it
  std::string exact = {};         ///< the fraction that it is: "-1/1024"; empty where its sign was not in doubt
  int sign = 0;                   ///< -1, 0 or 1
  friend bool operator==(const SignTaken&, const SignTaken&) = default;
};

/// The feature of the simplex that is nearest to the origin.
template <class S>
struct FeatureKept {
  int iteration = 0;
  Simplex<S> before, after;
  Roles kept;  ///< in `before`, oldest first: "CA"
  bool contains_origin = false;

  /// Of `before`, oldest first.
  Roles dropped() const { return beside(kept, before.size()); }
  friend bool operator==(const FeatureKept&, const FeatureKept&) = default;
};

/// The proven answer.
template <class S>
struct Certified {
  int iteration = 0;
  CertifiedResult result;
  friend bool operator==(const Certified&, const Certified&) = default;
};

template <class S>
using Event = std::variant<SearchStarted<S>, SupportFound<S>, CrossingTested<S>, VertexAdded<S>, RegionTested<S>,
                           SimplexReduced<S>, DirectionChosen<S>, Finished<S>, FilterTried<S>, SignTaken<S>,
                           FeatureKept<S>, Certified<S>>;

/// An observer is called with each event as it happens. Anything that takes an Event will do.
template <class T, class S>
concept Observer = std::invocable<T&, SearchStarted<S>> && std::invocable<T&, SupportFound<S>> &&
    std::invocable<T&, CrossingTested<S>> && std::invocable<T&, VertexAdded<S>> &&
    std::invocable<T&, RegionTested<S>> && std::invocable<T&, SimplexReduced<S>> &&
    std::invocable<T&, DirectionChosen<S>> && std::invocable<T&, Finished<S>>;

/// That of certified_collision() is called with these, too.
template <class T, class S>
concept CertifiedObserver = Observer<T, S> && std::invocable<T&, FilterTried<S>> && std::invocable<T&, SignTaken<S>> &&
    std::invocable<T&, FeatureKept<S>> && std::invocable<T&, Certified<S>>;

/// The default observer. Events meant for it are never made.
struct NobodyListens {
  template <class E>
  void operator()(const E&) const {}
};

/// The observer that keeps everything.
template <class S>
struct Trace {
  std::vector<Event<S>> events;
  template <class E>
  void operator()(E&& event) {
    events.emplace_back(std::forward<E>(event));
  }
};

}  // namespace gjk
