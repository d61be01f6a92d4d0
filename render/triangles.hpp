/// The shapes of a canvas as the one triangle list that the rasterizer draws.
///
/// Edges are anti-aliased by coverage computed from the distance to the edge (256 levels, no multisampling).
#pragma once

#include <cstdint>
#include <vector>

#include "render/canvas.hpp"

namespace render {

/// `u` and `v` mean what `kind` says.
struct CanvasVertex {
  enum class Kind : std::uint32_t {
    fill,     ///< u: coverage (see coverage.hpp)
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

}  // namespace render
