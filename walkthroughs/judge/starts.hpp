/// Where the searches that a program is held against begin: nobody knows where its own do.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/result.hpp"
#include "walkthroughs/pairs/pair.hpp"

namespace walkthroughs::judge {

struct Start {
  const char* words;
  std::function<Vec(const PointPair&)> direction_of;
};

inline Vec mean_of(const Points& points) {
  Vec sum = Vec::Zero();
  for (const Vec& p : points) sum += p / static_cast<double>(points.size());
  return sum;
}

/// Returns: along each axis and against it, and between the middles and the first points, both ways.
inline const std::vector<Start>& starts() {
  static const std::vector<Start> all = [] {
    std::vector<Start> list;
    for (const auto& [words, d] :
         {std::pair{"+x", Vec(1, 0, 0)}, std::pair{"−x", Vec(-1, 0, 0)}, std::pair{"+y", Vec(0, 1, 0)},
          std::pair{"−y", Vec(0, -1, 0)}, std::pair{"+z", Vec(0, 0, 1)}, std::pair{"−z", Vec(0, 0, -1)}})
      list.push_back({words, [d = d](const PointPair&) { return d; }});
    using gjk::first_direction_between;
    list.push_back({"from A to B",
                    [](const PointPair& pair) { return first_direction_between(mean_of(pair.a), mean_of(pair.b)); }});
    list.push_back({"from B to A",
                    [](const PointPair& pair) { return first_direction_between(mean_of(pair.b), mean_of(pair.a)); }});
    list.push_back(
        {"from a[0] to b[0]", [](const PointPair& pair) { return first_direction_between(pair.a[0], pair.b[0]); }});
    list.push_back(
        {"from b[0] to a[0]", [](const PointPair& pair) { return first_direction_between(pair.b[0], pair.a[0]); }});
    return list;
  }();
  return all;
}

}  // namespace walkthroughs::judge
