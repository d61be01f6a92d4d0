/// Where the searches that a program is held against begin: nobody knows where its own do.
#pragma once

#include <optional>
#include <vector>

#include "core/shapes.hpp"

namespace walkthroughs::judge {

struct Start {
  const char* words;
  std::optional<gjk::Vec3<double>> direction;  ///< else from one center to the other, times the sign
  double sign = 1;

  /// `between`: from the center of A to that of B.
  gjk::Vec3<double> direction_of(const gjk::Vec3<double>& between) const { return direction.value_or(sign * between); }
};

inline const std::vector<Start>& starts() {
  using Vec3 = gjk::Vec3<double>;
  static const std::vector<Start> all{{"+x", Vec3(1, 0, 0)},  {"−x", Vec3(-1, 0, 0)}, {"+y", Vec3(0, 1, 0)},
                                      {"−y", Vec3(0, -1, 0)}, {"+z", Vec3(0, 0, 1)},  {"−z", Vec3(0, 0, -1)},
                                      {"from A to B", {}, 1}, {"from B to A", {}, -1}};
  return all;
}

}  // namespace walkthroughs::judge
