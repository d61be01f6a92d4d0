/// Anti-aliasing of convex polygons: which share of each pixel a polygon covers.
///
/// The coverage of a pixel with middle `p` is the least of these linear functions of `p`:
///  * per edge, the distance of `p` inside the edge + 1/2: a ramp one pixel wide across the edge;
///  * per sharp corner, a ramp along its bisector, which lets the tip fade out instead of growing past the corner;
///  * the width of the polygon, at most 1: a strip narrower than a pixel never covers a whole one.
/// Beside edges along the axes, however close together, this is exactly the area of the pixel inside the polygon.
/// The least of linear functions is linear on convex cells, and these cells tile the polygon: no cracks, no overlaps,
/// and each is drawn with nothing but interpolation.
#pragma once

#include <span>
#include <vector>

#include "render/geometry.hpp"

namespace render {

struct CoveragePoint {
  Vec2 position;    ///< pixels
  double coverage;  ///< 0..1
};

/// A convex polygon over which the coverage is linear.
using CoverageCell = std::vector<CoveragePoint>;

/// Requires: finite corners, in pixels, of a convex polygon of either sense.
/// Returns: the cells inside `bounds` whose coverage is not 0; none for a polygon without area.
std::vector<CoverageCell> coverage_cells(std::span<const Vec2> corners, const Box& bounds);

}  // namespace render
