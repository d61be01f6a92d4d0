/// The simplices of Figures 6-8. The report prints no coordinates; these have the letters where it has them.
#pragma once

#include "render/camera.hpp"
#include "walkthroughs/catalogue/region_grid.hpp"

namespace walkthroughs {

/// B at the left, A at the right.
inline Simplex figure_6_simplex() { return simplex_of({{-2, -0.6, 0}, {2, 0.6, 0}}); }
inline Window figure_6_window() { return {.low = {-6.6, -2.332}, .high = {6.6, 2.332}}; }

/// A on top, B at the left, C at the right: ABCn points to the reader.
inline Simplex figure_7_simplex() { return simplex_of({{1.4, -0.9, 0}, {-1.6, -0.9, 0}, {-0.2, 1.1, 0}}); }
inline Window figure_7_window() { return {.low = {-7.36, -2.3}, .high = {7.36, 2.9}}; }

/// BCD lies in the plane z = 0, counter-clockwise seen from above, B at the back; A lies above it.
inline Simplex figure_8_simplex() {
  return simplex_of({{1.5, -0.85, 0}, {-1.6, -0.85, 0}, {0.1, 1.6, 0}, {0.05, 0.4, 2.4}});
}
/// In front of the face ACD and a little to the right of it, so that the normals at its sides are seen.
inline render::Camera figure_8_camera() { return {-77, 13}; }
/// A third of the way from BCD to A.
inline Window figure_8_slice() { return {.low = {-4.5, -2.5}, .high = {4.5, 3.145}, .height = 0.8}; }

}  // namespace walkthroughs
