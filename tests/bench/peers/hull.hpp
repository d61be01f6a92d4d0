/// The faces of a hull, for libraries that want them.
#pragma once

#include <array>
#include <vector>

#include "tests/study/pair.hpp"

namespace peers {

/// Qhull. Returns: the hull's faces as triangles of positions in `points`, counter-clockwise seen from outside; none where
/// the points are flat or one of them is no corner.
std::vector<std::array<int, 3>> faces_of_hull(const study::Points& points);

}  // namespace peers
