/// Numbers of round bodies, in fractions; where there are roots, their squares are compared.
#pragma once

#include <cmath>
#include <stdexcept>

#include "tests/study/truth/linear_program.hpp"  // Rational

namespace study {

inline Rational fraction(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("the oracle needs finite numbers");
  return Rational(x);
}

inline Rational square(const Rational& x) { return x * x; }

inline Rational absolute(const Rational& x) { return x < 0 ? Rational(-x) : x; }

/// √S + √T >= √c_squared, for numbers that are not negative.
inline bool roots_reach(const Rational& S, const Rational& T, const Rational& c_squared) {
  const Rational rest = c_squared - S - T;
  return rest <= 0 || square(rest) <= 4 * S * T;
}

inline RationalVec difference(const Vec& p, const Vec& q) {
  RationalVec d;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    d[k] = fraction(p[i]) - fraction(q[i]);
  }
  return d;
}

/// The coordinate along the axis.
inline std::size_t along(const Can& can) {
  std::size_t axis = 3;
  for (std::size_t k = 0; k < 3; ++k)
    if (can.axis[static_cast<Eigen::Index>(k)] != 0) {
      if (axis != 3)
        axis = 4;
      else
        axis = k;
    }
  if (axis > 2) throw std::invalid_argument("the oracle judges only cylinders parallel to a coordinate axis");
  return axis;
}

/// How far |x| is beyond `reach`: 0 where it is not.
inline Rational beyond(const Rational& x, const Rational& reach) {
  const Rational over = absolute(x) - reach;
  return over > 0 ? over : Rational(0);
}

}  // namespace study
