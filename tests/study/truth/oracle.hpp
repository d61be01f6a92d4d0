/// The truth about a pair, found exactly and in other ways than GJK's: neither support functions nor a simplex.
///
/// Numbers are taken as they stand: every double is a fraction. Triangles and tetrahedra are asked of CGAL's exact
/// predicates; other sets of points of a linear program, whose answer a certificate proves in fractions; balls, and cylinders
/// whose axes are parallel to coordinate axes, of formulas in fractions.
#pragma once

#include "tests/study/truth/judgement.hpp"

namespace study {

/// Do the two closed sets have a point in common?
///
/// Errors: std::logic_error where a certificate does not hold; std::invalid_argument for a pair that it cannot judge:
/// a number that is not finite, a cylinder askew, a round body against points.
Judgement judge(const Pair& pair);

inline Truth truth(const Pair& pair) { return judge(pair).truth; }

}  // namespace study
