/// The expressions of a trace, such as "AB×AO×AB" and "ABCn·AO", computed anew together with how far rounding may have
/// moved them: running error analysis after Wilkinson. Another compiler may add three products in another order, so a
/// number in a trace is held to this bound and not to its last bit.
#pragma once

#include <string_view>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

/// A vector; `error` bounds that of each component.
struct RoundedVector {
  Point value;
  double error = 0;
};

struct RoundedScalar {
  double value;
  double error = 0;

  bool may_be_negative() const { return value - error < 0; }
  bool may_be_positive_or_zero() const { return value + error >= 0; }
};

/// Computed in `scalar`, of which u and v are.
RoundedScalar dot(const RoundedVector& u, const RoundedVector& v, Scalar scalar);

/// `expression`: differences XY of the letters of `simplex` and O, normals XYZn = XY×XZ, their products from left to right,
/// with a minus before them or not; computed in `scalar`, of which the vertices are. Requires: all its letters are roles in
/// `simplex`.
RoundedVector evaluate(std::string_view expression, const gjk::Simplex<double>& simplex, Scalar scalar);

/// Returns: |w| as a zero test takes it: the lengths of a and b, which w = a - b has its rounding from.
double length_of(const gjk::Vertex<double>& vertex);

/// Returns: the product of the lengths of all vectors in an expression; that of AO is the length of A.
double size_of(std::string_view expression, const gjk::Simplex<double>& simplex);

/// Returns: whether a product of that size, computed in `scalar`, may count as zero by the relative zero test.
bool may_count_as_zero(double product, double size, Scalar scalar);
bool may_count_as_zero(const Point& product, double size, Scalar scalar);

/// Returns: whether a recorded number may be that value. Both were rounded, so twice the bound is allowed; a number that is
/// not finite can only stand for another such.
bool agrees(double recorded, const RoundedScalar& value);
bool agrees(const Point& recorded, const RoundedVector& value);

/// Returns: whether the two are the identical double; the sign of zero counts, that of NaN does not.
bool is_identical(double x, double y);
bool is_identical(const Point& p, const Point& q);

}  // namespace walkthroughs
