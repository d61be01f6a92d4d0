/// Algorithms 2-5 of ARL-TR-7474: in which region of the simplex does the origin lie, what is kept, where to search next.
///
/// Naming. A is the newest vertex, then B, C, D (Role). AB = B - A, AO = -A. X×Y×Z is (X×Y)×Z. Normals point out of the
/// simplex: ABCn out of a tetrahedron, ABn out of a triangle across its edge AB.
///
/// The functions answer "where is the origin?" correctly only after the history that Algorithm 1 gives them; each
/// says which. They are not a closest-feature test for an arbitrary simplex.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "events.hpp"
#include "zero_test.hpp"

namespace gjk {

/// What Algorithms 2-5 return: where to search next; empty exactly when the simplex contains the origin. As in the
/// report, those that drop vertices do so in the simplex they are given.
template <class S>
using Next = std::optional<Vec3<S>>;

// -- Vectors ----------------------------------------------------------------------------------------------------------

template <class S>
bool is_zero(const Vec3<S>& v) {
  return v.x() == S(0) && v.y() == S(0) && v.z() == S(0);
}

/// Returns: X×Y×X, the part of Y perpendicular to X, |X|² times as long.
template <class S>
Vec3<S> triple(const Vec3<S>& X, const Vec3<S>& Y) {
  return X.cross(Y).cross(X);
}

// -- Telling ----------------------------------------------------------------------------------------------------------

/// The words for one region: feature "AB", label "R3", normal "ABn", its formula "AB×ABCn", and the face it is an edge of.
struct RegionWords {
  std::string_view feature, label, normal, formula, face = {};
};

/// The sign test behind nearly all regions: does the origin lie on the side of A's feature that `normal` points to?
/// `sides`: the factors of the normal, of which the zero test needs to know.
template <class ZeroTest, class S, class Obs, class... Sides>
bool sees_origin(const Vec3<S>& normal, const Simplex<S>& simplex, const RegionWords& words, Teller<Obs>& tell,
                 const Sides&... sides) {
  const S value = -normal.dot(simplex.point(Role::A));
  const bool chosen = ZeroTest::snap(value, simplex[Role::A], sides...) > S(0);
  tell([&] {
    const std::string where =
        std::string(words.normal) + (chosen ? " points" : " does not point") + " toward the origin";
    return RegionTested<S>{.simplex_size = simplex.size(),
                           .feature = std::string(words.feature),
                           .label = std::string(words.label),
                           .face = std::string(words.face),
                           .expression = std::string(words.normal) + "·AO",
                           .formula = std::string(words.formula),
                           .normal = normal,
                           .value = value,
                           .relation = Relation::positive,
                           .verdict = chosen ? Verdict::chosen : Verdict::rejected,
                           .reason = where};
  });
  return chosen;
}

/// Tells of a region that needs no test.
template <class S, class Obs>
void skip(const Simplex<S>& simplex, std::string_view feature, std::string_view label, std::string_view reason,
          Teller<Obs>& tell) {
  tell([&] {
    return RegionTested<S>{.simplex_size = simplex.size(),
                           .feature = std::string(feature),
                           .label = std::string(label),
                           .verdict = Verdict::skipped,
                           .reason = std::string(reason)};
  });
}

/// Returns: what can be said with the crossing test (Eq. 9) on, or what is left of it when it is off.
template <class Obs>
std::string_view by_crossing_test(const Teller<Obs>& tell, std::string_view on, std::string_view off) {
  return tell.crossing_test() == CrossingTest::on ? on : off;
}

/// Tells of the region beyond A, which the report skips because of the crossing test, and only because of it.
template <class S, class Obs>
void skip_beyond_A(const Simplex<S>& simplex, std::string_view label, Teller<Obs>& tell) {
  skip(simplex, "A", label,
       by_crossing_test(tell, "the move to A reached the origin or crossed it, so the origin is not beyond A",
                        "only the crossing test rules this out, and this run does without it"),
       tell);
}

/// Keeps the vertices of these roles, in this order (oldest first), and searches along `direction`. References to points of
/// the simplex mean other vertices afterwards.
template <class S, class Obs>
Next<S> keep(Simplex<S>& simplex, std::initializer_list<Role> roles, std::string_view why, const Vec3<S>& direction,
             std::string_view expression, Teller<Obs>& tell) {
  const Simplex<S> kept = simplex.only(roles);
  tell([&] {
    SimplexReduced<S> event{.before = simplex, .after = kept, .kept = {}, .dropped = {}, .why = std::string(why)};
    for (const Role role : roles) event.kept += letter(role);
    for (int i = 0; i < simplex.size(); ++i) {
      const char name = letter(static_cast<Role>(simplex.size() - 1 - i));
      if (event.kept.find(name) == std::string::npos) event.dropped += name;
    }
    return event;
  });
  tell([&] { return DirectionChosen<S>{.expression = std::string(expression), .direction = direction}; });
  simplex = kept;
  return direction;
}

/// Keeps the whole simplex as it is.
template <class S, class Obs>
Next<S> keep_all(const Vec3<S>& direction, std::string_view expression, Teller<Obs>& tell) {
  tell([&] { return DirectionChosen<S>{.expression = std::string(expression), .direction = direction}; });
  return direction;
}

/// The origin lies beyond the edge from A to `other`: Simplex([other, A]), searched along AX×AO×AX. The direction is
/// not the edge's normal in the plane of a triangle: the origin may lie above or below that plane (Section 3.2.3).
template <class S, class Obs>
Next<S> keep_edge(Simplex<S>& simplex, Role other, Teller<Obs>& tell) {
  const Vec3<S> AX = simplex.point(other) - simplex.point(Role::A), AO = -simplex.point(Role::A);
  constexpr std::string_view expressions[] = {"", "AB×AO×AB", "AC×AO×AC", "AD×AO×AD"};
  return keep(simplex, {other, Role::A}, "the origin lies beyond this edge; A stays the newest", triple(AX, AO),
              expressions[static_cast<int>(other)], tell);
}

// -- Algorithm 5's faces ----------------------------------------------------------------------------------------------

/// One face APQ of the tetrahedron that meets A, with the words for the face and for its two edges, in the order in
/// which Algorithm 5 looks at them. The edge normals belong to the face: ACn of ABC is not ACn of ACD (Section 3.2.4).
struct Face {
  Role P, Q;  ///< AP×AQ points out of the tetrahedron
  RegionWords words, edge_AQ, edge_AP;
};

inline constexpr Face face_ABC{.P = Role::B,
                               .Q = Role::C,
                               .words = {"ABC", "", "ABCn", "AB×AC"},
                               .edge_AQ = {"AC", "", "ACn", "ABCn×AC", "ABC"},
                               .edge_AP = {"AB", "", "ABn", "AB×ABCn", "ABC"}};
inline constexpr Face face_ACD{.P = Role::C,
                               .Q = Role::D,
                               .words = {"ACD", "", "ACDn", "AC×AD"},
                               .edge_AQ = {"AD", "", "ADn", "ACDn×AD", "ACD"},
                               .edge_AP = {"AC", "", "ACn", "AC×ACDn", "ACD"}};
inline constexpr Face face_ADB{.P = Role::D,
                               .Q = Role::B,
                               .words = {"ADB", "", "ADBn", "AD×AB"},
                               .edge_AQ = {"AB", "", "ABn", "ADBn×AB", "ADB"},
                               .edge_AP = {"AD", "", "ADn", "AD×ADBn", "ADB"}};

// -- The rules --------------------------------------------------------------------------------------------------------

/// What Algorithm 1 does when it finds that the origin was not crossed (Eq. 9).
enum class NotCrossed { answer_at_once, process_the_simplex };

/// What Algorithm 1 does with the first point, which was found without a move that could have crossed the origin.
enum class FirstPoint { taken_as_it_is, tested };

/// The report's rules as its text means them. A variant derives from this class and hides one of its functions; it may
/// build on the protected parts. Values are told as they were computed, relations and verdicts as the zero test has them.
template <class ZeroTest = ExactZeroTest>
struct Intended {
  /// Section 3.1.3: "the origin is not located within Mdiff. GJK can report no intersection for this case."
  static constexpr NotCrossed not_crossed() { return NotCrossed::answer_at_once; }

  static constexpr FirstPoint first_point() { return FirstPoint::taken_as_it_is; }

  /// Eq. 9 for the vertex found along `direction`, with `value` = w·d. Touching the origin proves nothing, so it counts as
  /// crossed; and so does a value that the zero test cannot tell from zero, or sets that touch would be found apart here
  /// before Algorithms 2-5 could find them touching.
  template <class S>
  static bool crossed(const S& value, const Vertex<S>& vertex, const Vec3<S>& direction) {
    return !(ZeroTest::snap(value, vertex, direction) < S(0));
  }

  /// Algorithm 2. Not a test for regions: a point has none. Called with the first vertex of the search.
  ///
  /// Outcomes: A is the origin → contained. Else keep A, search along AO.
  template <class S, class Obs>
  static Next<S> process_0simplex(const Simplex<S>& simplex, Teller<Obs>& tell) {
    const Vec3<S> AO = -simplex.point(Role::A);
    const bool at_origin = is_zero(ZeroTest::snap(AO, simplex[Role::A]));
    tell([&] {
      return RegionTested<S>{.simplex_size = 1,
                             .feature = "A",
                             .expression = "AO",
                             .value = AO,
                             .relation = at_origin ? Relation::zero : Relation::not_zero,
                             .verdict = Verdict::chosen,
                             .reason = at_origin ? "A is the origin" : "the origin lies elsewhere"};
    });
    if (at_origin) return std::nullopt;
    return keep_all(AO, "AO", tell);
  }

  /// Algorithm 3. Not a test for the ends of the segment: the origin cannot lie beyond them, because
  ///  1. the last search started at B and went along BO, so the origin is not behind B (R1);
  ///  2. the move to A crossed the origin (Eq. 9), so the origin is not beyond A (R2).
  ///
  ///               R3
  ///      R1   B ────── A   R2
  ///               R4
  ///
  /// Outcomes: AB×AO×AB = 0 (the origin is A, or lies on AB) → contained. Else (R3 or R4, one expression for both) keep
  /// both, search along AB×AO×AB. AO itself would not do: it may return B, then A, then B again.
  template <class S, class Obs>
  static Next<S> process_1simplex(const Simplex<S>& simplex, Teller<Obs>& tell) {
    const Vec3<S> AO = -simplex.point(Role::A);
    const Vec3<S> AB = simplex.point(Role::B) - simplex.point(Role::A);
    skip(simplex, "B", "R1", "the search has just moved away from B, toward the origin", tell);
    skip_beyond_A(simplex, "R2", tell);
    const Vec3<S> direction = triple(AB, AO);
    const bool on_segment = is_zero(ZeroTest::snap(direction, simplex[Role::A], AB, AB));
    tell([&] {
      return RegionTested<S>{.simplex_size = 2,
                             .feature = "AB",
                             .label = on_segment ? "" : "R3 or R4",
                             .expression = "AB×AO×AB",
                             .value = direction,
                             .relation = on_segment ? Relation::zero : Relation::not_zero,
                             .verdict = Verdict::chosen,
                             .reason = std::string(on_segment ? by_crossing_test(tell, "the origin lies on AB",
                                                                                 "the origin lies on the line AB")
                                                              : "the origin lies to one side of AB")};
    });
    if (on_segment) return std::nullopt;
    return keep_all(direction, "AB×AO×AB", tell);
  }

  /// Algorithm 4. Not a test for the far side of BC or for the corners, because
  ///  1. the last search started at BC and went toward the origin: it is not in R4, R5, R6;
  ///  2. the move to A crossed the origin (Eq. 9): it is not in R2.
  ///
  ///              R2
  ///               A
  ///         R3  /   \  R7
  ///            / R1  \           seen from the side that ABCn points to,
  ///       R4  B ───── C  R6      R1 reaching above and below the paper
  ///              R5
  ///
  /// Outcomes: R3 → keep [B, A]. R7 → keep [C, A]. Else R1: in the plane → contained; above → keep all, search along
  /// ABCn; below → search along −ABCn and swap A and B, so that BC×BD of the next simplex points to its A.
  template <class S, class Obs>
  static Next<S> process_2simplex(Simplex<S>& simplex, Teller<Obs>& tell) {
    const Vec3<S>&A = simplex.point(Role::A), &B = simplex.point(Role::B), &C = simplex.point(Role::C);
    const Vec3<S> AB = B - A, AC = C - A;
    const Vec3<S> ABCn = AB.cross(AC);                         // Eq. 10
    const Vec3<S> ABn = AB.cross(ABCn), ACn = ABCn.cross(AC);  // Eq. 11
    skip(simplex, "B", "R4", "the search has just moved away from BC, toward the origin", tell);
    skip(simplex, "BC", "R5", "the search has just moved away from BC, toward the origin", tell);
    skip(simplex, "C", "R6", "the search has just moved away from BC, toward the origin", tell);
    skip_beyond_A(simplex, "R2", tell);
    if (sees_origin<ZeroTest>(ABn, simplex, {"AB", "R3", "ABn", "AB×ABCn"}, tell, AB, AB, AC))
      return keep_edge(simplex, Role::B, tell);
    if (sees_origin<ZeroTest>(ACn, simplex, {"AC", "R7", "ACn", "ABCn×AC"}, tell, AC, AC, AB))
      return keep_edge(simplex, Role::C, tell);
    return process_inside_triangle(simplex, ABCn, AB, AC, tell);
  }

  /// Algorithm 5. Not a closest-feature test: the first face that sees the origin is taken. Seven features lie on the
  /// side from which the last search came and A is ruled out by the crossing test; what is left are the three faces
  /// that meet A, their edges, and the inside.
  ///
  /// Requires (Section 3.2.4): A lies in the direction BC×BD. Then the normals of Eq. 14 point outward.
  ///
  ///            A
  ///          ⟋ │ ⟍          BCD lies on the ground, counter-clockwise seen from above;
  ///        B ──┼── D        C is in front
  ///          ⟍ │ ⟋
  ///            C
  ///
  /// Outcomes: per face, in the order ABC, ACD, ADB: see process_face. No face sees the origin → contained.
  template <class S, class Obs>
  static Next<S> process_3simplex(Simplex<S>& simplex, Teller<Obs>& tell) {
    const Vec3<S>& A = simplex.point(Role::A);
    const Vec3<S> AB = simplex.point(Role::B) - A, AC = simplex.point(Role::C) - A, AD = simplex.point(Role::D) - A;
    for (const std::string_view feature : {"B", "C", "D", "BC", "CD", "DB", "BCD"})
      skip(simplex, feature, "", "the search has just moved away from BCD, toward the origin", tell);
    skip_beyond_A(simplex, "", tell);
    const Vec3<S> ABCn = AB.cross(AC);  // Eq. 14, as are ACDn and ADBn
    if (sees_origin<ZeroTest>(ABCn, simplex, face_ABC.words, tell, AB, AC))
      return process_face(simplex, face_ABC, ABCn, AB, AC, tell);
    const Vec3<S> ACDn = AC.cross(AD);
    if (sees_origin<ZeroTest>(ACDn, simplex, face_ACD.words, tell, AC, AD))
      return process_face(simplex, face_ACD, ACDn, AC, AD, tell);
    const Vec3<S> ADBn = AD.cross(AB);
    if (sees_origin<ZeroTest>(ADBn, simplex, face_ADB.words, tell, AD, AB))
      return process_face(simplex, face_ADB, ADBn, AD, AB, tell);
    tell([&] {
      return RegionTested<S>{.simplex_size = 4,
                             .feature = "ABCD",
                             .verdict = Verdict::chosen,
                             .reason = "no face sees the origin: it lies in the tetrahedron"};
    });
    return std::nullopt;
  }

 protected:
  /// R1 of Algorithm 4: the origin lies in the prism above and below the triangle.
  template <class S, class Obs>
  static Next<S> process_inside_triangle(Simplex<S>& simplex, const Vec3<S>& ABCn, const Vec3<S>& AB, const Vec3<S>& AC,
                                         Teller<Obs>& tell) {
    const S value = -ABCn.dot(simplex.point(Role::A));
    const S v = ZeroTest::snap(value, simplex[Role::A], AB, AC);
    tell([&] {
      return RegionTested<S>{
          .simplex_size = 3,
          .feature = "ABC",
          .label = "R1",
          .expression = "ABCn·AO",
          .formula = "AB×AC",
          .normal = ABCn,
          .value = value,
          .relation = v == S(0)  ? Relation::zero
                      : v > S(0) ? Relation::positive
                                 : Relation::negative,
          .verdict = Verdict::chosen,
          .reason = std::string(
              v == S(0)  ? by_crossing_test(tell, "the origin lies in the triangle", "the origin lies in its plane")
              : v > S(0) ? "the origin lies above the triangle, on the side of ABCn"
                         : "the origin lies below the triangle, on the side of −ABCn")};
    });
    if (v == S(0)) return std::nullopt;
    if (v > S(0)) return keep_all(ABCn, "ABCn", tell);
    return keep(simplex, {Role::C, Role::A, Role::B},
                "A and B change places, so that the triangle's normal will point to the next vertex", Vec3<S>(-ABCn),
                "−ABCn", tell);
  }

  /// The origin lies above the face APQ, whose outward normal is APQn = AP×AQ. The vertex off the face is dropped.
  ///
  /// Outcomes: beyond AQ → keep [Q, A]. Beyond AP → keep [P, A]. Else keep [Q, P, A], search along APQn: in the next
  /// simplex Q, P, A have become D, C, B, and BC×BD is APQn again.
  template <class S, class Obs>
  static Next<S> process_face(Simplex<S>& simplex, const Face& face, const Vec3<S>& APQn, const Vec3<S>& AP,
                              const Vec3<S>& AQ, Teller<Obs>& tell) {
    const Vec3<S> AQn = APQn.cross(AQ), APn = AP.cross(APQn);
    if (sees_origin<ZeroTest>(AQn, simplex, face.edge_AQ, tell, AQ, AQ, AP)) return keep_edge(simplex, face.Q, tell);
    if (sees_origin<ZeroTest>(APn, simplex, face.edge_AP, tell, AP, AP, AQ)) return keep_edge(simplex, face.P, tell);
    return keep(simplex, {face.Q, face.P, Role::A}, "in this order the face's normal will point to the next vertex",
                APQn, face.words.normal, tell);
  }
};

/// Algorithm 1 read literally: it adds the vertex and processes the simplex after it has found P·dir < 0, and
/// contains_origin() may overwrite the answer. Wrong: for two balls side by side the same vertex comes back, the segment
/// AB has no length, and AB×AO×AB = 0 reads as "the origin lies on AB".
template <class ZeroTest = ExactZeroTest>
struct Printed : Intended<ZeroTest> {
  static constexpr NotCrossed not_crossed() { return NotCrossed::process_the_simplex; }
};

/// A faster variant that the report does not have: w·d < 0 proves at the first point, too, that the sets are apart. Worth
/// having where the first direction is a good guess, such as first_direction_between(); tests/bench/peers measures it.
template <class ZeroTest = ExactZeroTest>
struct Eager : Intended<ZeroTest> {
  static constexpr FirstPoint first_point() { return FirstPoint::tested; }
};

using AsIntended = Intended<>;
using AsPrinted = Printed<>;

}  // namespace gjk
