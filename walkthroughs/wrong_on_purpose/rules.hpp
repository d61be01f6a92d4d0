/// The mistakes that the report names, made on purpose: "an implementation can have a bug, but still pass many test cases"
/// (Section 1). How many?
///
/// WRONG ON PURPOSE: whoever looks for rules to use finds them in core/.
///
/// Each is a variant of gjk::AsIntended that hides a detail of Algorithms 1-5 (core/rules.hpp) and nothing else. Its events
/// tell what it does: a product crossed in the wrong order is told with that order, the vertices kept are those that are
/// kept, and where it overlooks a zero the reason says so. Two more mistakes are rules of the core: gjk::Eager tests the
/// first point, too, and gjk::AsPrinted processes the simplex after Eq. 9 has said no.
#pragma once

#include <boost/mp11.hpp>
#include <stdexcept>
#include <tuple>

#include "core/gjk.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::wrong_on_purpose {

using gjk::AsIntended;
using gjk::Face;
using gjk::Kept;
using gjk::Role;
using gjk::Side;

// -- Algorithm 1 ------------------------------------------------------------------------------------------------------

/// A - B whose vertices are support(A, d) - support(B, d).
template <class S, class A, class B>
struct BackwardDifference {
  const A& a;
  const B& b;
  gjk::Vertex<S> vertex(const gjk::Vec3<S>& d) const {
    gjk::Vertex<S> v{a.support(d), b.support(d), {}};
    v.w = v.a.point - v.b.point;
    return v;
  }
};

struct WrongSideOfB : AsIntended {
  template <class S, class A, class B>
  static BackwardDifference<S, A, B> difference(const A& a, const B& b) {
    return {a, b};
  }
};
/// Eq. 9 with <=.
struct StopsWhereTouched : AsIntended {
  static bool crossed(const auto& w_d) { return w_d.is_positive(); }
};

// -- Where the origin is ----------------------------------------------------------------------------------------------

struct OriginAtVertexMissed : AsIntended {
  static bool is_at_origin(const auto&) { return false; }
};
struct OriginOnSegmentMissed : AsIntended {
  static bool is_on_segment(const auto&) { return false; }
};
struct OriginInTriangleMissed : AsIntended {
  static Side side_of_triangle(const auto& ABCn_AO) { return ABCn_AO.is_positive() ? Side::above : Side::below; }
};
struct TwoDimensionsOnly : AsIntended {
  static Side side_of_triangle(const auto&) { return Side::in_plane; }
};
struct OriginInFaceSeenOutside : AsIntended {
  static bool is_above_face(const auto& APQn_AO) { return APQn_AO.is_positive() || APQn_AO.is_zero(); }
};

// -- Normals ----------------------------------------------------------------------------------------------------------

struct TriangleNormalReversed : AsIntended {  // and with it both normals of its edges
  static auto ABCn_of_triangle(const auto& AB, const auto& AC) { return AC.cross(AB); }
};
struct TriangleABnInward : AsIntended {
  static auto ABn_of_triangle(const auto& AB, const auto& ABCn) { return ABCn.cross(AB); }
};
struct TriangleACnInward : AsIntended {
  static auto ACn_of_triangle(const auto& AC, const auto& ABCn) { return AC.cross(ABCn); }
};
struct ABCnInward : AsIntended {
  static auto ABCn(const auto& AB, const auto& AC) { return AC.cross(AB); }
};
struct ACDnInward : AsIntended {
  static auto ACDn(const auto& AC, const auto& AD) { return AD.cross(AC); }
};
struct ADBnInward : AsIntended {
  static auto ADBn(const auto& AD, const auto& AB) { return AB.cross(AD); }
};
struct EdgeNormalReused : AsIntended {  // ACn of ABC for ACD, ADn of ACD for ADB
  static auto APn(Face face, const auto& AP, const auto& APQn, const auto& earlier) {
    return face == Face::ABC ? AP.cross(APQn) : earlier.cross(AP);
  }
};
struct ABnReusedForADB : AsIntended {
  static auto AQn(Face face, const auto& AQ, const auto& APQn, const auto& earlier) {
    return face == Face::ADB ? AQ.cross(earlier) : APQn.cross(AQ);
  }
};

// -- What to keep, and where to search --------------------------------------------------------------------------------

struct OrderKeptBelowTriangle : AsIntended {
  static constexpr Kept kept_below_triangle() { return {"CBA", gjk::ReductionReason::not_turned_below_triangle}; }
};
struct OrderOfADB : AsIntended {
  static constexpr Kept kept_above(Face face) {
    return face == Face::ADB ? Kept{"DBA", gjk::ReductionReason::face_in_its_order} : AsIntended::kept_above(face);
  }
};
struct DirectionFromVertex : AsIntended {
  static auto from_segment(const auto& /*AB*/, const auto& AO) { return AO; }
  static auto from_edge(const auto& /*AX*/, const auto& AO, const auto& /*AXn*/) { return AO; }
};
struct EdgeNormalAsDirection : AsIntended {
  static auto from_edge(const auto& /*AX*/, const auto& /*AO*/, const auto& AXn) { return AXn; }
};

// -- By name ----------------------------------------------------------------------------------------------------------

/// The rules of each mistake, in the order of the enumerators.
using RulesOfMistakes =
    std::tuple<WrongSideOfB, gjk::Eager<>, StopsWhereTouched, gjk::AsPrinted, OriginAtVertexMissed,
               OriginOnSegmentMissed, DirectionFromVertex, TriangleNormalReversed, TriangleABnInward, TriangleACnInward,
               EdgeNormalAsDirection, TwoDimensionsOnly, OriginInTriangleMissed, OrderKeptBelowTriangle, ABCnInward,
               ACDnInward, ADBnInward, EdgeNormalReused, ABnReusedForADB, OrderOfADB, OriginInFaceSeenOutside>;

/// Calls use.template operator()<Rules>() with the rules that have this mistake, and only this: for callers who learn only while
/// they run which of them is wanted.
///
/// Returns: what it returns; the type must be the same for all.
/// Errors: std::invalid_argument for what is no enumerator; what `use` throws passes through.
template <class Use>
decltype(auto) with_mistake(Mistake mistake, Use&& use) {
  constexpr std::size_t count = std::tuple_size_v<RulesOfMistakes>;
  if (static_cast<std::size_t>(mistake) >= count) throw std::invalid_argument("there is no such mistake");
  return boost::mp11::mp_with_index<count>(static_cast<std::size_t>(mistake), [&](auto place) -> decltype(auto) {
    return use.template operator()<std::tuple_element_t<place, RulesOfMistakes>>();
  });
}

}  // namespace walkthroughs::wrong_on_purpose
