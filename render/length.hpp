/// How long vectors are whose squares may overflow or vanish.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace render {

/// Returns: the length, rounded alike wherever the vector stands in memory. That of Eigen's stableNorm() differs in the last digit
/// between addresses that are multiples of 16 and others.
template <class Expression>
double length_of(const Eigen::MatrixBase<Expression>& expression) {
  const typename Expression::PlainObject vector = expression;
  constexpr double least = std::numeric_limits<double>::min();  // the quotient of 1 and less may be infinite
  const double size = std::max(vector.cwiseAbs().maxCoeff(), least);
  if (size > std::numeric_limits<double>::max()) return size;
  return size * (vector * (1 / size)).norm();
}

}  // namespace render
