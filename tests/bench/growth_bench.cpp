/// What do searches and support functions cost as sets grow? For growth.py: name, points, seconds.
///
///     build/gjkstep-growth
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

#include "core/certified/certified.hpp"
#include "tests/kit/dice.hpp"

namespace {

using Points = gjk::PointSet<double>;
using V = gjk::Vec3<double>;

constexpr int repeats = 5, asked = 200;

std::vector<V> on_a_ball(kit::Dice& dice, std::size_t count, const V& center) {
  std::vector<V> points(count);
  for (V& p : points) {
    for (double& x : p) x = dice.between(-1.0, 1.0);
    p = p.stableNormalized() + center;
  }
  return points;
}

double seconds(const std::function<void()>& run) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(times);
  return times[repeats / 2];
}

void tell(const char* name, std::size_t count, double time) { std::printf("%s,%zu,%.4g\n", name, count, time); }

}  // namespace

int main() {
  for (const std::size_t count : {4U, 10U, 100U, 1'000U, 10'000U, 100'000U}) {
    kit::Dice dice(7474);
    const Points a(on_a_ball(dice, count, V(0, 0, 0))), b(on_a_ball(dice, count, V(1.5, 0.5, 0.2)));
    Points prepared = a;
    std::vector<V> directions = on_a_ball(dice, asked, V(0, 0, 0));
    volatile int used = 0;
    const auto ask = [&](const Points& set) {
      return seconds([&] {
               for (const V& d : directions) used = used + *set.support(d).index;
             }) /
             asked;
    };
    tell("points, a support point", count, ask(a));
    tell("points, made ready", count, seconds([&] { prepared.prepare(); }));
    tell("points, a support point of a ready set", count, ask(prepared));
    tell("points, a certified answer", count, seconds([&] { used = gjk::certified_collision(a, b).iterations; }));
  }
}
