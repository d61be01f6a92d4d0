/// A number that knows its error (dynamic error bound), and vectors of it or of any other number. That is enough to take
/// the sign of a polynomial.
#pragma once

#include <cmath>
#include <limits>

namespace gjk::detail {

/// u, half the distance from 1 to the next number. Rounding to nearest moves a number by at most u times its size.
template <class S>
inline constexpr double roundoff_of = std::numeric_limits<S>::epsilon() / 2.0;
inline constexpr double roundoff = roundoff_of<double>;

/// The number that is meant lies within `error` of `value`.
///  - An operation rounds its value by u|value|. It rounds its error by less than 16u of it (six operations at most).
///  - What underflow loses is far below 1e-300: each product at most 2^-1075, and no sum.
///  - Where something overflows the error is infinite or not a number, and no sign is certain.
template <class N>
struct BoundedNumber {
  static constexpr N u = std::numeric_limits<N>::epsilon() / 2;

  N value = 0, error = 0;

  /// Returns: whether the number that is meant has the sign of `value`. Without an error it has: zero is a sign, too.
  bool has_certain_sign() const { return std::abs(value) > error || error == 0; }

  friend BoundedNumber operator-(const BoundedNumber& x) { return {-x.value, x.error}; }
  friend BoundedNumber operator+(const BoundedNumber& x, const BoundedNumber& y) {
    const N value = x.value + y.value;
    return {value, (x.error + y.error + u * std::abs(value)) * (1 + 16 * u)};
  }
  friend BoundedNumber operator-(const BoundedNumber& x, const BoundedNumber& y) { return x + -y; }
  /// xy − v₁v₂ = v₁ε₂ + v₂ε₁ + ε₁ε₂, where x = v₁ + ε₁ and y = v₂ + ε₂.
  friend BoundedNumber operator*(const BoundedNumber& x, const BoundedNumber& y) {
    const N value = x.value * y.value;
    const N carried = std::abs(x.value) * y.error + (std::abs(y.value) + y.error) * x.error;
    return {value, (carried + u * std::abs(value)) * (1 + 16 * u) + N(1e-300)};
  }
};

using Bounded = BoundedNumber<double>;

/// −1, 0 or 1. Requires: a certain sign.
template <class N>
int sign_of(const BoundedNumber<N>& x) {
  return x.value > 0 ? 1 : x.value < 0 ? -1 : 0;
}

/// A vector of any numbers that can be added and multiplied. Eigen would want to know more of them.
template <class N>
struct Triple {
  N x, y, z;

  friend Triple operator-(const Triple& p) { return {-p.x, -p.y, -p.z}; }
  friend Triple operator-(const Triple& p, const Triple& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  friend Triple operator*(const N& s, const Triple& p) { return {s * p.x, s * p.y, s * p.z}; }
};

template <class N>
N dot(const Triple<N>& p, const Triple<N>& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
template <class N>
Triple<N> cross(const Triple<N>& p, const Triple<N>& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

}  // namespace gjk::detail
