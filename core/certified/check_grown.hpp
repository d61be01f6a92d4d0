/// Does the answer about two grown sets hold? It is multiplied out in fractions, without any code of what made it.
/// Needs Eigen and Boost.Multiprecision.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "check.hpp"
#include "grown.hpp"

namespace gjk {
namespace detail {

/// Returns: q p q⁻¹, by (w² − v·v)p + 2(v·p)v + 2w v×p over q·q.
inline Fractions turned(const Quaternion& q, const Fractions& p) {
  const Fraction w = q.w;
  const Fractions v{q.x, q.y, q.z};
  const Fractions across{v[1] * p[2] - v[2] * p[1], v[2] * p[0] - v[0] * p[2], v[0] * p[1] - v[1] * p[0]};
  const Fraction vv = dot(v, v), square = w * w + vv;
  Fractions turned(3);
  for (std::size_t i = 0; i < 3; ++i)
    turned[i] = ((w * w - vv) * p[i] + 2 * dot(v, p) * v[i] + 2 * w * across[i]) / square;
  return turned;
}

inline Fractions turned(const Matrix3& M, const Fractions& p) {
  Fractions turned(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      turned[static_cast<std::size_t>(i)] += Fraction(M(i, j)) * p[static_cast<std::size_t>(j)];
  return turned;
}

/// Returns: M p + t.
inline Fractions moved(const Motion& motion, const Vec3<double>& point) {
  const Fractions p = fractions(point);
  Fractions moved = std::visit([&](const auto& turn) { return turned(turn, p); }, motion.turn);
  for (std::size_t i = 0; i < 3; ++i) moved[i] += Fraction(motion.translation[static_cast<int>(i)]);
  return moved;
}

/// Returns: the point of the core that has that number; none where none has.
inline std::optional<Fractions> core_point(const Grown& grown, int number) {
  if (number < 0) return std::nullopt;
  Fractions sum(3);
  for (std::size_t k = grown.sets().size(); k-- > 0;) {
    const MovedPoints& set = grown.sets()[k].given();
    const auto size = static_cast<int>(set.points.size());
    const Fractions p = moved(set.motion, set.points[static_cast<std::size_t>(number % size)]);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i];
    number /= size;
  }
  return number == 0 ? std::optional(sum) : std::nullopt;
}

/// Returns: the least of p·v of all points of the core, where `sign` is −1 that of −p·v.
inline Fraction least_along(const Fractions& v, const Grown& grown, int sign) {
  Fraction sum = 0;
  for (const MovedSet& set : grown.sets()) {
    std::optional<Fraction> least;
    for (const Vec3<double>& p : set.given().points) {
      const Fraction here = sign * dot(moved(set.given().motion, p), v);
      if (!least || here < *least) least = here;
    }
    sum += *least;
  }
  return sum;
}

inline Fraction sum_of_radii(const Grown& grown) {
  Fraction sum = 0;
  for (const double radius : grown.radii()) sum += Fraction(radius);
  return sum;
}

}  // namespace detail

/// Returns: nothing where these are no points of the difference of the cores, or depend on each other.
inline std::optional<NearestPoint> nearest_point_of(const IndexPairs& nearest, const Grown& a, const Grown& b) {
  const auto points = detail::differences_of(nearest, 4, a, b, detail::core_point);
  return points ? detail::nearest_point_of(*points) : std::nullopt;
}

/// Returns: whether these points prove the answer. No weight is below 0, so v is in the difference. No w·v is below
/// v·v, so v is nearest to the origin. And |v|² tells the answer.
inline bool holds(const GrownResult& result, const Grown& a, const Grown& b) {
  const auto nearest = nearest_point_of(result.nearest, a, b);
  if (!nearest || std::ranges::any_of(nearest->weights, [](const Fraction& t) { return t < 0; })) return false;
  const detail::Fractions& v = nearest->v;
  const Fraction square = detail::dot(v, v), reach = detail::sum_of_radii(a) + detail::sum_of_radii(b);
  if (detail::least_along(v, a, +1) + detail::least_along(v, b, -1) < square) return false;
  return result.status == (square <= reach * reach ? Status::intersecting : Status::separated);
}

}  // namespace gjk
