/// Algorithms 2-5 of ARL-TR-7474. In which region of the simplex does the origin lie? What is kept, and where does the
/// search go next?
///
/// Naming. A is the newest vertex, then B, C, D (Role). AB = B - A, AO = -A. X×Y×Z is (X×Y)×Z. Normals point out of the
/// simplex: ABCn out of a tetrahedron, ABn out of a triangle across its edge AB.
///
/// The functions answer "where is the origin?" correctly only after the history that Algorithm 1 gives them. Each says
/// which history that is. They are not a closest-feature test for an arbitrary simplex.
#pragma once

#include "telling.hpp"

namespace gjk {

/// What Algorithm 1 does when it finds that the origin was not crossed (Eq. 9).
enum class NotCrossed { answer_at_once, process_the_simplex };

/// What Algorithm 1 does with the first point, which was found without a move that could have crossed the origin.
enum class FirstPoint { taken_as_it_is, tested };

/// The report's rules as its text means them: first Algorithms 2-5, then their details, each by its name. The details
/// are all that is easily got wrong.
///
/// A variant derives from this class and hides a detail, or one of the algorithms. Both are asked of Rules, the most
/// derived class. Values are told as they were computed. Relations and verdicts are told as the zero test has them.
template <class ZeroTest_ = ExactZeroTest>
struct Intended {
  using ZeroTest = ZeroTest_;

  /// Algorithm 2. Not a test for regions: a point has none. Called with the first vertex of the search.
  ///
  /// Outcomes: A is the origin → contained. Else keep A, search along AO.
  template <class Rules, class S, class Obs>
  static Next<S> process_0simplex(detail::Step<Rules, S, Obs> step) {
    const auto AO = step.AO();
    if (step.is_at_origin(AO)) return step.contains_origin();
    return step.keep_all(AO);
  }

  /// Algorithm 3. It does not test the ends of the segment. The origin cannot lie beyond them:
  ///  1. The last search started at B and went along BO. So the origin is not behind B (R1).
  ///  2. The move to A crossed the origin (Eq. 9). So the origin is not beyond A (R2).
  ///
  ///               R3
  ///      R1   B ────── A   R2
  ///               R4
  ///
  /// Outcomes, in this order:
  ///  - (AB×AO)×AB = 0: the origin is A, or lies on AB → contained.
  ///  - Else R3 or R4, one expression for both → keep both, search along (AB×AO)×AB.
  ///
  /// AO itself would not do as search direction: it may return B, then A, then B again.
  template <class Rules, class S, class Obs>
  static Next<S> process_1simplex(detail::Step<Rules, S, Obs> step) {
    const auto AO = step.AO();
    const auto AB = step.AB();
    step.skip({.feature = "B"}, RegionReason::left_behind);  // R1
    step.skip_beyond_A();                                    // R2
    const auto direction = Rules::from_segment(AB, AO);
    if (step.is_on_segment(direction)) return step.contains_origin();
    return step.keep_all(direction);
  }

  /// Algorithm 4. It does not test the far side of BC, nor the corners:
  ///  1. The last search started at BC, whose ends had been ruled out, and went toward the origin. So the origin is not
  ///     in R4, R5, R6.
  ///  2. The move to A crossed the origin (Eq. 9). So the origin is not in R2.
  ///
  ///              R2
  ///               A
  ///         R3  /   \  R7
  ///            / R1  \           seen from the side that ABCn points to,
  ///       R4  B ───── C  R6      R1 reaching above and below the paper
  ///              R5
  ///
  /// Outcomes, in this order:
  ///  - R3 → keep [B, A].
  ///  - R7 → keep [C, A].
  ///  - Else R1, in the plane → contained.
  ///  - R1, above → keep all, search along ABCn.
  ///  - R1, below → search along −ABCn and swap A and B. Then BC×BD of the next simplex points to its A.
  template <class Rules, class S, class Obs>
  static Next<S> process_2simplex(detail::Step<Rules, S, Obs> step) {
    const auto AO = step.AO();
    const auto AB = step.AB(), AC = step.AC();
    const auto ABCn = Rules::ABCn_of_triangle(AB, AC).named(NamedVector::normal("ABC"));  // Eq. 10
    const auto ABn = Rules::ABn_of_triangle(AB, ABCn).named(NamedVector::normal("AB"));   // Eq. 11
    const auto ACn = Rules::ACn_of_triangle(AC, ABCn).named(NamedVector::normal("AC"));
    step.skip({.feature = "B"}, RegionReason::ruled_out_before);  // R4
    step.skip({.feature = "BC"}, RegionReason::left_behind);      // R5
    step.skip({.feature = "C"}, RegionReason::ruled_out_before);  // R6
    step.skip_beyond_A();                                         // R2
    if (step.is_beyond_edge({.feature = "AB"}, ABn.dot(AO)))      // R3
      return Rules::keep_edge(step, Role::B, AB, ABn);
    if (step.is_beyond_edge({.feature = "AC"}, ACn.dot(AO)))  // R7
      return Rules::keep_edge(step, Role::C, AC, ACn);
    switch (step.side_of_triangle(ABCn.dot(AO))) {
      case Side::in_plane: return step.contains_origin();
      case Side::above: return step.keep_all(ABCn);
      case Side::below: break;
    }
    return step.keep(Rules::kept_below_triangle(), -ABCn);
  }

  /// Algorithm 5. It is not a closest-feature test: the first face that sees the origin is taken. Seven features lie on
  /// the side from which the last search came. The crossing test rules out A. What is left are the three faces that
  /// meet A, their edges, and the inside.
  ///
  /// Requires (Section 3.2.4): A lies in the direction BC×BD. Then the normals of Eq. 14 point outward.
  ///
  ///            A
  ///          ⟋ │ ⟍          BCD lies on the ground, counter-clockwise seen from above;
  ///        B ──┼── D        C is in front
  ///          ⟍ │ ⟋
  ///            C
  ///
  /// Outcomes: those of process_face, per face, in the order ABC, ACD, ADB. No face sees the origin → contained.
  template <class Rules, class S, class Obs>
  static Next<S> process_3simplex(detail::Step<Rules, S, Obs> step) {
    const auto AO = step.AO();
    const auto AB = step.AB(), AC = step.AC(), AD = step.AD();
    for (const Roles& feature : {Roles("B"), Roles("C"), Roles("D"), Roles("BC"), Roles("CD"), Roles("DB")})
      step.skip({.feature = feature}, RegionReason::ruled_out_before);
    step.skip({.feature = "BCD"}, RegionReason::left_behind);
    step.skip_beyond_A();
    const auto ABCn = Rules::ABCn(AB, AC).named(NamedVector::normal("ABC"));  // Eq. 14, as are ACDn and ADBn
    if (step.is_above_face({.feature = "ABC"}, ABCn.dot(AO)))
      return Rules::process_face(step, Face::ABC, ABCn, AB, AC, ABCn, ABCn);
    const auto ACDn = Rules::ACDn(AC, AD).named(NamedVector::normal("ACD"));
    if (step.is_above_face({.feature = "ACD"}, ACDn.dot(AO)))
      return Rules::process_face(step, Face::ACD, ACDn, AC, AD, ABCn, ABCn);
    const auto ADBn = Rules::ADBn(AD, AB).named(NamedVector::normal("ADB"));
    if (step.is_above_face({.feature = "ADB"}, ADBn.dot(AO)))
      return Rules::process_face(step, Face::ADB, ADBn, AD, AB, ABCn, ACDn);
    step.lies_inside();
    return step.contains_origin();
  }

  // -- Details of Algorithm 1 -----------------------------------------------------------------------------------------

  /// Section 3.1.3: "the origin is not located within Mdiff. GJK can report no intersection for this case."
  static constexpr NotCrossed not_crossed() { return NotCrossed::answer_at_once; }

  static constexpr FirstPoint first_point() { return FirstPoint::taken_as_it_is; }

  /// Eq. 8.
  template <class S, class A, class B>
  static MinkowskiDifference<S, A, B> difference(const A& a, const B& b) {
    return {a, b};
  }

  /// Eq. 9 for the vertex w found along d. Beside a positive w·d, these count as crossed:
  ///  - Touching the origin, since it proves nothing.
  ///  - A value that the zero test cannot tell from zero. Else sets that touch would be found apart here, before
  ///    Algorithms 2-5 could find them touching.
  ///  - A value that is not a number.
  static bool crossed(const auto& w_d) { return !w_d.is_negative(); }

  // -- Where the origin is --------------------------------------------------------------------------------------------

  static bool is_at_origin(const auto& AO) { return AO.is_zero(); }
  static bool is_on_segment(const auto& direction) { return direction.is_zero(); }
  /// What is not a number is not beyond an edge, and no face sees it. A segment or triangle is then kept whole. A
  /// tetrahedron is taken to contain the origin. Only finite products give answers that mean something.
  static bool is_beyond_edge(const auto& AXn_AO) { return AXn_AO.is_positive(); }
  /// What is not a number is below: the search goes on, and ends as soon as it sees that direction.
  static Side side_of_triangle(const auto& ABCn_AO) { return ABCn_AO.side(); }
  static bool is_above_face(const auto& APQn_AO) { return APQn_AO.is_positive(); }

  // -- Normals: Eqs. 10, 11 and 14 ------------------------------------------------------------------------------------

  static auto ABCn_of_triangle(const auto& AB, const auto& AC) { return AB.cross(AC); }
  static auto ABn_of_triangle(const auto& AB, const auto& ABCn) { return AB.cross(ABCn); }
  static auto ACn_of_triangle(const auto& AC, const auto& ABCn) { return ABCn.cross(AC); }

  static auto ABCn(const auto& AB, const auto& AC) { return AB.cross(AC); }
  static auto ACDn(const auto& AC, const auto& AD) { return AC.cross(AD); }
  static auto ADBn(const auto& AD, const auto& AB) { return AD.cross(AB); }

  /// Normals of the edges of a face APQ of the tetrahedron. They belong to the face: ACn of ABC is not ACn of ACD
  /// (Section 3.2.4). `earlier`: the normal of the face looked at before that has the edge, too, if there is one. It
  /// has no part in the formula.
  static auto AQn(Face, const auto& AQ, const auto& APQn, const auto& /*earlier*/) { return APQn.cross(AQ); }
  static auto APn(Face, const auto& AP, const auto& APQn, const auto& /*earlier*/) { return AP.cross(APQn); }

  // -- What to keep, and where to search ------------------------------------------------------------------------------

  static auto from_segment(const auto& AB, const auto& AO) { return detail::triple(AB, AO); }
  /// From the edge AX of a triangle or tetrahedron. Not along AXn, the edge's normal in the plane of its face: the
  /// origin may lie above or below that plane (Section 3.2.3).
  static auto from_edge(const auto& AX, const auto& AO, const auto& /*AXn*/) { return detail::triple(AX, AO); }

  static constexpr Kept kept_below_triangle() { return {"CAB", ReductionReason::turned_below_triangle}; }
  /// [Q, P, A]: in the next simplex Q, P, A have become D, C, B, and BC×BD is APQn again.
  static constexpr Kept kept_above(Face face) {
    const detail::FaceRoles roles = detail::roles_of(face);
    return {{roles.Q, roles.P, Role::A}, ReductionReason::face_keeps_normal};
  }

  // -- Parts of Algorithms 4 and 5 ------------------------------------------------------------------------------------

  /// The origin lies beyond the edge from A to X: Simplex([X, A]), searched along (AX×AO)×AX.
  template <class Rules, class S, class Obs>
  static Next<S> keep_edge(detail::Step<Rules, S, Obs> step, Role X, const auto& AX, const auto& AXn) {
    return step.keep({{X, Role::A}, ReductionReason::beyond_edge}, Rules::from_edge(AX, step.AO(), AXn));
  }

  /// The origin lies above the face APQ, whose outward normal is APQn = AP×AQ. The vertex off the face is dropped. AQn
  /// and APn are also given the normals of faces that were looked at before and share the edge. Where there is none,
  /// ABCn fills the place.
  ///
  /// Outcomes: beyond AQ → keep [Q, A]. Beyond AP → keep [P, A]. Else keep the face, search along APQn.
  template <class Rules, class S, class Obs>
  static Next<S> process_face(detail::Step<Rules, S, Obs> step, Face face, const auto& APQn, const auto& AP,
                              const auto& AQ, const auto& earlier_with_AQ, const auto& earlier_with_AP) {
    const auto AO = step.AO();
    const detail::FaceRoles roles = detail::roles_of(face);
    const auto AQn = Rules::AQn(face, AQ, APQn, earlier_with_AQ).as_normal_of(AQ);
    const auto APn = Rules::APn(face, AP, APQn, earlier_with_AP).as_normal_of(AP);
    if (step.is_beyond_edge({.feature = {Role::A, roles.Q}, .face = roles.face()}, AQn.dot(AO)))
      return Rules::keep_edge(step, roles.Q, AQ, AQn);
    if (step.is_beyond_edge({.feature = {Role::A, roles.P}, .face = roles.face()}, APn.dot(AO)))
      return Rules::keep_edge(step, roles.P, AP, APn);
    return step.keep(Rules::kept_above(face), APQn);
  }
};

/// Algorithm 1 read literally. After it has found P·dir < 0, it adds the vertex and processes the simplex. Then
/// contains_origin() may overwrite the answer.
///
/// This is wrong. For two balls side by side the same vertex comes back, and the segment AB has no length. Then
/// (AB×AO)×AB = 0 reads as "the origin lies on AB".
template <class ZeroTest = ExactZeroTest>
struct Printed : Intended<ZeroTest> {
  static constexpr NotCrossed not_crossed() { return NotCrossed::process_the_simplex; }
};

/// A faster variant that the report does not have: w·d < 0 proves at the first point, too, that the sets are apart. It
/// is worth having where the first direction is a good guess, such as first_direction_between(). tests/bench/peers
/// measures it.
template <class ZeroTest = ExactZeroTest>
struct Eager : Intended<ZeroTest> {
  static constexpr FirstPoint first_point() { return FirstPoint::tested; }
};

using AsIntended = Intended<>;
using AsPrinted = Printed<>;

}  // namespace gjk
