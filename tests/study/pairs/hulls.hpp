/// What tests of the study share.
#pragma once

#include <vector>

#include "tests/study/pairs/pairs.hpp"

namespace study {

inline const Points& points(const Body& body) { return std::get<Points>(body); }

inline Points times(double factor, Points points) {
  for (Vec& p : points) p *= factor;
  return points;
}

inline Points plus(const Vec& by, Points points) {
  for (Vec& p : points) p += by;
  return points;
}

}  // namespace study
