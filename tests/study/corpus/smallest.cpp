#include "tests/study/corpus/smallest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/study/corpus/shown.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace study {
namespace {

constexpr std::size_t wanted = 17;              // of each mistake
constexpr std::uint64_t throws_of_size = 3000;  // of each number of points, in each cube

Points whole_points(Dice& dice, int count, int reach) {
  Points points(static_cast<std::size_t>(count));
  for (Vec& p : points)
    for (double& x : p) x = dice.whole(-reach, reach);
  return points;
}

bool are_same(const Pair& x, const Pair& y) {
  return std::get<Points>(x.a) == std::get<Points>(y.a) && std::get<Points>(x.b) == std::get<Points>(y.b);
}

/// Returns: all pairs that are one step smaller: without a point, or with a number nearer to 0.
std::vector<Pair> smaller(const Pair& pair) {
  std::vector<Pair> all;
  for (Body Pair::*const body : {&Pair::a, &Pair::b}) {
    const Points& points = std::get<Points>(pair.*body);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto with = [&](const auto& change) {
        all.push_back(pair);
        change(std::get<Points>(all.back().*body));
      };
      if (points.size() > 1) with([i](Points& p) { p.erase(p.begin() + static_cast<std::ptrdiff_t>(i)); });
      for (Eigen::Index k = 0; k < 3; ++k)
        if (const double x = points[i][k]; x != 0) {
          with([&](Points& p) { p[i][k] = 0; });
          with([&](Points& p) { p[i][k] = x - std::copysign(1, x); });
        }
    }
  }
  return all;
}

Pair shrunk(Pair pair, std::size_t mistake) {
  for (bool goes_on = true; goes_on;) {
    const std::vector<Pair> all = smaller(pair);
    const auto found = std::ranges::find_if(all, [&](const Pair& each) { return shows(each, mistake); });
    goes_on = found != all.end();
    if (goes_on) pair = *found;
  }
  return pair;
}

/// Of each mistake, in the order in which they are found.
using Found = std::vector<std::vector<Pair>>;

void look_at(const Pair& pair, Found& found) {
  if (std::ranges::all_of(found, [](const auto& pairs) { return pairs.size() >= wanted; })) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].size() >= wanted || !shows(pair, i)) continue;
    const Pair small = shrunk(pair, i);
    const bool is_known = std::ranges::any_of(found, [&](const auto& pairs) {
      return std::ranges::any_of(pairs, [&](const Pair& each) { return are_same(each, small); });
    });
    if (!is_known) found[i].push_back(small);
  }
}

}  // namespace

std::vector<NamedPair> smallest_pairs() {
  Found found(mistakes().size());
  Dice dice(1, "smallest", 0);
  for (const int reach : {1, 2, 3, 5, 9, 20})
    for (int a_count = 1; a_count <= 4; ++a_count)
      for (int b_count = 1; b_count <= 4; ++b_count)
        for (std::uint64_t i = 0; i < throws_of_size; ++i) {
          Points a = whole_points(dice, a_count, reach);
          look_at({std::move(a), whole_points(dice, b_count, reach)}, found);
        }
  std::vector<NamedPair> all;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = 0; k < found[i].size(); ++k)
      all.push_back({"m" + std::to_string(i + 1) + "-" + std::to_string(k + 1), "smallest", found[i][k]});
  return all;
}

}  // namespace study
