/// The sets of Figure 1. All are made of the unit circle around the origin; the report prints no measures.
#pragma once

#include <algorithm>

#include "walkthroughs/catalogue/chord.hpp"

namespace walkthroughs {

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

}  // namespace walkthroughs
