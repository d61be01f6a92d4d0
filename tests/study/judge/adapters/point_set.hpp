// Points that the judge asks about as a shape of the core.
#pragma once

#include <utility>
#include <vector>

#include "core/shapes.hpp"
#include "judge_main.hpp"

inline gjk::PointSet<double> set_of(const judge::Points& points) {
  std::vector<gjk::Vec3<double>> list;
  for (const auto& [x, y, z] : points) list.emplace_back(x, y, z);
  return gjk::PointSet<double>(std::move(list));
}
