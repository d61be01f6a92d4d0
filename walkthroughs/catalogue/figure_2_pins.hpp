/// The pins of Figure 2. The report prints no coordinates; these leave about half of the pins inside.
#pragma once

#include <vector>

#include "render/geometry.hpp"

namespace walkthroughs {

inline std::vector<render::Vec2> figure_2_pins() {
  return {{-8.5, 0.5}, {-6, 2.25},  {-5, -0.75}, {-4, -2}, {-1.75, 1}, {-0.75, -1}, {0, 2.75},
          {1.5, 0.25}, {2.5, -2.5}, {4, 1.5},    {5, -1},  {7, 2},     {8.5, -1.25}};
}

}  // namespace walkthroughs
