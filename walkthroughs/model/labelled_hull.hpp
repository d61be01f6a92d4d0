/// Hulls in the plane, and the letters of their corners.
#pragma once

#include <string>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::model {

/// Andrew's monotone chain (Inf. Proc. Letters 9, 1979).
/// Returns: the corners of the hull, counter-clockwise from the leftmost (of two such, the lower), without collinear points.
std::vector<render::Vec2> convex_hull(std::vector<render::Vec2> points);

/// Returns: the corners of the sum of two hulls, all p + q, as convex_hull() would give them. Requires: hulls that begin and
/// turn as those of convex_hull(), not empty.
std::vector<render::Vec2> sum_of_hulls(const std::vector<render::Vec2>& a, const std::vector<render::Vec2>& b);

/// The hull of a planar difference of point sets, its corners counter-clockwise, named "A", "B", … from the one farthest
/// along +x (of two such, the upper), as in Figure 4.
struct LabelledHull {
  std::vector<render::Vec2> corners;

  /// Returns: the letter of the corner at `w`, or an empty string where there is none.
  std::string name(const Point& w) const;
};

/// Returns: all p - q of two lists.
std::vector<Point> differences(const std::vector<Point>& a, const std::vector<Point>& b);

/// Returns: the hull of all differences of the vertices, projected on the plane z = 0.
LabelledHull difference_hull(const Scene& scene);

}  // namespace walkthroughs::model
