/// Do the hulls of two sets of points meet? A linear program, and what proves its answer to anyone who can multiply.
///
///   minimize    |p - q|₁  (the sum of the absolute coordinates)
///   subject to  p a convex combination of A's points, q of B's
///
/// Its least value is 0 exactly where the hulls have a point in common. Its dual is a direction d with coordinates from
/// -1 to 1 and the widest gap min_A a·d - max_B b·d, which is as wide as that least value. So either the weights of a
/// common point or a separating direction prove the answer, and neither proof needs trust in how it was found.
#pragma once

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "tests/study/truth/judgement.hpp"

namespace study {

/// Exact: a fraction of whole numbers of any length.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using RationalVec = std::array<Rational, 3>;

/// The weight of one of a list's points in a convex combination.
struct Weight {
  std::size_t index;
  Rational weight;
};

/// The same point, as a combination of A's points and as one of B's.
struct CommonPoint {
  std::vector<Weight> of_a, of_b;
};

/// min_A a·d > max_B b·d.
struct SeparatingDirection {
  RationalVec d;
};

using Certificate = std::variant<CommonPoint, SeparatingDirection>;

/// Multiplied out in fractions. Returns: whether it proves what it says.
bool holds(const CommonPoint& common, const Points& a, const Points& b);
bool holds(const SeparatingDirection& separating, const Points& a, const Points& b);

/// In fractions, beginning where the same method in floating point ended.
///
/// Requires: neither set is empty; all coordinates are finite.
Certificate solve_exactly(const Points& a, const Points& b);

/// In floating point, with a bound on its error that proves the answer. Returns: nothing where the bound is too wide, as
/// where the sets touch.
std::optional<Truth> solve_within_bounds(const Points& a, const Points& b);

/// The quick way where it is enough, else the exact one.
///
/// Errors: std::logic_error where the certificate does not hold; std::invalid_argument where a set is empty or a
/// coordinate is not finite.
Judgement judged_by_linear_program(const Points& a, const Points& b);
/// In fractions, whatever bounds would say. Errors: the same.
Judgement judged_in_fractions(const Points& a, const Points& b);
inline Truth truth_by_linear_program(const Points& a, const Points& b) { return judged_by_linear_program(a, b).truth; }

}  // namespace study
