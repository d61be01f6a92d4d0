/// The shapes of a canvas as the one triangle list that the rasterizer draws.
///
/// Edges are anti-aliased by coverage computed from the distance to the edge (256 levels, no multisampling).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/canvas.hpp"

namespace render {

/// `u` and `v` mean what `kind` says.
struct CanvasVertex {
  enum class Kind : std::uint32_t {
    fill,     ///< u: coverage (see below)
    capsule,  ///< (u,v): position along and across, in pixels, from the middle of a line with round caps
    ring,     ///< (u,v): position in pixels from the middle of a circle line
    glyph,    ///< (u,v): position in the font's atlas, in texels
  };
  float x, y;  ///< pixels from the top left corner of the image
  float u, v;
  float half_length;  ///< of a capsule, in pixels, 0 for a disc; for a ring the radius of the circle
  float radius;       ///< of capsule and ring: half the width of the line, in pixels
  Color color;
  Kind kind;
};

/// Triangles in drawing order, in runs that share a clip rectangle.
struct Triangles {
  struct Run {
    int first = 0;                                 ///< index of the first vertex
    int left = 0, top = 0, right = 0, bottom = 0;  ///< clip rectangle in pixels
  };
  std::vector<CanvasVertex> vertices;
  std::vector<Run> runs;
};

/// Returns: what is seen of the shapes. The glyphs of their texts are in the font's atlas then.
Triangles triangles_of(const Canvas& canvas);

// -- Coverage: which share of each pixel a convex polygon covers --
//
// The coverage of a pixel with middle `p` is the least of these linear functions of `p`:
//  * per edge, the distance of `p` inside the edge + 1/2: a ramp one pixel wide across the edge;
//  * per sharp corner, a ramp along its bisector, which lets the tip fade out instead of growing past the corner;
//  * the width of the polygon, at most 1: a strip narrower than a pixel never covers a whole one.
// Beside edges along the axes, however close together, this is exactly the area of the pixel inside the polygon.
// The least of linear functions is linear on convex cells, and these cells tile the polygon: no cracks, no overlaps,
// and each is drawn with nothing but interpolation.

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
