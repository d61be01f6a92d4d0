/// The triangles of Figure 3. The report prints no coordinates. Its Section 2.4 puts the points of C farthest along +x on
/// the line x = -1 and those of D farthest along -x on x = 1; "multiple points could be selected" of both.
#pragma once

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

using PointSet = gjk::PointSet<double>;

inline PointSet figure_3_C() { return PointSet({{-1, 1, 0}, {-1, -1, 0}, {-3, -0.5, 0}}); }

inline PointSet figure_3_D() { return PointSet({{1, -1, 0}, {1, 1, 0}, {2.5, 0.5, 0}}); }

}  // namespace walkthroughs
