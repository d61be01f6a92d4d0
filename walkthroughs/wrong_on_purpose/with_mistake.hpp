/// The rules of each mistake by its name, for callers who learn only while they run which of them is wanted.
#pragma once

#include <stdexcept>
#include <utility>

#include "walkthroughs/wrong_on_purpose/mistakes.hpp"
#include "walkthroughs/wrong_on_purpose/rules.hpp"

namespace walkthroughs::wrong_on_purpose {

/// Calls use.template operator()<Rules>() with the rules that have this mistake, and only this.
///
/// Returns: what it returns; the type must be the same for all.
/// Errors: std::invalid_argument for what is no enumerator; what `use` throws passes through.
template <class Use>
decltype(auto) with_mistake(Mistake mistake, Use&& use) {
  switch (mistake) {
    case Mistake::wrong_side_of_b: return use.template operator()<WrongSideOfB>();
    case Mistake::first_point_tested: return use.template operator()<gjk::Eager<>>();
    case Mistake::touching_is_apart: return use.template operator()<StopsWhereTouched>();
    case Mistake::as_printed: return use.template operator()<gjk::AsPrinted>();
    case Mistake::origin_at_vertex_missed: return use.template operator()<OriginAtVertexMissed>();
    case Mistake::origin_on_segment_missed: return use.template operator()<OriginOnSegmentMissed>();
    case Mistake::direction_from_vertex: return use.template operator()<DirectionFromVertex>();
    case Mistake::triangle_normal_reversed: return use.template operator()<TriangleNormalReversed>();
    case Mistake::triangle_abn_inward: return use.template operator()<TriangleABnInward>();
    case Mistake::triangle_acn_inward: return use.template operator()<TriangleACnInward>();
    case Mistake::edge_normal_as_direction: return use.template operator()<EdgeNormalAsDirection>();
    case Mistake::two_dimensions_only: return use.template operator()<TwoDimensionsOnly>();
    case Mistake::origin_in_triangle_missed: return use.template operator()<OriginInTriangleMissed>();
    case Mistake::order_kept_below_triangle: return use.template operator()<OrderKeptBelowTriangle>();
    case Mistake::abcn_inward: return use.template operator()<ABCnInward>();
    case Mistake::acdn_inward: return use.template operator()<ACDnInward>();
    case Mistake::adbn_inward: return use.template operator()<ADBnInward>();
    case Mistake::edge_normals_reused: return use.template operator()<EdgeNormalReused>();
    case Mistake::abn_reused_for_adb: return use.template operator()<ABnReusedForADB>();
    case Mistake::order_of_adb: return use.template operator()<OrderOfADB>();
    case Mistake::origin_in_face_seen_outside: return use.template operator()<OriginInFaceSeenOutside>();
  }
  throw std::invalid_argument("there is no such mistake");
}

}  // namespace walkthroughs::wrong_on_purpose
