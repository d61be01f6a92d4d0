/// The objects of the report's figures. It prints neither their coordinates nor their measures.
#pragma once

#include <algorithm>

#include "render/camera.hpp"
#include "walkthroughs/catalogue/chord.hpp"
#include "walkthroughs/catalogue/region_grid.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::catalogue {

// The sets of Figure 1, all made of the unit circle around the origin.

/// What is taken out of the disk to make the crescent.
struct Bite {
  render::Vec2 center{0.65, 0};
  double radius = 0.55;
};

inline PlanarSet solid_disk() {
  return {"solid disk", [](const render::Vec2& p) { return p.norm() - 1; }};
}

inline PlanarSet circle() {
  return {"circle", [](const render::Vec2& p) { return std::abs(p.norm() - 1); }};
}

inline PlanarSet crescent() {
  return {"solid crescent",
          [](const render::Vec2& p) { return std::max(p.norm() - 1, Bite{}.radius - (p - Bite{}.center).norm()); }};
}

inline ChordSearch decide_convexity(const PlanarSet& set) { return deciding_chord(set, points_of_rings(1, 6, 48), 1); }

/// The pins of Figure 2, of which about half lie inside.
inline std::vector<render::Vec2> figure_2_pins() {
  return {{-8.5, 0.5}, {-6, 2.25},  {-5, -0.75}, {-4, -2}, {-1.75, 1}, {-0.75, -1}, {0, 2.75},
          {1.5, 0.25}, {2.5, -2.5}, {4, 1.5},    {5, -1},  {7, 2},     {8.5, -1.25}};
}

using PointSet = gjk::PointSet<double>;

// The triangles of Figure 3. Section 2.4 puts the points of C farthest along +x on the line x = -1 and those of D farthest
// along -x on x = 1; "multiple points could be selected" of both.

inline PointSet figure_3_C() { return PointSet({{-1, 1, 0}, {-1, -1, 0}, {-3, -0.5, 0}}); }

inline PointSet figure_3_D() { return PointSet({{1, -1, 0}, {1, 1, 0}, {2.5, 0.5, 0}}); }

// The objects behind Figure 4, chosen so that the search makes every move that Section 3.1.2 tells. A triangle and a
// quadrilateral with no parallel sides have a heptagon for a difference.

/// Two objects that intersect.
inline Scene figure_4_left_scene() {
  return {.name = "left",
          .a = {"triangle", points({{-1.25, 1.25, 0}, {0.5, 2.25, 0}, {2.25, 1.75, 0}})},
          .b = {"quadrilateral", points({{-1.5, -1.5, 0}, {-1.25, 2.25, 0}, {1, 0, 0}, {1.25, -1.75, 0}})}};
}

/// Two objects that do not.
inline Scene figure_4_right_scene() {
  return {.name = "right",
          .a = {"triangle", points({{-1, 2.5, 0}, {2.25, 0.5, 0}, {2.5, 2, 0}})},
          .b = {"quadrilateral", points({{0.25, -1, 0}, {0.5, -2, 0}, {-1.75, -2.5, 0}, {-0.75, 0, 0}})}};
}

// The simplices of Figures 6-8 have the letters where the report has them.

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

}  // namespace walkthroughs::catalogue
