/// Does a certificate hold? It is multiplied out in fractions, without any code of what made it. Needs Eigen and
/// Boost.Multiprecision.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "../certificate.hpp"
#include "fraction.hpp"

namespace gjk {
namespace detail {

using Fractions = std::vector<Fraction>;

inline Fraction dot(const Fractions& u, const Fractions& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

template <class S>
Fractions fractions(const Vec3<S>& v) {
  return {Fraction(v[0]), Fraction(v[1]), Fraction(v[2])};
}

inline Fractions minus(const Fractions& u, const Fractions& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

/// Gauss's elimination. Each row has its right side as its last number. Returns: the solution, if there is exactly one.
inline std::optional<Fractions> solution_of(std::vector<Fractions> rows, std::size_t unknowns) {
  for (std::size_t i = 0; i < unknowns; ++i) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(std::min(i, rows.size())), rows.end(),
                                    [i](const Fractions& row) { return row[i] != 0; });
    if (pivot == rows.end()) return std::nullopt;
    std::swap(rows[i], *pivot);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k == i || rows[k][i] == 0) continue;
      const Fraction times = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j <= unknowns; ++j) rows[k][j] -= times * rows[i][j];
    }
  }
  for (std::size_t k = unknowns; k < rows.size(); ++k)
    if (rows[k][unknowns] != 0) return std::nullopt;
  Fractions x;
  for (std::size_t i = 0; i < unknowns; ++i) x.push_back(rows[i][unknowns] / rows[i][i]);
  return x;
}

/// Returns: the point of that index, or the mean of all; none where the index is none.
template <class S>
std::optional<Fractions> point_of(const PointSet<S>& set, int index) {
  const auto& points = set.points();
  if (index >= 0 && static_cast<std::size_t>(index) < points.size())
    return fractions(points[static_cast<std::size_t>(index)]);
  if (index != IndexPair::mean) return std::nullopt;
  Fractions mean(3);
  for (const Vec3<S>& p : points)
    for (std::size_t i = 0; i < 3; ++i) mean[i] += fractions(p)[i];
  for (Fraction& x : mean) x /= points.size();
  return mean;
}

/// `point_of`: makes of an object and a number the point that has it, or none.
/// Returns: these points of the difference; none where they are not 1 to `most`, or a number is none.
template <class Objects, class PointOf>
std::optional<std::vector<Fractions>> differences_of(const IndexPairs& pairs, int most, const Objects& a,
                                                     const Objects& b, const PointOf& point_of) {
  if (pairs.size() < 1 || pairs.size() > most) return std::nullopt;
  std::vector<Fractions> points;
  for (const auto& [i, j] : pairs) {
    const auto of_a = point_of(a, i), of_b = point_of(b, j);
    if (!of_a || !of_b) return std::nullopt;
    points.push_back(minus(*of_a, *of_b));
  }
  return points;
}

template <class S>
std::optional<std::vector<Fractions>> points_of(const IndexPairs& pairs, int most, const PointSet<S>& a,
                                                const PointSet<S>& b) {
  return differences_of(pairs, most, a, b, point_of<S>);
}

/// Returns: whether a·d < b·d for all points.
template <class S>
bool separates(const Fractions& d, const PointSet<S>& a, const PointSet<S>& b) {
  const auto along = [&](const Vec3<S>& p) { return dot(fractions(p), d); };
  Fraction farthest_of_a = along(a.points()[0]), nearest_of_b = along(b.points()[0]);
  for (const Vec3<S>& p : a.points()) farthest_of_a = std::max(farthest_of_a, along(p));
  for (const Vec3<S>& p : b.points()) nearest_of_b = std::min(nearest_of_b, along(p));
  return farthest_of_a < nearest_of_b;
}

}  // namespace detail

/// The point v of the line, plane or space through some points that is nearest to the origin, exactly. It is the sum of
/// these points times their weights, whose sum is 1.
struct NearestPoint {
  detail::Fractions v, weights;
};

namespace detail {

/// v = w₀ + Σ tₖ(wₖ − w₀), where every (wᵢ − w₀)·v is 0. Returns: nothing where the points depend on each other.
inline std::optional<NearestPoint> nearest_point_of(const std::vector<Fractions>& points) {
  std::vector<Fractions> edges, rows;
  for (std::size_t i = 1; i < points.size(); ++i) edges.push_back(minus(points[i], points[0]));
  for (const Fractions& edge : edges) {
    rows.emplace_back();
    for (const Fractions& other : edges) rows.back().push_back(dot(edge, other));
    rows.back().push_back(-dot(edge, points[0]));
  }
  const auto t = solution_of(std::move(rows), edges.size());
  if (!t) return std::nullopt;
  NearestPoint nearest{points[0], {1}};
  for (std::size_t k = 0; k < edges.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) nearest.v[i] += (*t)[k] * edges[k][i];
    nearest.weights[0] -= (*t)[k];
    nearest.weights.push_back((*t)[k]);
  }
  return nearest;
}

}  // namespace detail

/// Requires: finite sets. Returns: whether it proves of these two sets what it says.
template <class S>
bool holds(const SeparatingDirection& certificate, const PointSet<S>& a, const PointSet<S>& b) {
  return certificate.d.allFinite() && detail::separates(detail::fractions(certificate.d), a, b);
}

/// Returns: −v, exactly, v being the point nearest to the origin on the line or plane through these points. None where
/// these are no such points.
template <class S>
std::optional<detail::Fractions> direction_of(const SeparatingFeature& certificate, const PointSet<S>& a,
                                              const PointSet<S>& b) {
  const auto points = detail::points_of(certificate.of, 3, a, b);
  const auto nearest = points ? detail::nearest_point_of(*points) : std::nullopt;
  return nearest ? std::optional(detail::minus(detail::Fractions(3), nearest->v)) : std::nullopt;
}

template <class S>
bool holds(const SeparatingFeature& certificate, const PointSet<S>& a, const PointSet<S>& b) {
  const auto d = direction_of(certificate, a, b);
  return d && detail::separates(*d, a, b);
}

/// Returns: λ, exactly. Σ λₖwₖ = 0, where Σ λₖ = 1. None where these are no points with exactly one such λ.
template <class S>
std::optional<detail::Fractions> weights_of(const CommonSimplex& certificate, const PointSet<S>& a,
                                            const PointSet<S>& b) {
  const auto points = detail::points_of(certificate.of, 4, a, b);
  if (!points) return std::nullopt;
  std::vector<detail::Fractions> rows(4);
  for (const detail::Fractions& w : *points) {
    for (std::size_t i = 0; i < 3; ++i) rows[i].push_back(w[i]);
    rows[3].push_back(1);
  }
  for (std::size_t i = 0; i < 4; ++i) rows[i].push_back(i < 3 ? 0 : 1);
  return detail::solution_of(std::move(rows), points->size());
}

/// No λₖ < 0.
template <class S>
bool holds(const CommonSimplex& certificate, const PointSet<S>& a, const PointSet<S>& b) {
  const auto weights = weights_of(certificate, a, b);
  return weights && std::all_of(weights->begin(), weights->end(), [](const Fraction& x) { return x >= 0; });
}

template <class S>
bool holds(const Certificate& certificate, const PointSet<S>& a, const PointSet<S>& b) {
  return std::visit([&](const auto& each) { return holds(each, a, b); }, certificate);
}

}  // namespace gjk
