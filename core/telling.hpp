/// What Algorithms 2-5 tell, and the step that carries out what they decide. Nothing here decides where the
/// origin is: the rules do.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "events.hpp"
#include "vectors.hpp"

namespace gjk {

/// The faces APQ of the tetrahedron that meet A, in the order of Algorithm 5. AP×AQ points out of the tetrahedron.
enum class Face { ABC, ACD, ADB };

/// Which vertices are kept, and why these, in this order.
struct Kept {
  Roles order;
  ReductionReason why;
};

/// What Algorithms 2-5 return: either the simplex contains the origin; or the search goes on from it, in a direction.
template <class S>
class Next {
 public:
  static Next origin_found() { return {}; }
  static Next search_along(const Vec3<S>& direction) { return Next(direction); }

  bool contains_origin() const { return contains_origin_; }

  /// Requires: not contains_origin().
  const Vec3<S>& direction() const { return direction_; }

 private:
  Next() {}
  explicit Next(const Vec3<S>& direction) : contains_origin_(false), direction_(direction) {}

  bool contains_origin_ = true;
  Vec3<S> direction_;
};

namespace detail {

/// Hands events of one iteration to an observer. An event is described by a function that makes it. So nothing is made,
/// and nothing computed for it, when nobody listens.
template <class Obs>
class Teller {
 public:
  static constexpr bool somebody_listens = !std::same_as<std::remove_const_t<Obs>, NobodyListens>;

  Teller(Obs& observer, CrossingTest crossing_test) : observer_(observer), crossing_test_(crossing_test) {}

  template <class MakeEvent>
  void operator()(MakeEvent&& make) {
    if constexpr (somebody_listens) {
      auto event = make();
      event.iteration = iteration_;
      observer_(std::move(event));
    }
  }
  void enter_iteration(int iteration) { iteration_ = iteration; }
  /// The report's reasons for skipping regions differ where the crossing test is off.
  CrossingTest crossing_test() const { return crossing_test_; }

 private:
  Obs& observer_;
  CrossingTest crossing_test_;
  int iteration_ = 0;
};

struct FaceRoles {
  Role P, Q;
  constexpr Roles face() const { return {Role::A, P, Q}; }
};
constexpr FaceRoles roles_of(Face face) {
  constexpr FaceRoles all[] = {{Role::B, Role::C}, {Role::C, Role::D}, {Role::D, Role::B}};
  return all[static_cast<int>(face)];
}

/// What a test is about, and in Algorithm 5 the face whose edge is looked at.
struct Region {
  Roles feature, face = {};
};

/// One call of Algorithms 2-5: the simplex as its vectors, and the telling of what the rules find out about it. The
/// rules decide. A variant may decide otherwise than its numbers say. Then the relation told is that of the numbers,
/// and the reason says how the search goes on.
template <class Rules_, class S, class Obs>
class Step {
 public:
  using Rules = Rules_;
  using Told = std::conditional_t<Teller<Obs>::somebody_listens, Words, NoWords>;

  Step(Simplex<S>& simplex, Teller<Obs>& tell) : simplex_(simplex), tell_(tell) {}

  // -- Vectors --------------------------------------------------------------------------------------------------------

  auto AO() const {
    return to_origin_from(simplex_.point(Role::A), Rules::ZeroTest::size(simplex_[Role::A]), Told(gjk::AO));
  }
  auto AB() const { return edge(Role::B); }
  auto AC() const { return edge(Role::C); }
  auto AD() const { return edge(Role::D); }

  /// AX. Requires: a vertex of that role other than A.
  auto edge(Role X) const {
    const Vec3<S>&P = simplex_.point(X), &A = simplex_.point(Role::A);
    Vec3<S> AX = P - A;
    const auto size = Rules::ZeroTest::size(AX);
    return Vector<S, std::remove_const_t<decltype(size)>, Told>{std::move(AX), size,
                                                                Told(NamedVector::edge(Role::A, X))};
  }

  int size() const { return simplex_.size(); }

  // -- Regions --------------------------------------------------------------------------------------------------------

  /// A region that needs no test.
  void skip(const Region& region, RegionReason reason) const {
    tell_([&] {
      auto event = tested(region);
      event.verdict = Verdict::skipped;
      event.reason = {reason};
      return event;
    });
  }
  /// The region beyond A, which the report skips because of the crossing test, and only because of it.
  void skip_beyond_A() const {
    skip({.feature = "A"}, by_crossing_test(RegionReason::crossed_on_the_way, RegionReason::only_by_crossing_test));
  }

  // Each asks the rules, tells what they say, and returns it.

  template <class Height>
  bool is_beyond_edge(const Region& region, const Height& n_AO) const {
    return tell_sight(region, n_AO, Rules::is_beyond_edge(n_AO));
  }
  template <class Height>
  bool is_above_face(const Region& region, const Height& n_AO) const {
    return tell_sight(region, n_AO, Rules::is_above_face(n_AO));
  }

  template <class Vector>
  bool is_at_origin(const Vector& AO) const {
    return tell_comparison({.feature = "A"}, AO, Rules::is_at_origin(AO), RegionReason::A_is_origin,
                           RegionReason::origin_elsewhere);
  }
  template <class Vector>
  bool is_on_segment(const Vector& direction) const {
    const RegionReason on = by_crossing_test(RegionReason::on_segment, RegionReason::on_line);
    return tell_comparison({.feature = "AB"}, direction, Rules::is_on_segment(direction), on,
                           RegionReason::beside_segment);
  }

  template <class Height>
  Side side_of_triangle(const Height& ABCn_AO) const {
    const Side side = Rules::side_of_triangle(ABCn_AO);
    tell_([&] {
      auto event = tested({.feature = "ABC"}, ABCn_AO);
      event.relation = relation_of(ABCn_AO.side());
      event.reason = finding(reason_for(ABCn_AO.side()), reason_for(side));
      return event;
    });
    return side;
  }

  /// `v` leads from a vertex or an edge to the origin. Returns: whether the origin is there.
  template <class Vector>
  bool is_zero(const Region& region, const Vector& v) const {
    const bool is_vertex = region.feature.size() == 1;
    return tell_comparison(region, v, v.is_zero(), is_vertex ? RegionReason::A_is_origin : RegionReason::on_edge,
                           is_vertex ? RegionReason::no_edge_leads_to_origin : RegionReason::nearest_on_edge);
  }

  /// A question of the complete rules. The caller knows the answer. `decides`: whether a yes settles it.
  template <class Height>
  void tell_question(const Region& region, const Height& X_AO, Relation asked, bool holds, bool decides,
                     RegionReason reason) const {
    tell_([&] {
      auto event = tested(region, X_AO);
      event.verdict = !holds ? Verdict::rejected : decides ? Verdict::chosen : Verdict::possible;
      event.relation = asked;
      event.reason = {reason};
      return event;
    });
  }

  /// Algorithm 5: what is left where no face sees the origin.
  void lies_inside() const {
    tell_([&] {
      auto event = tested({.feature = "ABCD"});
      event.reason = {RegionReason::no_face_sees_origin};
      return event;
    });
  }

  // -- Outcomes -------------------------------------------------------------------------------------------------------

  Next<S> contains_origin() const { return Next<S>::origin_found(); }

  template <class Direction>
  Next<S> keep_all(const Direction& direction) const {
    tell_direction(direction);
    return Next<S>::search_along(direction.value);
  }

  /// The last that is done in a step: it changes the simplex, in place. Returning the kept one takes longer (GCC 12). A
  /// query of two triangles then takes 68 ns instead of 52, one of two tetrahedra 85 ns instead of 67.
  template <class Direction>
  Next<S> keep(const Kept& kept, const Direction& direction) const {
    tell_([&] {
      return SimplexReduced<S>{
          .before = simplex_, .after = simplex_.only(kept.order), .kept = kept.order, .why = kept.why};
    });
    tell_direction(direction);
    simplex_ = simplex_.only(kept.order);
    return Next<S>::search_along(direction.value);
  }

 private:
  template <class Direction>
  void tell_direction(const Direction& d) const {
    tell_([&] { return DirectionChosen<S>{.expression = d.told.called, .direction = d.value}; });
  }

  RegionTested<S> tested(const Region& region) const {
    return {
        .simplex_size = simplex_.size(), .feature = region.feature, .face = region.face, .verdict = Verdict::chosen};
  }
  template <class Height>
  RegionTested<S> tested(const Region& region, const Height& n_AO) const {
    auto event = tested(region);
    const Expression &n = n_AO.X.told.called, &formula = n_AO.X.told.formula;
    event.expression = {Expression::Form::dot, n.X, gjk::AO};
    event.formula = formula.empty() ? n : formula;
    event.normal = n_AO.X.value;
    event.value = n_AO.value;
    return event;
  }

  /// A vector is compared with the zero vector; `found`: what comes of it.
  template <class Vector>
  bool tell_comparison(const Region& region, const Vector& v, bool found, RegionReason if_zero,
                       RegionReason if_not) const {
    tell_([&] {
      auto event = tested(region);
      event.expression = v.told.called;
      event.value = v.value;
      event.relation = v.is_zero() ? Relation::zero : Relation::not_zero;
      event.reason = finding(v.is_zero() ? if_zero : if_not, found ? if_zero : if_not);
      return event;
    });
    return found;
  }

  /// The sign test behind nearly all regions: does the origin lie on the side of A's feature that the normal n points
  /// to?
  template <class Height>
  bool tell_sight(const Region& region, const Height& n_AO, bool chosen) const {
    tell_([&] {
      const bool points_there = n_AO.is_positive();
      const auto reason = [](bool is_so) {
        return is_so ? RegionReason::normal_toward_origin : RegionReason::normal_not_toward_origin;
      };
      auto event = tested(region, n_AO);
      event.verdict = chosen ? Verdict::chosen : Verdict::rejected;
      event.relation = chosen ? relation_of(n_AO.side()) : points_there ? Relation::negative : Relation::positive;
      event.reason = finding(reason(points_there), reason(chosen));
      return event;
    });
    return chosen;
  }

  /// A variant may decide otherwise than its numbers say.
  static Finding finding(RegionReason is, RegionReason goes_on_as) {
    return is == goes_on_as ? Finding{is} : Finding{is, goes_on_as};
  }

  static Relation relation_of(Side side) {
    switch (side) {
      case Side::in_plane: return Relation::zero;
      case Side::above: return Relation::positive;
      case Side::below: break;
    }
    return Relation::negative;
  }

  RegionReason reason_for(Side side) const {
    switch (side) {
      case Side::in_plane: return by_crossing_test(RegionReason::in_triangle, RegionReason::in_plane);
      case Side::above: return RegionReason::above_triangle;
      case Side::below: break;
    }
    return RegionReason::below_triangle;
  }

  /// Returns: what can be said with the crossing test (Eq. 9) on, or what is left of it when it is off.
  RegionReason by_crossing_test(RegionReason on, RegionReason off) const {
    return tell_.crossing_test() == CrossingTest::on ? on : off;
  }

  Simplex<S>& simplex_;
  Teller<Obs>& tell_;
};

}  // namespace detail
}  // namespace gjk
