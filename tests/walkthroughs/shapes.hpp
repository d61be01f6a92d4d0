/// Shapes around the origin whose pictures tests know.
#pragma once

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::test {

/// From −x to x, and so on.
inline model::Points box(double x, double y, double z) {
  model::Points corners;
  for (const double i : {-x, x})
    for (const double j : {-y, y})
      for (const double k : {-z, z}) corners.emplace_back(i, j, k);
  return corners;
}

inline model::Ball ball(double radius) { return {model::Point::Zero(), radius}; }
inline model::Points triangle() { return {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}; }

}  // namespace walkthroughs::test
