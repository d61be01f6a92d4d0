/// Pairs whose gaps and depths are spread evenly over the powers of ten, from 1e-15 to 1.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/pairs/family.hpp"

namespace walkthroughs::pairs {

/// Returns: the point of the difference a - b that is nearest to the origin, found exactly and then rounded; 0 where they meet.
Vec nearest_point(const PointPair& pair);

/// Returns: the family "graded-NAME". Its pairs are those of `base`, moved along the shortest line between them: those with an even
/// index until a gap is left of 1, 1e-1, … 1e-15 times half the width of the thinner one, those with an odd one so deep into each
/// other. Each 32 have them all. What rounding makes of the smallest, the truth says.
///
/// Requires: a family of points.
Family graded(const Family& base);

/// Returns: those of triangles, tetrahedra, boxes, and hulls of 8 and 32 points.
const std::vector<Family>& graded_families();

}  // namespace walkthroughs::pairs
