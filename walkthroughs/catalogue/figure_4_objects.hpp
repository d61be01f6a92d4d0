/// The objects behind Figure 4. The report prints its two difference sets but neither their coordinates nor the objects;
/// these were chosen so that the search makes every move that Section 3.1.2 tells. A triangle and a quadrilateral
/// with no parallel sides have a heptagon for a difference.
#pragma once

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

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

}  // namespace walkthroughs
