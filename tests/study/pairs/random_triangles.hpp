/// Random triangles whose coordinates have few digits, so that some of them touch.
#pragma once

#include "tests/study/pairs/pairs.hpp"

namespace study {

/// Returns: whether the three points lie on a line.
inline bool is_flat(const Points& t) { return (t[1] - t[0]).cross(t[2] - t[0]) == Vec(Vec::Zero()); }

/// Thrown again while it is flat on the grid, where that is seen without rounding.
///
/// Requires: levels <= 2^15.
inline Points coarse_triangle(Dice& dice, int levels, int divisor) {
  Points corners(3);
  do {
    for (Vec& corner : corners)
      for (double& coordinate : corner) coordinate = dice.whole(0, levels - 1);
  } while (is_flat(corners));
  for (Vec& corner : corners) corner /= divisor;
  return corners;
}

/// Each coordinate is k/divisor, k one of 0 … levels - 1, all alike.
inline Pair coarse_triangles(Dice& dice, int levels, int divisor) {
  Points a = coarse_triangle(dice, levels, divisor);
  return {std::move(a), coarse_triangle(dice, levels, divisor)};
}

/// A corner of one is a corner of the other, too. Whole numbers.
inline Pair coarse_triangles_with_a_common_corner(Dice& dice, int levels) {
  const Points a = coarse_triangle(dice, levels, 1);
  const auto any = [&dice] { return static_cast<std::size_t>(dice.whole(0, 2)); };
  Points b;
  do {
    b = coarse_triangle(dice, levels, 1);
    b[any()] = a[any()];
  } while (is_flat(b));
  return {a, b};
}

}  // namespace study
