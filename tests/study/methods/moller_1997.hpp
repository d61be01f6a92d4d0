/// The interval test for two triangles of T. Möller, "A Fast Triangle-Triangle Intersection Test", Journal of Graphics
/// Tools 2(2), 1997, which the report verifies its GJK against (Section 4). Written from the paper's description.
///
/// Each triangle is cut by the plane of the other. Where both planes cut, the two pieces lie on the line in which the
/// planes meet, and the triangles have a point in common exactly where the two intervals do:
///
///     triangle 1           ──●━━━━━━━━━━━●───────────  ──▶ the line in which the planes meet, D = N₁×N₂
///     triangle 2           ───────●━━━━━━━━━━━●──────
///
/// It shares nothing with GJK: neither a support function nor a simplex.
#pragma once

#include <array>
#include <utility>

#include "core/shapes.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace study::moller_1997 {

template <class S>
using Triangle = std::array<gjk::Vec3<S>, 3>;

/// Requires: there are three.
template <class S>
Triangle<S> triangle_of(const Points& points) {
  Triangle<S> t;
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) t[i][k] = S(points[i][k]);
  return t;
}

/// The paper computes with the distances from the planes as they come out. The implementation that its author published,
/// which is what is used in the field, takes those below 1e-6 for zero, "for robustness". They are not lengths: N is not
/// normalised, so that the same triangle made ten times smaller is snapped a thousand times as far.
enum class Distances { as_computed, small_ones_snapped };

inline constexpr double snap_below = 1e-6;

template <class S>
struct Interval {
  S least, most;
};

enum class How {
  beyond_a_plane,  ///< all vertices of one triangle lie strictly on one side of the other's plane: they do not meet
  intervals,       ///< the intervals on the line in which the planes meet
  in_one_plane,    ///< all distances are zero: edges against edges, and corners in triangles, in the plane
};

/// The answer and how it was found.
template <class S>
struct Finding {
  bool meet = false;
  How how = How::beyond_a_plane;
  std::array<S, 3> first_distances, second_distances;  ///< of its vertices from the other's plane, in units of its |N|
  Interval<S> first, second;                           ///< where `how` is intervals
};

// -- Signs ------------------------------------------------------------------------------------------------------------

template <class S>
int sign(const S& x) {
  return x > S(0) ? 1 : x < S(0) ? -1 : 0;
}

template <class S>
S magnitude(const S& x) {
  return x < S(0) ? S(-x) : x;
}

template <class S>
bool strictly_on_one_side(const std::array<S, 3>& d) {
  return sign(d[0]) != 0 && sign(d[0]) == sign(d[1]) && sign(d[0]) == sign(d[2]);
}

template <class S>
bool all_zero(const std::array<S, 3>& d) {
  return sign(d[0]) == 0 && sign(d[1]) == 0 && sign(d[2]) == 0;
}

template <class S>
int largest_component(const gjk::Vec3<S>& v) {
  int largest = 0;
  for (int i = 1; i < 3; ++i)
    if (magnitude(v[i]) > magnitude(v[largest])) largest = i;
  return largest;
}

// -- Planes and intervals ---------------------------------------------------------------------------------------------

/// N·X + d = 0.
template <class S>
struct Plane {
  gjk::Vec3<S> N;
  S d;

  explicit Plane(const Triangle<S>& t) : N((t[1] - t[0]).cross(t[2] - t[0])), d(-N.dot(t[0])) {}
};

template <class S>
std::array<S, 3> distances(const Triangle<S>& t, const Plane<S>& plane, Distances treatment) {
  std::array<S, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = plane.N.dot(t[i]) + plane.d;
    if (treatment == Distances::small_ones_snapped && magnitude(result[i]) < S(snap_below)) result[i] = S(0);
  }
  return result;
}

/// The vertex from which both edges that meet the plane start: the one that the other two are both on the far side of,
/// or both in the plane; where all three differ, one of the two that are off the plane.
///
/// Requires: not all distances are zero, nor all on one side.
template <class S>
std::size_t vertex_alone_on_its_side(const std::array<S, 3>& d) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (sign(d[(i + 1) % 3]) == sign(d[(i + 2) % 3])) return i;
  }
  return sign(d[0]) != 0 ? 0 : 1;
}

/// Where the triangle's two edges meet the other's plane, as places on `axis`: the line L is replaced by its projection
/// on the axis in which D is longest, which keeps the order of its points. Ends are rounded, as in the implementation
/// that the paper's author published: of a vertex in the plane, too, where it is not the one that the edges start from.
///
/// Requires: as vertex_alone_on_its_side.
template <class S>
Interval<S> interval(const Triangle<S>& t, const std::array<S, 3>& d, int axis) {
  const std::size_t alone = vertex_alone_on_its_side(d);
  const S p = t[alone][axis];
  const auto end = [&](std::size_t other) { return S(p + (t[other][axis] - p) * d[alone] / (d[alone] - d[other])); };
  S one = end((alone + 1) % 3), two = end((alone + 2) % 3);
  if (one > two) std::swap(one, two);
  return {one, two};
}

template <class S>
bool overlap(const Interval<S>& i, const Interval<S>& j) {
  return !(i.most < j.least) && !(j.most < i.least);
}

// -- Two triangles in one plane ---------------------------------------------------------------------------------------

template <class S>
using Point2 = std::array<S, 2>;

template <class S>
using Triangle2 = std::array<Point2<S>, 3>;

/// Projected on the axis-aligned plane in which the area is largest.
template <class S>
Triangle2<S> projected(const Triangle<S>& t, const gjk::Vec3<S>& N) {
  const int dropped = largest_component(N), x = (dropped + 1) % 3, y = (dropped + 2) % 3;
  Triangle2<S> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = {t[i][x], t[i][y]};
  return result;
}

/// Returns: 1 where r lies to the left of the line from p to q, 0 on it, -1 to the right.
template <class S>
int side(const Point2<S>& p, const Point2<S>& q, const Point2<S>& r) {
  return sign(S((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])));
}

/// Requires: r lies on the line through p and q.
template <class S>
bool between(const Point2<S>& p, const Point2<S>& q, const Point2<S>& r) {
  const std::size_t axis = magnitude(S(q[0] - p[0])) >= magnitude(S(q[1] - p[1])) ? 0 : 1;
  return p[axis] < q[axis] ? p[axis] <= r[axis] && r[axis] <= q[axis] : q[axis] <= r[axis] && r[axis] <= p[axis];
}

template <class S>
bool segments_meet(const Point2<S>& p, const Point2<S>& q, const Point2<S>& r, const Point2<S>& s) {
  const int r_side = side(p, q, r), s_side = side(p, q, s), p_side = side(r, s, p), q_side = side(r, s, q);
  if (r_side * s_side < 0 && p_side * q_side < 0) return true;
  return (r_side == 0 && between(p, q, r)) || (s_side == 0 && between(p, q, s)) || (p_side == 0 && between(r, s, p)) ||
         (q_side == 0 && between(r, s, q));
}

template <class S>
bool lies_in(const Point2<S>& p, const Triangle2<S>& t) {
  const int i = side(t[0], t[1], p), j = side(t[1], t[2], p), k = side(t[2], t[0], p);
  return (i >= 0 && j >= 0 && k >= 0) || (i <= 0 && j <= 0 && k <= 0);
}

/// First all edges against all edges; where none meet, one triangle may still lie inside the other.
template <class S>
bool meet_in_plane(const Triangle2<S>& t, const Triangle2<S>& u) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (segments_meet(t[i], t[(i + 1) % 3], u[j], u[(j + 1) % 3])) return true;
  return lies_in(t[0], u) || lies_in(u[0], t);
}

// -- The test ---------------------------------------------------------------------------------------------------------

/// Do two closed triangles have a point in common? In the paper's order: each triangle against the other's plane, then
/// the intervals, or both projected where they lie in one plane.
///
/// Requires: neither triangle is flat.
template <class S>
Finding<S> find(const Triangle<S>& first, const Triangle<S>& second, Distances treatment) {
  Finding<S> finding;
  const Plane<S> second_plane(second);
  finding.first_distances = distances(first, second_plane, treatment);
  if (strictly_on_one_side(finding.first_distances)) return finding;
  const Plane<S> first_plane(first);
  finding.second_distances = distances(second, first_plane, treatment);
  if (strictly_on_one_side(finding.second_distances)) return finding;
  if (all_zero(finding.first_distances) || all_zero(finding.second_distances)) {
    finding.how = How::in_one_plane;
    finding.meet = meet_in_plane(projected(first, first_plane.N), projected(second, first_plane.N));
    return finding;
  }
  finding.how = How::intervals;
  const int axis = largest_component(gjk::Vec3<S>(first_plane.N.cross(second_plane.N)));
  finding.first = interval(first, finding.first_distances, axis);
  finding.second = interval(second, finding.second_distances, axis);
  finding.meet = overlap(finding.first, finding.second);
  return finding;
}

template <class S>
bool meet(const Triangle<S>& first, const Triangle<S>& second, Distances treatment = Distances::as_computed) {
  return find(first, second, treatment).meet;
}

}  // namespace study::moller_1997
