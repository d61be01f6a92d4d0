/// How far two sets of points are from the other answer.
#pragma once

#include "walkthroughs/judge/case.hpp"

namespace walkthroughs::judge {

/// How far apart, or how deep in each other: the shortest move that makes the other answer true.
struct HowFar {
  double length = 0;      ///< in the unit of the pair
  double relative = 0;    ///< to the diagonal of the box around both sets, so at most 1
  bool is_bound = false;  ///< no more than that; else it is that, up to rounding
};

/// `in_plane`: of moves in the plane z = 0. Of sets apart the length of the point of the difference that is nearest to 0. Of sets
/// that meet the least value of its support function over the normals of its facets (which are among the cross products of edges
/// of a, and of b), and of many points, where these would be too many, over directions that a descent finds.
HowFar how_far(const Case& asked, bool in_plane);

/// Returns: the length, relative to the diagonal of the box around both sets. Finite, also where either is beyond doubles.
double relative_to_size(double length, const PointPair& pair);

/// Returns: whether they have a point in common, and an arbitrarily short move parts them. Decided exactly. Requires: that they meet.
bool only_touch(const PointPair& pair, bool in_plane);

/// Returns: whether all points of one lie in the interior of the other, in the plane or in space. Decided exactly.
bool one_is_inside(const PointPair& pair, bool in_plane);

}  // namespace walkthroughs::judge
