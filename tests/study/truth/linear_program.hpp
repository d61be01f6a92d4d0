/// Do the hulls of two sets of points meet? A linear program, and what proves its answer to anyone who can multiply.
///
///   Σ λ_i a_i = Σ μ_j b_j,   Σ λ_i = 1,   Σ μ_j = 1,   all λ_i, μ_j >= 0
///
/// A solution is a point that the hulls have in common. Where there is none, a direction separates them (Farkas 1902).
/// CGAL's exact solver (Gärtner and Schönherr 2000) finds either one; and neither proof needs trust in how it was found.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/exact_number.hpp"

namespace study {

/// Exact: a fraction of whole numbers of any length.
using Rational = study::Exact;
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

/// Returns: a certificate that holds.
///
/// Errors: std::logic_error where the solver's does not; std::invalid_argument where a set is empty or a coordinate is not
/// finite.
Certificate certificate(const Points& a, const Points& b);

/// Returns: what the certificate proves. Errors: the same.
Truth truth_by_linear_program(const Points& a, const Points& b);

/// Returns: whether the hull holds the point. Errors: std::invalid_argument as above.
bool hull_contains(const Points& points, const RationalVec& point);

/// Returns: whether two hulls that meet would no longer do so, if one of them were moved in some direction, by however
/// little: the origin is not inside their difference. Requires: they meet. Errors: std::invalid_argument as above.
bool hulls_only_touch(const Points& a, const Points& b);

}  // namespace study
