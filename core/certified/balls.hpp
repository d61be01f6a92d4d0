/// Collision tests of balls, and of balls and sets of points. They are exact: never wrong, never undecided. Needs what
/// certified.hpp needs.
///
/// The assumptions are those of certified.hpp. The question is whether a distance is at most the sum of the radii. It
/// is the distance of the centers, or of the center from the hull of the points. Polynomials in the coordinates and
/// radii decide that, each by its exact sign (C3).
#pragma once

#include "certified.hpp"

namespace gjk {

namespace detail {

/// Requires: the feature of the difference that is nearest to the origin. v is the nearest point of it.
/// Returns: whether |v| <= r + s. Both sides are squared and multiplied by the square of what v's distance is measured
/// along. For an edge |AB×AO|² is |v|²|AB|². For a triangle (ABCn·AO)² is |v|²|ABCn|².
template <class S>
bool is_within(const ExactSimplex<S>& nearest, const ExactDifference<S>& difference, S r, S s) {
  const auto excess = [&]<class N>(const FromA<N>& A) {
    const N reach = difference.template number<N>(r) + difference.template number<N>(s), reach_squared = reach * reach;
    const auto &AO = A.AO, &AB = A[Role::B];
    if (nearest.size() == 1) return dot(AO, AO) - reach_squared;
    const Triple<N> across = cross(AB, nearest.size() == 2 ? AO : A[Role::C]);
    if (nearest.size() == 2) return dot(across, across) - reach_squared * dot(AB, AB);
    const N height = dot(across, AO);
    return height * height - reach_squared * dot(across, across);
  };
  return nearest.sign(excess) <= 0;
}

/// Returns: whether the hulls of two sets of points are at most r + s apart. Walks to the feature of the difference
/// that is nearest to the origin. That walk ends as C4 says.
template <class S>
Status status_within(const PointSet<S>& a, const PointSet<S>& b, S r, S s) {
  expect_usual_arithmetic();
  const ExactDifference<S> difference(a, b, Vec3<S>(r, s, S(0)));
  ExactSimplex<S> simplex(difference);
  std::optional<IndexPair> next = IndexPair{};
  while (next) {
    simplex.add(*next);
    simplex.keep(nearest_with_A(simplex, simplex.size()));
    if (simplex.contains_origin()) return Status::intersecting;
    next = AlongDirection<S>(difference, simplex).vertex_nearer();
  }
  return is_within(simplex, difference, r, s) ? Status::intersecting : Status::separated;
}

template <class S>
PointSet<S> center_of(const Sphere<S>& ball) {
  return PointSet<S>({ball.center()});
}

}  // namespace detail

/// Do they have a point in common? The answer is exact. Touching is intersecting.
///
/// Requires: finite numbers. Errors: as certified_collision().
template <class S>
Status certified_status(const Sphere<S>& a, const Sphere<S>& b) {
  return detail::status_within(detail::center_of(a), detail::center_of(b), a.radius(), b.radius());
}
template <class S>
Status certified_status(const PointSet<S>& a, const Sphere<S>& b) {
  return detail::status_within(a, detail::center_of(b), S(0), b.radius());
}
template <class S>
Status certified_status(const Sphere<S>& a, const PointSet<S>& b) {
  return certified_status(b, a);
}
template <class S>
Status certified_status(const PointSet<S>& a, const PointSet<S>& b) {
  return certified_collision(a, b).status;
}

}  // namespace gjk
