/// What Algorithms 2-5 tell, in which words, and the step that carries out what they decide. Nothing here decides where the
/// origin is: the rules do.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "events.hpp"
#include "next.hpp"
#include "vectors.hpp"

namespace gjk {

/// The faces APQ of the tetrahedron that meet A, in the order of Algorithm 5. AP×AQ points out of the tetrahedron.
enum class Face { ABC, ACD, ADB };

/// Which vertices are kept, and why these, in this order.
struct Kept {
  Order order;
  std::string_view why;
};

namespace detail {

/// Hands events of one iteration to an observer. An event is described by a function that makes it, so that nothing
/// is made, and nothing computed for it, when nobody listens.
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
  std::string_view name;
  Role P, Q;
};
constexpr FaceRoles roles_of(Face face) {
  constexpr FaceRoles all[] = {{"ABC", Role::B, Role::C}, {"ACD", Role::C, Role::D}, {"ADB", Role::D, Role::B}};
  return all[static_cast<int>(face)];
}

/// "AB", "AC", "AD".
constexpr std::string_view name_of_edge(Role X) {
  constexpr std::string_view names[] = {"", "AB", "AC", "AD"};
  return names[static_cast<int>(X)];
}

/// Returns: the letters of these roles, in that order.
inline std::string letters_of(const Order& order) {
  std::string letters;
  for (const Role role : order) letters += letter(role);
  return letters;
}
/// Returns: the letters of a simplex of that size that are not among `kept`, oldest first.
inline std::string letters_beside(std::string_view kept, int size) {
  std::string letters;
  for (int i = size; i-- > 0;)
    if (const char name = letter(static_cast<Role>(i)); kept.find(name) == std::string_view::npos) letters += name;
  return letters;
}

/// One region: the report's "R1" ... "R7", and in Algorithm 5 the face whose edge is looked at.
struct Region {
  std::string_view feature, label = {}, face = {};
};

/// One call of Algorithms 2-5: the simplex as its vectors, and the telling of what the rules find out about it. The rules
/// decide; where a variant decides otherwise than its numbers say, the relation told is that of the numbers, and the reason
/// says how the search goes on.
template <class Rules_, class S, class Obs>
class Step {
 public:
  using Rules = Rules_;
  using Told = std::conditional_t<Teller<Obs>::somebody_listens, Words, NoWords>;

  Step(Simplex<S>& simplex, Teller<Obs>& tell) : simplex_(simplex), tell_(tell) {}

  // -- Vectors --------------------------------------------------------------------------------------------------------

  auto AO() const {
    return to_origin_from(simplex_.point(Role::A), Rules::ZeroTest::size(simplex_[Role::A]), Told("AO"));
  }
  auto AB() const { return edge(Role::B); }
  auto AC() const { return edge(Role::C); }
  auto AD() const { return edge(Role::D); }

  /// AX. Requires: a vertex of that role other than A.
  auto edge(Role X) const {
    const Vec3<S>&P = simplex_.point(X), &A = simplex_.point(Role::A);
    Vec3<S> AX = P - A;
    const auto size = Rules::ZeroTest::size(AX);
    return Vector<S, std::remove_const_t<decltype(size)>, Told>{std::move(AX), size, Told(name_of_edge(X))};
  }

  int size() const { return simplex_.size(); }

  // -- Regions --------------------------------------------------------------------------------------------------------

  /// A region that needs no test.
  void skip(const Region& region, std::string_view reason) const {
    tell_([&] {
      auto event = tested(region);
      event.verdict = Verdict::skipped;
      event.reason = reason;
      return event;
    });
  }
  /// The region beyond A, which the report skips because of the crossing test, and only because of it.
  void skip_beyond_A(std::string_view label = {}) const {
    skip({.feature = "A", .label = label},
         by_crossing_test("were the origin beyond A, the move to A would not have reached it",
                          "only the crossing test rules this out, and this run does without it"));
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
    const bool found = Rules::is_at_origin(AO);
    tell_([&] {
      return compared_with_zero({.feature = "A"}, AO, found, "A is the origin", "the origin lies elsewhere");
    });
    return found;
  }

  template <class Vector>
  bool is_on_segment(const Vector& direction) const {
    const bool found = Rules::is_on_segment(direction);
    tell_([&] {
      auto event = compared_with_zero({.feature = "AB", .label = found ? "" : "R3 or R4"}, direction, found,
                                      by_crossing_test("the origin lies on AB", "the origin lies on the line AB"),
                                      "the origin lies to one side of AB");
      // Only AB×AO×AB is zero exactly there; a variant that looks at another vector concludes more than that says.
      if (event.expression != "AB×AO×AB")
        event.reason = event.expression + (direction.is_zero() ? " is zero" : " is not zero") +
                       ", from which these rules conclude: " + event.reason;
      return event;
    });
    return found;
  }

  template <class Height>
  Side side_of_triangle(const Height& ABCn_AO) const {
    const Side side = Rules::side_of_triangle(ABCn_AO);
    tell_([&] {
      auto event = tested({.feature = "ABC", .label = "R1"}, ABCn_AO);
      event.relation = relation_of(ABCn_AO.side());
      event.reason = words_for(ABCn_AO.side());
      if (side != ABCn_AO.side()) event.reason += as_if(words_for(side));
      return event;
    });
    return side;
  }

  /// Of a vector that leads from a vertex or an edge to the origin: whether the origin is there.
  template <class Vector>
  bool is_zero(const Region& region, const Vector& v) const {
    const bool found = v.is_zero();
    const std::string_view on = region.feature.size() == 1 ? "A is the origin" : "the origin lies on this edge";
    const std::string_view off = region.feature.size() == 1 ? "no edge leads from A toward the origin"
                                                            : "the point nearest to the origin lies on this edge";
    tell_([&] { return compared_with_zero(region, v, found, on, off); });
    return found;
  }

  /// A question of the complete rules, the answer to which the caller knows. `decides`: whether a yes settles it.
  template <class Height>
  void tell_question(const Region& region, const Height& X_AO, Relation asked, bool holds, bool decides,
                     std::string_view reason) const {
    tell_([&] {
      auto event = tested(region, X_AO);
      event.verdict = !holds ? Verdict::rejected : decides ? Verdict::chosen : Verdict::possible;
      event.relation = asked;
      event.reason = reason;
      return event;
    });
  }

  /// Algorithm 5: what is left where no face sees the origin.
  void lies_inside() const {
    tell_([&] {
      auto event = tested({.feature = "ABCD"});
      event.reason = "no face sees the origin: it lies in the tetrahedron";
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

  /// The last that is done in a step: it changes the simplex, in place. Where the kept one is returned, a query of two
  /// triangles takes 68 ns for 52, one of two tetrahedra 85 ns for 67 (GCC 12).
  template <class Direction>
  Next<S> keep(const Kept& kept, const Direction& direction) const {
    tell_([&] {
      SimplexReduced<S> event{.before = simplex_,
                              .after = simplex_.only(kept.order),
                              .kept = letters_of(kept.order),
                              .dropped = {},
                              .why = std::string(kept.why)};
      event.dropped = letters_beside(event.kept, simplex_.size());
      return event;
    });
    tell_direction(direction);
    simplex_ = simplex_.only(kept.order);
    return Next<S>::search_along(direction.value);
  }

 private:
  template <class Direction>
  void tell_direction(const Direction& d) const {
    tell_([&] { return DirectionChosen<S>{.expression = std::string(d.told.name), .direction = d.value}; });
  }

  RegionTested<S> tested(const Region& region) const {
    return {.simplex_size = simplex_.size(),
            .feature = std::string(region.feature),
            .label = std::string(region.label),
            .face = std::string(region.face),
            .verdict = Verdict::chosen,
            .reason = {}};
  }
  template <class Height>
  RegionTested<S> tested(const Region& region, const Height& n_AO) const {
    auto event = tested(region);
    event.expression = std::string(n_AO.X.told.name) + "·AO";
    event.formula = n_AO.X.told.formula.empty() ? n_AO.X.told.name : n_AO.X.told.formula;
    event.normal = n_AO.X.value;
    event.value = n_AO.value;
    return event;
  }
  template <class Vector>
  RegionTested<S> compared_with_zero(const Region& region, const Vector& v, bool found, std::string_view if_zero,
                                     std::string_view if_not) const {
    auto event = tested(region);
    event.expression = v.told.name;
    event.value = v.value;
    event.relation = v.is_zero() ? Relation::zero : Relation::not_zero;
    event.reason = v.is_zero() ? if_zero : if_not;
    if (found != v.is_zero()) event.reason += as_if(found ? if_zero : if_not);
    return event;
  }

  /// The sign test behind nearly all regions: does the origin lie on the side of A's feature that the normal n points to?
  template <class Height>
  bool tell_sight(const Region& region, const Height& n_AO, bool chosen) const {
    tell_([&] {
      const bool points_there = n_AO.is_positive();
      const std::string n(n_AO.X.told.name);
      const std::string if_so = n + " points toward the origin", if_not = n + " does not point toward the origin";
      auto event = tested(region, n_AO);
      event.verdict = chosen ? Verdict::chosen : Verdict::rejected;
      event.relation = chosen ? relation_of(n_AO.side()) : points_there ? Relation::negative : Relation::positive;
      event.reason = points_there ? if_so : if_not;
      if (chosen != points_there) event.reason += as_if(chosen ? if_so : if_not);
      return event;
    });
    return chosen;
  }

  /// For a variant that decides otherwise than its numbers say.
  static std::string as_if(std::string_view what) { return ", but these rules go on as if " + std::string(what); }

  static Relation relation_of(Side side) {
    switch (side) {
      case Side::in_plane: return Relation::zero;
      case Side::above: return Relation::positive;
      case Side::below: break;
    }
    return Relation::negative;
  }

  std::string_view words_for(Side side) const {
    switch (side) {
      case Side::in_plane: return by_crossing_test("the origin lies in the triangle", "the origin lies in its plane");
      case Side::above: return "the origin lies above the triangle, on the side of ABCn";
      case Side::below: return "the origin lies below the triangle, on the side of −ABCn";
    }
    return "";
  }

  /// Returns: what can be said with the crossing test (Eq. 9) on, or what is left of it when it is off.
  std::string_view by_crossing_test(std::string_view on, std::string_view off) const {
    return tell_.crossing_test() == CrossingTest::on ? on : off;
  }

  Simplex<S>& simplex_;
  Teller<Obs>& tell_;
};

}  // namespace detail
}  // namespace gjk
