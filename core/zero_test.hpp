/// When does a rounded product count as zero? Every decision of Algorithms 1-5 compares a product with zero. A zero
/// test says what the product counts as in that comparison. The only tolerance of the core lives here.
///
/// What a zero test needs to know of a product's factors is a Size. Products of vectors multiply their sizes as they
/// multiply their values (vectors.hpp). So no product can be tested with the factors of another.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include "shapes.hpp"

namespace gjk {

/// The report's: a product counts as it was computed.
struct ExactZeroTest {
  /// Nothing needs to be known.
  struct Size {
    friend constexpr Size operator*(Size, Size) { return {}; }
    /// Returns: what `product` counts as.
    template <class Product>
    const Product& snap(const Product& product) const {
      return product;
    }
  };
  /// Returns: the size of a vector, or of a vertex of the difference.
  template <class Factor>
  static constexpr Size size(const Factor&) {
    return {};
  }
};

/// A product counts as zero where it is below 16ε times the product of the lengths of its factors. ε is the scalar's
/// epsilon. Exact numbers round nothing: for them this is the exact test.
///
/// The length of AO is R = |a| + |b| here. Where sets touch, w = a - b is close to nothing, but it has inherited the
/// rounding of a and b.
///
/// What is compared is n·AO or w·d. It is the origin's distance from a plane times the length of the plane's normal. So
/// sets count as touching where no more than 16εR parts them. At a sharp corner it is more: the normal there is in
/// doubt by the reciprocal of the corner's sine.
///
/// Why 16. Let u = ε/2.
///  1. Rounding a and b costs uR, and subtracting them at most uR. So w is off by 2uR, and AB by 4uR.
///  2. The longest product is (AB×(AB×AC))·AO. It is then off by (3·4 + 2)uR|AB|²|AC| where the origin is no farther
///     than the sides are long.
///  3. Its own products and sums add no more than as much again: 28u = 14ε.
struct RelativeZeroTest {
  /// The lengths of a product's factors. They are multiplied one by one behind ε. So a tolerance overflows only where
  /// it lies above every finite product.
  template <std::floating_point S, std::size_t factors>
  struct Size {
    std::array<S, factors> lengths;

    /// Returns: what `product` counts as. What is not a number is not below any tolerance, and counts as it is.
    template <class Product>
    Product snap(const Product& product) const {
      S tolerance = 16 * std::numeric_limits<S>::epsilon();
      for (const S& each : lengths) tolerance *= each;
      return length(product) < tolerance ? Product(product - product) : product;
    }
  };

  template <class S>
  static auto size(const Vec3<S>& v) {
    return size_of_length(length(v));
  }
  template <class S>
  static auto size(const Vertex<S>& v) {
    return size_of_length(S(length(v.a.point) + length(v.b.point)));
  }

 private:
  template <class S>
  static auto size_of_length(const S& length) {
    if constexpr (std::floating_point<S>)
      return Size<S, 1>{{length}};
    else
      return ExactZeroTest::Size{};
  }

  /// Lengths are |x| + |y| + |z|, up to √3 times too long. This needs no square root, and no square overflows.
  template <class S>
  static S length(const Vec3<S>& v) {
    return length(v.x()) + length(v.y()) + length(v.z());
  }
  template <class S>
  static S length(const S& number) {
    using std::abs;
    return abs(number);
  }
};

/// The lengths are multiplied in the order of the formula, from the side of the simpler factor on:
///  - AB, AB, AC for AB×ABCn, which is AB×(AB×AC);
///  - AC, AC, AB for ABCn×AC, which is (AB×AC)×AC.
template <std::floating_point S, std::size_t n, std::size_t m>
RelativeZeroTest::Size<S, n + m> operator*(const RelativeZeroTest::Size<S, n>& u,
                                           const RelativeZeroTest::Size<S, m>& v) {
  RelativeZeroTest::Size<S, n + m> product;
  for (std::size_t i = 0; i < n + m; ++i) {
    const S& length = i < n ? u.lengths[i] : v.lengths[i - n];
    product.lengths[n <= m ? i : n + m - 1 - i] = length;
  }
  return product;
}

}  // namespace gjk
