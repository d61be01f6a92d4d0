/// Answers found in other ways than the algorithm's: with linear equations in place of cross products, in exact numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/core/support.hpp"

namespace gjk::test {

using ExactVec = Vec3<Rational>;
using ExactVecs = std::vector<ExactVec>;

/// Floating-point numbers are fractions; nothing is lost.
template <class S>
ExactVec exact(const Vec3<S>& v) {
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

template <class S>
ExactVecs exact(const std::vector<Vec3<S>>& vs) {
  ExactVecs converted;
  for (const Vec3<S>& v : vs) converted.push_back(exact(v));
  return converted;
}

inline ExactVec times(const Rational& s, const ExactVec& v) { return {s * v[0], s * v[1], s * v[2]}; }

/// The matrix of all dot products of the edges that leave the first point.
inline std::vector<std::vector<Rational>> gram_matrix(const ExactVecs& points) {
  std::vector<std::vector<Rational>> gram;
  for (std::size_t i = 1; i < points.size(); ++i) {
    gram.emplace_back();
    for (std::size_t j = 1; j < points.size(); ++j)
      gram.back().push_back((points[i] - points[0]).dot(points[j] - points[0]));
  }
  return gram;
}

/// Triangular form without pivoting, which a Gram matrix allows. Returns: its determinant, 0 exactly where the points
/// depend on each other.
inline Rational eliminate(std::vector<std::vector<Rational>>& matrix, std::vector<Rational>& right_side) {
  Rational determinant = 1;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    determinant *= matrix[k][k];
    if (determinant == 0) return determinant;
    for (std::size_t i = k + 1; i < matrix.size(); ++i) {
      const Rational factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < matrix.size(); ++j) matrix[i][j] -= factor * matrix[k][j];
      right_side[i] -= factor * right_side[k];
    }
  }
  return determinant;
}

/// |AB|² for an edge, 4 area² for a triangle, 36 volume² for a tetrahedron.
inline Rational gram_determinant(const ExactVecs& points) {
  auto gram = gram_matrix(points);
  std::vector<Rational> unused(gram.size());
  return eliminate(gram, unused);
}

/// Barycentric coordinates, one per point, of the place nearest to the origin on the line, plane or space through
/// `points`. A coordinate is negative exactly where that place lies beyond the feature opposite to its point.
///
/// Requires: the points are affinely independent.
inline std::vector<Rational> coordinates_of_origin(const ExactVecs& points) {
  auto gram = gram_matrix(points);
  std::vector<Rational> right_side;
  for (std::size_t i = 1; i < points.size(); ++i) right_side.push_back(-points[0].dot(points[i] - points[0]));
  eliminate(gram, right_side);
  std::vector<Rational> coordinates(points.size());
  for (std::size_t i = gram.size(); i-- > 0;) {
    Rational rest = right_side[i];
    for (std::size_t j = i + 1; j < gram.size(); ++j) rest -= gram[i][j] * coordinates[j + 1];
    coordinates[i + 1] = rest / gram[i][i];
  }
  coordinates[0] = Rational(1) - std::accumulate(coordinates.begin() + 1, coordinates.end(), Rational(0));
  return coordinates;
}

/// From the line, plane or space through `points` straight to the origin.
inline ExactVec toward_origin(const ExactVecs& points) {
  const std::vector<Rational> coordinates = coordinates_of_origin(points);
  ExactVec vector = ExactVec::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) vector -= times(coordinates[i], points[i]);
  return vector;
}

/// Where the origin is in a hull, it is in the hull of independent points among them (Carathéodory).
inline bool contain_origin(const ExactVecs& points) {
  for (std::uint32_t chosen = 1; chosen < (1u << points.size()); ++chosen) {
    ExactVecs subset;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (chosen & (1u << i)) subset.push_back(points[i]);
    if (subset.size() > 4 || gram_determinant(subset) == 0) continue;
    const auto coordinates = coordinates_of_origin(subset);
    const bool inside = std::all_of(coordinates.begin(), coordinates.end(), [](const Rational& c) { return c >= 0; });
    if (inside && toward_origin(subset) == ExactVec(ExactVec::Zero())) return true;
  }
  return false;
}

/// Six times the signed volume of A, B, C, D: positive where A lies on the side of BC×BD. Written out by Sarrus.
inline Rational orientation(const ExactVec& A, const ExactVec& B, const ExactVec& C, const ExactVec& D) {
  const ExactVec u = C - B, v = D - B, w = A - B;
  return u[0] * v[1] * w[2] + u[1] * v[2] * w[0] + u[2] * v[0] * w[1] - u[2] * v[1] * w[0] - u[0] * v[2] * w[1] -
         u[1] * v[0] * w[2];
}

/// Returns: whether `d` points where `expected` points, up to `sine` of the angle between them.
inline bool same_direction(const ExactVec& d, const ExactVec& expected, const Rational& sine) {
  const Rational dot = d.dot(expected), lengths = d.dot(d) * expected.dot(expected);
  return dot > 0 && lengths - dot * dot <= sine * sine * lengths;  // sin² = 1 - cos²
}

/// How far a computed direction may turn away from the exact one: not at all, or by a few roundings, which the
/// differences between the points of these tests enlarge at most a hundredfold.
template <class S>
Rational allowed_sine() {
  if constexpr (std::floating_point<S>) return Rational(100) * Rational(std::numeric_limits<S>::epsilon());
  return 0;
}

}  // namespace gjk::test
