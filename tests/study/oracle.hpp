/// The truth about a pair, found exactly and in other ways than GJK's: neither support functions nor a simplex.
///
/// Numbers are taken as they stand: every double is a fraction. Triangles and tetrahedra are asked of CGAL's exact
/// predicates; larger sets of points of an exact linear program, whose answer comes with a certificate that is checked;
/// balls, and cylinders whose axes are parallel to coordinate axes, of formulas in fractions.
#pragma once

#include "tests/study/pair.hpp"

namespace study {

/// Do the two closed sets have a point in common?
///
/// Errors: std::logic_error where a certificate does not hold; std::invalid_argument for a pair that it cannot judge:
/// a number that is not finite, a cylinder askew, a round body against points.
Truth truth(const Pair& pair);

}  // namespace study
