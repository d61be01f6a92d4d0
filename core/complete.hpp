/// Rules that reduce the simplex to its feature nearest to the origin. Because of history they skip only what one step
/// proves. They ask beyond the report's rules exactly what those save. These rules cannot go round in a cycle, but for
/// rounding.
#pragma once

#include <array>

#include "nearest.hpp"
#include "rules.hpp"

namespace gjk {

namespace detail {

/// AP×AQ of the face APQ.
auto normal_of(const auto& step, Face face) {
  const FaceRoles roles = roles_of(face);
  return step.edge(roles.P).cross(step.edge(roles.Q)).named(NamedVector::normal(roles.face()));
}

constexpr Face face_with(Role X, Role Y) {
  const auto is = [=](Role one, Role other) { return (X == one && Y == other) || (X == other && Y == one); };
  return is(Role::B, Role::C) ? Face::ABC : is(Role::C, Role::D) ? Face::ACD : Face::ADB;
}

/// What nearest_with_A() wants to know of a simplex, in numbers of S. Each answer is computed and told once.
///
/// Requires of triangles and tetrahedra: their normals point away from what is left behind (P4, P5 of gjk.hpp). The
/// orders of the report's rules take care of that.
template <class Step>
class Nearness {
 public:
  explicit Nearness(const Step& step) : step_(step) {}

  /// AX·AO > 0: the origin lies on the side of X of the plane through A across AX.
  bool is_toward(Role X) const {
    const auto AX = step_.edge(X);
    const auto AX_AO = AX.dot(step_.AO());
    const bool toward = AX_AO.is_positive();
    toward_[index(X)] = toward;
    step_.tell_question({.feature = {Role::A, X}}, AX_AO, Relation::positive, toward, false,
                        toward ? RegionReason::nearer_along_edge : RegionReason::no_nearer_along_edge);
    return toward;
  }

  /// AXn·AO >= 0, AXn being the normal of the edge AX in the plane of AX and AY.
  bool is_beyond(Role X, Role Y) const {
    std::optional<bool>& known = beyond_[index(X)][index(Y)];
    if (known) return *known;
    const auto AX = step_.edge(X);
    const auto APQn = normal_of(step_, face_with(X, Y));
    const bool is_first = X == roles_of(face_with(X, Y)).P;
    return *(known = tell_beyond(X, Y, (is_first ? AX.cross(APQn) : APQn.cross(AX)).as_normal_of(AX)));
  }

  /// APQn·AO > 0, X, Y being P, Q.
  bool is_above(Role X, Role Y, Role) const {
    const Face face = face_with(X, Y);
    const auto APQn_AO = normal_of(step_, face).dot(step_.AO());
    const bool above = APQn_AO.is_positive();
    step_.tell_question({.feature = roles_of(face).face()}, APQn_AO, Relation::positive, above, true,
                        above ? RegionReason::above_face_within_edges : RegionReason::not_above_face);
    return above;
  }

 private:
  static std::size_t index(Role X) { return static_cast<std::size_t>(X); }

  bool tell_beyond(Role X, Role Y, const auto& AXn) const {
    const auto AXn_AO = AXn.dot(step_.AO());
    const bool beyond = !AXn_AO.is_negative();
    const Roles face = step_.size() == 4 ? roles_of(face_with(X, Y)).face() : Roles();
    step_.tell_question({.feature = {Role::A, X}, .face = face}, AXn_AO, Relation::not_negative, beyond,
                        is_settled(X, Y),
                        beyond ? RegionReason::beyond_edge_in_plane : RegionReason::within_edge_in_plane);
    return beyond;
  }

  /// Returns: whether nothing else is to be asked of the edge AX, once the origin is beyond it in the plane of AX and
  /// AY.
  bool is_settled(Role X, Role Y) const {
    if (!toward_[index(X)]) return false;
    for (const Role Z : {Role::B, Role::C, Role::D})
      if (Z != X && Z != Y && static_cast<int>(Z) < step_.size() && beyond_[index(X)][index(Z)] != true) return false;
    return true;
  }

  const Step& step_;
  mutable std::array<bool, 4> toward_{};
  mutable std::array<std::array<std::optional<bool>, 4>, 4> beyond_{};
};

}  // namespace detail

/// Tests all regions in which the point nearest to the origin can be, A's among them. nearest.hpp says which regions
/// need no test. In exact numbers each step brings the simplex nearer to the origin. So none comes back, and the search
/// ends.
template <class ZeroTest = ExactZeroTest>
struct Complete : Intended<ZeroTest> {
  template <class Rules, class S, class Obs>
  static Next<S> process_1simplex(detail::Step<Rules, S, Obs> step) {
    step.skip({.feature = "B"}, RegionReason::nearer_with_A);
    return keep_nearest(step);
  }

  template <class Rules, class S, class Obs>
  static Next<S> process_2simplex(detail::Step<Rules, S, Obs> step) {
    step.skip({.feature = "B"}, RegionReason::nearer_with_A);
    step.skip({.feature = "BC"}, RegionReason::nearer_with_A);
    step.skip({.feature = "C"}, RegionReason::nearer_with_A);
    return keep_nearest(step);
  }

  template <class Rules, class S, class Obs>
  static Next<S> process_3simplex(detail::Step<Rules, S, Obs> step) {
    for (const Roles& feature :
         {Roles("B"), Roles("C"), Roles("D"), Roles("BC"), Roles("CD"), Roles("DB"), Roles("BCD")})
      step.skip({.feature = feature}, RegionReason::nearer_with_A);
    return keep_nearest(step);
  }

 private:
  template <class Rules, class S, class Obs>
  static Next<S> keep_nearest(const detail::Step<Rules, S, Obs>& step) {
    const Roles kept = detail::nearest_with_A(detail::Nearness(step), step.size());
    switch (kept.size()) {
      case 1: return keep_A(step);
      case 2: return keep_edge(step, kept[0]);
      case 3: return step.size() == 3 ? keep_triangle(step) : keep_face(step, kept[0], kept[1]);
      default: return step.lies_inside(), step.contains_origin();
    }
  }

  static auto keep_A(const auto& step) {
    const auto AO = step.AO();
    if (step.is_zero({.feature = "A"}, AO)) return step.contains_origin();
    return step.keep({"A", ReductionReason::nearest_is_A}, AO);
  }

  static auto keep_edge(const auto& step, Role X) {
    const auto AX = step.edge(X);
    const auto direction = detail::triple(AX, step.AO());
    const bool is_segment = step.size() == 2;
    if (is_segment ? step.is_on_segment(direction) : step.is_zero({.feature = {Role::A, X}}, direction))
      return step.contains_origin();
    if (is_segment) return step.keep_all(direction);
    return step.keep({{X, Role::A}, ReductionReason::nearest_on_edge}, direction);
  }

  static auto keep_triangle(const auto& step) {
    const auto ABCn = detail::normal_of(step, Face::ABC);
    switch (step.side_of_triangle(ABCn.dot(step.AO()))) {
      case Side::in_plane: return step.contains_origin();
      case Side::above: return step.keep_all(ABCn);
      case Side::below: break;
    }
    return step.keep(Complete::kept_below_triangle(), -ABCn);
  }

  static auto keep_face(const auto& step, Role Q, Role P) {
    const Face face = detail::face_with(P, Q);
    return step.keep(Complete::kept_above(face), detail::normal_of(step, face));
  }
};

}  // namespace gjk
