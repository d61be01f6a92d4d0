/// What proves an answer about any two bodies, multiplied out in fractions: a direction between them, or a point of both.
///
/// Unlike the certificates of linear_program.hpp these know of no indices; the direction is that of `gjkstep query`.
#pragma once

#include "tests/study/truth/linear_program.hpp"

namespace study {

/// Returns: whether a·d < b·d for every a of A and every b of B.
///
/// Errors of all here: std::invalid_argument for what the oracle cannot judge: an axis askew, a number that is not finite.
bool separates(const RationalVec& d, const Pair& pair);

/// Returns: whether the closed body holds the point.
bool contains(const Body& body, const RationalVec& point);

/// Returns: whether two bodies that meet would no longer do so, if one of them were moved in some direction, by however
/// little. Of cylinders it is not known: false.
///
/// Requires: they meet.
bool only_touch(const Pair& pair);

/// Returns: a direction that separates the two; a point of both. Requires: both balls, or both cylinders; that they are
/// apart, or meet. Errors: std::logic_error where none is found, as where cylinders meet in a point that is no fraction.
RationalVec direction_between(const Pair& round);
RationalVec common_point(const Pair& round);

}  // namespace study
