/// The mistakes that the report names, made on purpose: "an implementation can have a bug, but still pass many test cases"
/// (Section 1). How many?
///
/// Rules<Details> are Algorithms 2-5 in short, with every detail that is easily got wrong as a function of its own. A
/// mistake derives from Faithful and hides one of them. Rules<Faithful> asks for the same directions as gjk::AsIntended,
/// which a test looks at. Eq. 9 is the real one.
#pragma once

#include <array>

#include "core/gjk.hpp"

namespace study {

/// The details as the report's text has them.
struct Faithful {
  template <class S>
  using V = gjk::Vec3<S>;

  using Order = std::array<gjk::Role, 3>;  ///< oldest first

  // -- Where the origin is --------------------------------------------------------------------------------------------

  template <class S>
  static bool at_origin(const V<S>& AO) {
    return gjk::is_zero(AO);
  }
  template <class S>
  static bool on_segment(const V<S>& direction) {
    return gjk::is_zero(direction);
  }
  template <class S>
  static bool in_triangle(const S& height) {
    return height == S(0);
  }
  template <class S>
  static bool above_face(const S& height) {
    return height > S(0);
  }

  // -- Normals: Eqs. 10, 11 and 14, and Algorithm 5 -------------------------------------------------------------------

  template <class S>
  static V<S> triangle_normal(const V<S>& AB, const V<S>& AC) {
    return AB.cross(AC);
  }
  template <class S>
  static V<S> triangle_ABn(const V<S>& AB, const V<S>& ABCn) {
    return AB.cross(ABCn);
  }
  template <class S>
  static V<S> triangle_ACn(const V<S>& AC, const V<S>& ABCn) {
    return ABCn.cross(AC);
  }
  template <class S>
  static V<S> ABCn(const V<S>& AB, const V<S>& AC) {
    return AB.cross(AC);
  }
  template <class S>
  static V<S> ACDn(const V<S>& AC, const V<S>& AD) {
    return AC.cross(AD);
  }
  template <class S>
  static V<S> ADBn(const V<S>& AD, const V<S>& AB) {
    return AD.cross(AB);
  }

  /// Of the edge AX that a face has in common with the one before it in Algorithm 5: `other` is that face's normal.
  template <class S>
  static V<S> shared_edge(const V<S>& AX, const V<S>& own, const V<S>& /*other*/) {
    return AX.cross(own);
  }
  /// Of AB, which face ADB has in common with ABC.
  template <class S>
  static V<S> AB_of_ADB(const V<S>& AB, const V<S>& ADBn, const V<S>& /*ABCn*/) {
    return ADBn.cross(AB);
  }

  // -- Where to search, and what to keep ------------------------------------------------------------------------------

  template <class S>
  static V<S> from_segment(const V<S>& AB, const V<S>& AO) {
    return gjk::triple(AB, AO);
  }
  /// From the edge AX of a triangle or tetrahedron, across which the origin lies; AXn is its normal in the face.
  template <class S>
  static V<S> from_edge(const V<S>& AX, const V<S>& AO, const V<S>& /*AXn*/) {
    return gjk::triple(AX, AO);
  }
  static constexpr Order below_triangle() { return {gjk::Role::C, gjk::Role::A, gjk::Role::B}; }
  static constexpr Order above_ADB() { return {gjk::Role::B, gjk::Role::D, gjk::Role::A}; }
  static constexpr bool triangle_reaches_above_and_below = true;
};

template <class Details>
struct Rules : gjk::AsIntended {
  template <class S, class Obs>
  static gjk::Next<S> process_0simplex(const gjk::Simplex<S>& simplex, gjk::Teller<Obs>&) {
    const gjk::Vec3<S> AO = -simplex.point(gjk::Role::A);
    if (Details::at_origin(AO)) return std::nullopt;
    return AO;
  }

  template <class S, class Obs>
  static gjk::Next<S> process_1simplex(const gjk::Simplex<S>& simplex, gjk::Teller<Obs>&) {
    const gjk::Vec3<S> direction = Details::from_segment(from_A(simplex, gjk::Role::B), AO(simplex));
    if (Details::on_segment(direction)) return std::nullopt;
    return direction;
  }

  template <class S, class Obs>
  static gjk::Next<S> process_2simplex(gjk::Simplex<S>& simplex, gjk::Teller<Obs>&) {
    const gjk::Vec3<S> AB = from_A(simplex, gjk::Role::B), AC = from_A(simplex, gjk::Role::C), O = AO(simplex);
    const gjk::Vec3<S> n = Details::triangle_normal(AB, AC);
    const gjk::Vec3<S> ABn = Details::triangle_ABn(AB, n), ACn = Details::triangle_ACn(AC, n);
    if (ABn.dot(O) > S(0)) return edge(simplex, gjk::Role::B, AB, ABn);
    if (ACn.dot(O) > S(0)) return edge(simplex, gjk::Role::C, AC, ACn);
    const S height = n.dot(O);
    if (!Details::triangle_reaches_above_and_below || Details::in_triangle(height)) return std::nullopt;
    if (height > S(0)) return n;
    return keep(simplex, Details::below_triangle(), gjk::Vec3<S>(-n));
  }

  template <class S, class Obs>
  static gjk::Next<S> process_3simplex(gjk::Simplex<S>& simplex, gjk::Teller<Obs>&) {
    using gjk::Role;
    const gjk::Vec3<S> AB = from_A(simplex, Role::B), AC = from_A(simplex, Role::C), AD = from_A(simplex, Role::D);
    const gjk::Vec3<S> O = AO(simplex);
    const gjk::Vec3<S> ABCn = Details::ABCn(AB, AC), ACDn = Details::ACDn(AC, AD), ADBn = Details::ADBn(AD, AB);
    if (Details::above_face(ABCn.dot(O)))
      return face(simplex, {Role::C, Role::B, Role::A}, ABCn, {Role::C, AC, ABCn.cross(AC)},
                  {Role::B, AB, AB.cross(ABCn)});
    if (Details::above_face(ACDn.dot(O)))
      return face(simplex, {Role::D, Role::C, Role::A}, ACDn, {Role::D, AD, ACDn.cross(AD)},
                  {Role::C, AC, Details::shared_edge(AC, ACDn, ABCn)});
    if (Details::above_face(ADBn.dot(O)))
      return face(simplex, Details::above_ADB(), ADBn, {Role::B, AB, Details::AB_of_ADB(AB, ADBn, ABCn)},
                  {Role::D, AD, Details::shared_edge(AD, ADBn, ACDn)});
    return std::nullopt;
  }

 private:
  template <class S>
  struct Edge {
    gjk::Role X;
    gjk::Vec3<S> AX, AXn;
  };

  template <class S>
  static gjk::Vec3<S> AO(const gjk::Simplex<S>& simplex) {
    return -simplex.point(gjk::Role::A);
  }
  template <class S>
  static gjk::Vec3<S> from_A(const gjk::Simplex<S>& simplex, gjk::Role X) {
    return simplex.point(X) - simplex.point(gjk::Role::A);
  }
  template <class S, class Roles>
  static gjk::Next<S> keep(gjk::Simplex<S>& simplex, const Roles& roles, const gjk::Vec3<S>& direction) {
    gjk::Simplex<S> kept;
    for (const gjk::Role role : roles) kept.add(simplex[role]);
    simplex = kept;
    return direction;
  }

  template <class S>
  static gjk::Next<S> edge(gjk::Simplex<S>& simplex, gjk::Role X, const gjk::Vec3<S>& AX, const gjk::Vec3<S>& AXn) {
    const gjk::Vec3<S> direction = Details::from_edge(AX, AO(simplex), AXn);
    return keep(simplex, std::array{X, gjk::Role::A}, direction);
  }

  template <class S>
  static gjk::Next<S> face(gjk::Simplex<S>& simplex, const Faithful::Order& order, const gjk::Vec3<S>& normal,
                           const Edge<S>& one, const Edge<S>& two) {
    for (const Edge<S>& e : {one, two})
      if (e.AXn.dot(AO(simplex)) > S(0)) return edge(simplex, e.X, e.AX, e.AXn);
    return keep(simplex, order, normal);
  }
};

// -- The mistakes -----------------------------------------------------------------------------------------------------

namespace mistake {

using gjk::Role;

struct OriginAtVertexMissed : Faithful {
  template <class S>
  static bool at_origin(const V<S>&) {
    return false;
  }
};
struct OriginOnSegmentMissed : Faithful {
  template <class S>
  static bool on_segment(const V<S>&) {
    return false;
  }
};
struct OriginInTriangleMissed : Faithful {
  template <class S>
  static bool in_triangle(const S&) {
    return false;
  }
};
struct OriginInFaceSeenOutside : Faithful {
  template <class S>
  static bool above_face(const S& height) {
    return height >= S(0);
  }
};
struct TriangleNormalReversed : Faithful {  // and with it both normals of its edges
  template <class S>
  static V<S> triangle_normal(const V<S>& AB, const V<S>& AC) {
    return AC.cross(AB);
  }
};
struct TriangleABnInward : Faithful {
  template <class S>
  static V<S> triangle_ABn(const V<S>& AB, const V<S>& ABCn) {
    return ABCn.cross(AB);
  }
};
struct TriangleACnInward : Faithful {
  template <class S>
  static V<S> triangle_ACn(const V<S>& AC, const V<S>& ABCn) {
    return AC.cross(ABCn);
  }
};
struct ABCnInward : Faithful {
  template <class S>
  static V<S> ABCn(const V<S>& AB, const V<S>& AC) {
    return AC.cross(AB);
  }
};
struct ACDnInward : Faithful {
  template <class S>
  static V<S> ACDn(const V<S>& AC, const V<S>& AD) {
    return AD.cross(AC);
  }
};
struct ADBnInward : Faithful {
  template <class S>
  static V<S> ADBn(const V<S>& AD, const V<S>& AB) {
    return AB.cross(AD);
  }
};
struct EdgeNormalReused : Faithful {  // ACn of ABC for ACD, ADn of ACD for ADB
  template <class S>
  static V<S> shared_edge(const V<S>& AX, const V<S>&, const V<S>& other) {
    return other.cross(AX);
  }
};
struct ABnReusedForADB : Faithful {
  template <class S>
  static V<S> AB_of_ADB(const V<S>& AB, const V<S>&, const V<S>& ABCn) {
    return AB.cross(ABCn);
  }
};
struct OrderKeptBelowTriangle : Faithful {
  static constexpr Order below_triangle() { return {Role::C, Role::B, Role::A}; }
};
struct OrderOfADB : Faithful {
  static constexpr Order above_ADB() { return {Role::D, Role::B, Role::A}; }
};
struct DirectionFromVertex : Faithful {
  template <class S>
  static V<S> from_segment(const V<S>&, const V<S>& AO) {
    return AO;
  }
  template <class S>
  static V<S> from_edge(const V<S>&, const V<S>& AO, const V<S>&) {
    return AO;
  }
};
struct EdgeNormalAsDirection : Faithful {
  template <class S>
  static V<S> from_edge(const V<S>&, const V<S>&, const V<S>& AXn) {
    return AXn;
  }
};
struct TwoDimensionsOnly : Faithful {
  static constexpr bool triangle_reaches_above_and_below = false;
};

/// Eq. 9 with <=.
struct StopsWhereTouched : gjk::AsIntended {
  template <class S>
  static bool crossed(const S& value, const gjk::Vertex<S>&, const gjk::Vec3<S>&) {
    return value > S(0);
  }
};

}  // namespace mistake

}  // namespace study
