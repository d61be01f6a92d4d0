/// The labelled outline of a planar difference set. GJK never needs it; only pictures do.
#pragma once

#include <string>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/scene.hpp"

namespace walkthroughs {

/// Corners counter-clockwise, named "A", "B", … from the corner farthest along +x (of two such, the upper), as in Figure 4.
struct LabelledHull {
  std::vector<render::Vec2> corners;

  /// Returns: the letter of the corner at `w`, or an empty string where there is none.
  std::string name(const Point& w) const;
};

/// Returns: the hull of all differences of the vertices, projected on the plane z = 0.
LabelledHull difference_hull(const Scene& scene);

}  // namespace walkthroughs
