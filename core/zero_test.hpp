/// When does a rounded product count as zero? Every decision of Algorithms 1-5 compares a product with zero; a zero test
/// says what the product counts as in that comparison. The only tolerance of the core lives here.
#pragma once

#include <cmath>
#include <limits>

#include "shapes.hpp"

namespace gjk {

/// The report's: a product counts as it was computed.
struct ExactZeroTest {
  /// Returns: what `product` counts as. `factors`: the vectors whose product it is, or vertices of the difference.
  template <class Product, class... Factors>
  static const Product& snap(const Product& product, const Factors&...) {
    return product;
  }
};

/// A product counts as zero where it is below 16ε times the product of the lengths of its factors, ε being the scalar's
/// epsilon. Exact numbers round nothing: for them this is the exact test.
///
/// The length of AO is R = |a| + |b| here: where sets touch, w = a - b is close to nothing, but it has inherited the
/// rounding of a and b. What is compared, n·AO or w·d, is the origin's distance from a plane times the length of the
/// plane's normal. So sets count as touching where no more than 16εR parts them; more at a sharp corner, whose normal is
/// in doubt by the reciprocal of the corner's sine.
///
/// Why 16. Let u = ε/2. Rounding a and b costs uR and subtracting them at most uR, so w is off by 2uR, and AB by 4uR. The
/// longest product, AB×(AB×AC)·AO, is then off by (3·4 + 2)uR|AB|²|AC| where the origin is no farther than the sides are
/// long, and its own products and sums add no more than as much again: 28u = 14ε.
struct RelativeZeroTest {
  template <class Product, class... Factors>
  static Product snap(const Product& product, const Factors&... factors) {
    using S = decltype(length(product));
    if constexpr (!std::floating_point<S>) {
      return product;
    } else {
      // ε first, so that a tolerance overflows only where it lies above every finite product.
      const S tolerance = ((16 * std::numeric_limits<S>::epsilon()) * ... * length(factors));
      return length(product) < tolerance ? Product(product - product) : product;
    }
  }

 private:
  /// Lengths are |x| + |y| + |z|, up to √3 times too long: no square root, no square that overflows.
  template <class S>
  static S length(const Vec3<S>& v) {
    return length(v.x()) + length(v.y()) + length(v.z());
  }
  template <class S>
  static S length(const Vertex<S>& v) {
    return length(v.a.point) + length(v.b.point);
  }
  template <class S>
  static S length(const S& number) {
    return std::abs(number);
  }
};

}  // namespace gjk
