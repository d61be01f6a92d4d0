/// Hulls of points in space.
#pragma once

#include <vector>

#include "render/camera.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

/// Qhull. Returns: the faces of the hull of points in space, coplanar triangles joined; none where the points are flat.
std::vector<render::Face> hull_faces(const std::vector<Point>& points);

}  // namespace walkthroughs
