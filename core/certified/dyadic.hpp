/// Numbers that do not round and need no division: whole numbers, and these times a power of two. Needs
/// Boost.Multiprecision.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "boost_whole_numbers.hpp"
#include "bounded.hpp"

namespace gjk::detail {

/// Whole numbers of any length; those of ordinary coordinates fit 512 bits and need no heap.
using Whole = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>, boost::multiprecision::et_off>;

inline int sign_of(const Whole& x) { return x.sign(); }

/// A double as m·2^e, m odd; of zero m is 0.
struct BinaryFraction {
  std::int64_t m = 0;
  int e = 0;

  explicit BinaryFraction(double x) {
    if (x == 0) return;
    m = static_cast<std::int64_t>(std::frexp(x, &e) * 0x1p53);
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(m));
    m >>= zeros;
    e += zeros - 53;
  }
};

/// m·2^e. Every finite number of C++ is one, and so are sums and products of these.
struct Dyadic {
  Whole m = 0;
  int e = 0;

  Dyadic() = default;
  Dyadic(double x) {
    const BinaryFraction fraction(x);
    m = fraction.m;
    e = fraction.e;
  }
  /// A finer number, as the sum of doubles. Brought near 1 first: it may be beyond all doubles, or its last digits may.
  template <class N>
  requires(std::numeric_limits<N>::digits > std::numeric_limits<double>::digits) explicit Dyadic(N x) {
    int power = 0;
    for (x = std::frexp(x, &power); x != 0; x -= static_cast<double>(x)) *this = *this + Dyadic(static_cast<double>(x));
    e += power;
  }

  /// Requires: that it is one. Returns: the whole number that this is times 2^-exponent.
  Whole over_power(int exponent) const { return m == 0 ? Whole(0) : Whole(m << static_cast<unsigned>(e - exponent)); }

  friend Dyadic operator-(Dyadic x) {
    x.m = -x.m;
    return x;
  }
  friend Dyadic operator+(const Dyadic& x, const Dyadic& y) {
    if (x.m == 0 || y.m == 0) return x.m == 0 ? y : x;
    Dyadic sum;
    sum.e = std::min(x.e, y.e);
    sum.m = x.over_power(sum.e) + y.over_power(sum.e);
    return sum;
  }
  friend Dyadic operator-(const Dyadic& x, const Dyadic& y) { return x + -y; }
  friend Dyadic operator*(const Dyadic& x, const Dyadic& y) {
    Dyadic product;
    product.m = x.m * y.m;
    product.e = x.e + y.e;
    return product;
  }
};

inline int sign_of(const Dyadic& x) { return x.m.sign(); }

/// Returns: the exponent of the power of two at or below the size of x, which is not 0.
inline int exponent_of(const Dyadic& x) { return static_cast<int>(msb(abs(x.m))) + x.e; }

/// Returns: x times 2^-unit, in doubles. Requires: that it is not far above 1, so that the error covers what underflow
/// loses. What is cut off is less than 2^-61 of the number, and what is rounded is u of it.
inline Bounded near(const Dyadic& x, int unit) {
  if (x.m == 0) return {};
  const unsigned bits = static_cast<unsigned>(msb(abs(x.m))) + 1, cut = bits > 62 ? bits - 62 : 0;
  const auto highest = static_cast<std::int64_t>(Whole(abs(x.m)) >> cut);
  const double size = std::scalbn(static_cast<double>(highest), x.e + static_cast<int>(cut) - unit);
  const bool is_exact = cut == 0 && static_cast<std::int64_t>(static_cast<double>(highest)) == highest;
  const double lost = (is_exact ? 0 : 2 * roundoff * size) + (size < 0x1p-960 ? 1e-300 : 0);
  return {x.m < 0 ? -size : size, lost};
}

}  // namespace gjk::detail
