/// Every answer brings its evidence; here it is examined without the algorithm.
#pragma once

#include "tests/core/oracle.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {

/// No point of the difference lies farther along `d` than `limit`.
template <class S>
bool difference_stays_below(const Points& a, const Points& b, const Vec3<S>& d, const S& limit) {
  for (const Point& p : a)
    for (const Point& q : b)
      if ((exact(vec<S>(p)) - exact(vec<S>(q))).dot(exact(d)) > Rational(limit)) return false;
  return true;
}

/// Requires: coordinates so small that `S` computes exactly.
template <class S>
void require_evidence(const Result<S>& result, const Points& a, const Points& b) {
  REQUIRE(result.separation.has_value() == (result.status == Status::separated));
  if (result.separation) {
    REQUIRE(result.separation->support_value < S(0));
    REQUIRE(difference_stays_below(a, b, result.separation->direction, result.separation->support_value));
  }
  if (result.status == Status::intersecting) REQUIRE(contain_origin(exact(places(result.simplex))));
}

}  // namespace gjk::test
