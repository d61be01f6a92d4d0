/// Which feature of a simplex is nearest to the origin? It is found without any history but one step: the distance has
/// just fallen.
#pragma once

#include "simplex.hpp"

namespace gjk::detail {

/// Returns: the vertices of one feature of the simplex, A last. The point of the simplex nearest to the origin
/// (min-norm point) lies in the interior of that feature. A tetrahedron is returned whole where the origin lies in it,
/// or on a face of it.
///
/// Requires: affinely independent vertices, and A in that feature. It is so where A was found along the way to the
/// origin, w·d >= 0 > v·d. Here v is the nearest point before, and d is −v or a positive multiple. It is enough that
/// w·d > v·d. The reason:
///  1. Points of the segment from v to A are nearer than v.
///  2. v was nearest in all features without A. So these need no test.
///  3. The point nearest to the origin of a convex set is one, and lies in the interior of one feature. So exactly one
///     of the other features passes its test:
///
///  * vertex A: AX·AO <= 0 for every other X;
///  * edge AX: AX·AO > 0, and the origin is not on the inner side of AX in the plane of AX and another Y;
///  * face AXY: the origin is not on the side of the fourth vertex, and lies strictly inside both edges of the face at
///    A;
///  * tetrahedron: the origin is beyond no face at A. BCD needs no test: A and the origin lie on one side of it.
///
/// `sides` answers, for roles X, Y, Z other than A:
///  * sides.is_toward(X): AX·AO > 0;
///  * sides.is_beyond(X, Y): (AX·AO)(AX·AY) − (AY·AO)(AX·AX) >= 0, which is ABn·AO where X, Y are B, C;
///  * sides.is_above(X, Y, Z): (AX×AY)·AO and (AX×AY)·AZ have opposite signs.
template <class Sides>
Roles nearest_with_A(const Sides& sides, int size) {
  using enum Role;
  constexpr struct { Role X, Y, Z; } around[] = {{B, C, D}, {C, D, B}, {D, B, C}};
  const auto is_there = [size](Role X) { return static_cast<int>(X) < size; };
  const auto is_beyond = [&](Role X, Role Y) { return !is_there(Y) || sides.is_beyond(X, Y); };
  bool is_toward_any = false;
  for (const auto& [X, Y, Z] : around) {
    if (!is_there(X) || !sides.is_toward(X)) continue;
    is_toward_any = true;
    if (is_beyond(X, Y) && is_beyond(X, Z)) return {X, A};
  }
  if (!is_toward_any) return {A};
  if (size == 3) return {C, B, A};
  for (const auto& [X, Y, Z] : around)
    if (!sides.is_beyond(X, Y) && !sides.is_beyond(Y, X) && sides.is_above(X, Y, Z)) return {Y, X, A};
  return {D, C, B, A};
}

}  // namespace gjk::detail
