/// Questions about two objects that move little from one question to the next: what answered the last one is tried first (temporal
/// coherence; compare the cached separating axis of van den Bergen, "A Fast and Robust GJK Implementation", 1999, Section 4).
///
///     gjk::LastFound<double> last;  // one for each pair of objects
///     while (...) {
///       a.move_to(...);
///       const gjk::Result<double> result = gjk::collision(a, b, last);
///     }
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <utility>

#include "certificate.hpp"
#include "gjk.hpp"
#include "tetrahedron.hpp"

namespace gjk {

/// What has answered the last question about a pair. Whatever it holds, also of other objects, costs time and never truth.
template <std::floating_point S>
struct LastFound {
  Vec3<S> direction = Options<S>{}.first_direction;  ///< that separated them, or in which to begin
  IndexPairs corners;                                ///< four, where their tetrahedron held the origin; else none
};

namespace detail {

/// Returns: the point of that number, where it now is; none where the shape has no such number.
template <class S>
std::optional<Vec3<S>> numbered(const auto&, int) {
  return std::nullopt;
}
template <class S>
std::optional<Vec3<S>> numbered(const PointSet<S>& set, int i) {
  const bool is_there = i >= 0 && static_cast<std::size_t>(i) < set.points().size();
  return is_there ? std::optional(set.points()[static_cast<std::size_t>(i)]) : std::nullopt;
}
template <class S, class A>
std::optional<Vec3<S>> numbered(const Posed<S, A>& posed, int i) {
  const std::optional<Vec3<S>> own = numbered<S>(posed.shape(), i);
  return own ? std::optional(posed.pose()(*own)) : std::nullopt;
}

/// Returns: the corners, where they now are; fewer than four where some are not there.
template <class S, class A, class B>
Simplex<S> moved(const IndexPairs& corners, const A& a, const B& b) {
  Simplex<S> simplex;
  for (const IndexPair& pair : corners) {
    const std::optional<Vec3<S>> of_a = numbered<S>(a, pair.a), of_b = numbered<S>(b, pair.b);
    if (of_a && of_b) simplex.add({{*of_a, pair.a}, {*of_b, pair.b}, *of_a - *of_b});
  }
  return simplex;
}

/// Returns: whether the tetrahedron holds the origin, by more than rounding. The search has not led to it, so that its sides prove
/// nothing where they are as small: of points in one plane, for example. The bound is that of C2, certified/filter.hpp.
template <class S>
bool surely_holds_origin(const Simplex<S>& tetrahedron) {
  S M = 0;
  for (const Vertex<S>& vertex : tetrahedron) M = std::max(M, vertex.w.cwiseAbs().maxCoeff());
  const S error = 32 * std::numeric_limits<S>::epsilon() * M * M * M;
  constexpr S least =
      std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();  // below it underflow counts, too
  return error > least &&
         VolumesAtOrigin<S>(tetrahedron[0].w, tetrahedron[1].w, tetrahedron[2].w, tetrahedron[3].w).hold_origin(error);
}

/// Returns: a direction from these points to the origin.
template <class S>
Vec3<S> toward_origin(const Simplex<S>& simplex) {
  Vec3<S> sum = Vec3<S>::Zero();
  for (const Vertex<S>& vertex : simplex) sum -= vertex.w;
  return sum;
}

/// Returns: the options of a search that begins along that direction, where it is one.
template <class S>
Options<S> begun_along(const Vec3<S>& direction, Options<S> options) {
  options.inside.reset();
  options.first_direction = is_usable_direction(direction) ? direction : Options<S>{}.first_direction;
  return options;
}

/// The rules, but for the first point: where its direction still separates the objects, the search ends.
template <class Rules>
struct FirstPointTested : Rules {
  static constexpr FirstPoint first_point() { return FirstPoint::tested; }
};

template <class S>
LastFound<S> found_in(const Result<S>& result) {
  LastFound<S> found;
  if (result.separation) found.direction = result.separation->direction;
  if (result.status != Status::intersecting || result.simplex.size() < 4) return found;
  for (const Vertex<S>& vertex : result.simplex) {
    if (!vertex.a.index || !vertex.b.index) return {};
    found.corners.add({*vertex.a.index, *vertex.b.index});
  }
  return found;
}

}  // namespace detail

/// As collision() of gjk.hpp. Where the objects were together, the tetrahedron that showed it is looked at first, where its corners now
/// are: no support function is asked. Where they were apart, the search begins along the direction that showed it, and ends with one
/// point where it still does. `options.first_direction` and `options.inside` are not looked at.
///
/// `last`: of the same two objects; becomes what is found now. A new one knows nothing. Corners are known of point sets, posed or not.
/// Returns: where the tetrahedron has answered a result of no iterations.
template <class S = double, class Rules = AsIntended, Shape<S> A, Shape<S> B>
Result<S> collision(const A& a, const B& b, LastFound<S>& last, const Options<S>& options = {}) {
  if (last.corners.size() == 4) {
    const Simplex<S> simplex = detail::moved<S>(last.corners, a, b);
    if (simplex.size() == 4 && detail::surely_holds_origin(simplex))
      return {.status = Status::intersecting,
              .reason = Reason::simplex_contains_origin,
              .iterations = 0,
              .simplex = simplex,
              .separation = {},
              .cycle_start = {}};
    last.direction = detail::toward_origin(simplex);
  }
  const Result<S> result =
      collision<S, detail::FirstPointTested<Rules>>(a, b, detail::begun_along(last.direction, options));
  last = detail::found_in(result);
  return result;
}

}  // namespace gjk
