/// Where the searches that a program is held against begin: nobody knows where its own do.
#pragma once

#include <functional>
#include <vector>

#include "core/result.hpp"
#include "walkthroughs/pairs/pair.hpp"

namespace walkthroughs::judge {

using Start = std::function<Vec(const PointPair&)>;  ///< the first direction

inline Vec mean_of(const Points& points) {
  Vec sum = Vec::Zero();
  for (const Vec& p : points) sum += p / static_cast<double>(points.size());
  return sum;
}

/// Returns: along each axis and against it, and between the middles and the first points, both ways.
inline const std::vector<Start>& starts() {
  static const std::vector<Start> all = [] {
    std::vector<Start> list;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0})
        list.push_back([d = Vec(sign * Vec::Unit(axis))](const PointPair&) { return d; });
    using gjk::first_direction_between;
    list.push_back([](const PointPair& pair) { return first_direction_between(mean_of(pair.a), mean_of(pair.b)); });
    list.push_back([](const PointPair& pair) { return first_direction_between(mean_of(pair.b), mean_of(pair.a)); });
    list.push_back([](const PointPair& pair) { return first_direction_between(pair.a[0], pair.b[0]); });
    list.push_back([](const PointPair& pair) { return first_direction_between(pair.b[0], pair.a[0]); });
    return list;
  }();
  return all;
}

}  // namespace walkthroughs::judge
