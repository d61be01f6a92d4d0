/// Triangles and tetrahedra, judged by CGAL's exact predicates.
#pragma once

#include <optional>

#include "tests/study/pairs/pairs.hpp"

namespace study {

/// Returns: nothing where either is not a triangle or a tetrahedron (3 or 4 points), or is flattened: three points on a
/// line, four in a plane; and where a coordinate is not finite.
std::optional<Truth> truth_by_cgal(const Points& a, const Points& b);

}  // namespace study
