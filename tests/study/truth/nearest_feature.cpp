#include "tests/study/truth/nearest_feature.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/study/truth/exact_number.hpp"

namespace study {
namespace {

using Rational = study::Exact;

/// A value, and how large the terms were that it is a sum of: its error is at most a few roundings of `terms`.
struct Estimate {
  long double value = 0, terms = 0;

  explicit Estimate(double x) : value(x), terms(std::fabs(value)) {}
  Estimate(long double v, long double t) : value(v), terms(t) {}
  friend Estimate operator+(const Estimate& x, const Estimate& y) { return {x.value + y.value, x.terms + y.terms}; }
  friend Estimate operator-(const Estimate& x, const Estimate& y) { return {x.value - y.value, x.terms + y.terms}; }
  friend Estimate operator*(const Estimate& x, const Estimate& y) { return {x.value * y.value, x.terms * y.terms}; }
};

/// No expression here has more than 100 operations one after the other, and each rounds by at most half an epsilon of
/// `terms`. Underflow loses more: then `terms` is tiny itself.
bool sign_is_certain(const Estimate& x) {
  return std::fabs(x.value) > 100 * std::numeric_limits<long double>::epsilon() * x.terms && std::isfinite(x.terms) &&
         x.terms > std::numeric_limits<long double>::min() / std::numeric_limits<long double>::epsilon();
}

template <class N>
using Triple = std::array<N, 3>;

template <class N>
N dot(const Triple<N>& u, const Triple<N>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
template <class N>
Triple<N> minus(const Triple<N>& u, const Triple<N>& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}
template <class N>
N volume(const Triple<N>& u, const Triple<N>& v, const Triple<N>& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// The vertices as numbers of type N, and the origin as the last of them.
template <class N>
class Numbers {
 public:
  explicit Numbers(const gjk::Simplex<double>& simplex) {
    for (int i = 0; i < simplex.size(); ++i) {
      const auto& w = simplex.point(static_cast<gjk::Role>(i));
      points_.push_back({N(w[0]), N(w[1]), N(w[2])});
    }
    points_.push_back({N(0.0), N(0.0), N(0.0)});
  }
  /// From vertex x to vertex y.
  Triple<N> operator()(std::size_t x, std::size_t y) const { return minus(points_[y], points_[x]); }

 private:
  std::vector<Triple<N>> points_;
};

/// Tells on which side of its features the origin lies.
class Sides {
 public:
  explicit Sides(const gjk::Simplex<double>& simplex)
      : simplex_(simplex), estimates_(simplex), size_(static_cast<std::size_t>(simplex.size())) {}

  std::size_t size() const { return size_; }

  /// Returns: the sign of XY·XO.
  int along(std::size_t X, std::size_t Y) const {
    return sign([=, O = size_](const auto& v) { return dot(v(X, Y), v(X, O)); });
  }

  /// Returns: the sign of Y'·O', where ' is the part perpendicular to the edge VX: positive where the origin lies on
  /// the side of the edge that Y lies on. X' for X seen from V is X - (X·VX / VX·VX) VX.
  int beside(std::size_t V, std::size_t X, std::size_t Y) const {
    return sign([=, O = size_](const auto& v) {
      const auto VX = v(V, X), VY = v(V, Y), VO = v(V, O);
      return dot(VX, VX) * dot(VY, VO) - dot(VX, VY) * dot(VX, VO);
    });
  }

  /// Returns: on which side of the plane VXY the vertex or origin P lies.
  int above(std::size_t V, std::size_t X, std::size_t Y, std::size_t P) const {
    return sign([=](const auto& v) { return volume(v(V, X), v(V, Y), v(V, P)); });
  }

 private:
  template <class Expression>
  int sign(Expression&& expression) const {
    const Estimate estimate = expression(estimates_);
    if (sign_is_certain(estimate)) return estimate.value > 0 ? 1 : -1;
    const Rational value = expression(Numbers<Rational>(simplex_));
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  }

  const gjk::Simplex<double>& simplex_;
  Numbers<Estimate> estimates_;
  std::size_t size_;
};

bool nearest_is_vertex(const Sides& sides, std::size_t V) {
  for (std::size_t X = 0; X < sides.size(); ++X)
    if (X != V && sides.along(V, X) > 0) return false;
  return true;
}

bool nearest_is_edge(const Sides& sides, std::size_t V, std::size_t X) {
  if (sides.along(V, X) <= 0 || sides.along(X, V) <= 0) return false;
  for (std::size_t Y = 0; Y < sides.size(); ++Y)
    if (Y != V && Y != X && sides.beside(V, X, Y) > 0) return false;
  return true;
}

bool lies_over_triangle(const Sides& sides, std::size_t V, std::size_t X, std::size_t Y) {
  return sides.beside(V, X, Y) > 0 && sides.beside(X, Y, V) > 0 && sides.beside(Y, V, X) > 0;
}

/// The face opposite to Z. The origin lies over it where it and Z are on different sides of its plane.
bool nearest_is_face(const Sides& sides, std::size_t Z) {
  const std::size_t V = (Z + 1) % 4, X = (Z + 2) % 4, Y = (Z + 3) % 4;
  return sides.above(V, X, Y, sides.size()) * sides.above(V, X, Y, Z) <= 0 && lies_over_triangle(sides, V, X, Y);
}

bool lies_inside(const Sides& sides) {
  for (std::size_t Z = 0; Z < 4; ++Z) {
    const std::size_t V = (Z + 1) % 4, X = (Z + 2) % 4, Y = (Z + 3) % 4;
    if (sides.above(V, X, Y, 4) * sides.above(V, X, Y, Z) <= 0) return false;
  }
  return true;
}

}  // namespace

std::string letters(Feature feature) {
  std::string names;
  for (int i = 0; i < 4; ++i)
    if (feature >> i & 1U) names += gjk::letter(static_cast<gjk::Role>(i));
  return names;
}

Feature nearest_feature(const gjk::Simplex<double>& simplex) {
  const Sides sides(simplex);
  const std::size_t n = sides.size();
  for (std::size_t V = 0; V < n; ++V)
    if (nearest_is_vertex(sides, V)) return 1U << V;
  for (std::size_t V = 0; V < n; ++V)
    for (std::size_t X = V + 1; X < n; ++X)
      if (nearest_is_edge(sides, V, X)) return 1U << V | 1U << X;
  if (n == 3) return lies_over_triangle(sides, 0, 1, 2) ? 7 : 0;
  if (n < 3) return 0;
  for (std::size_t Z = 0; Z < 4; ++Z)
    if (nearest_is_face(sides, Z)) return 15U & ~(1U << Z);
  return lies_inside(sides) ? 15 : 0;
}

bool lies_on(const gjk::Simplex<double>& simplex, Feature feature) {
  const Sides sides(simplex);
  const std::size_t O = sides.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < O; ++i)
    if (feature >> i & 1U) corners.push_back(i);
  switch (corners.size()) {
    case 1: return sides.along(corners[0], O) == 0;                          // |AO|²
    case 2: return sides.beside(corners[0], corners[1], O) == 0;             // |AO'|², ' across the edge
    case 3: return sides.above(corners[0], corners[1], corners[2], O) == 0;  // in the plane
    default: return true;
  }
}

bool lies_toward(const gjk::Simplex<double>& simplex, gjk::Role X, gjk::Role Y) {
  return Sides(simplex).along(static_cast<std::size_t>(X), static_cast<std::size_t>(Y)) > 0;
}

}  // namespace study
