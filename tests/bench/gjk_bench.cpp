/// What does it cost to be watched? The plain call beside the same call observed (a) by a function that does nothing
/// with the events and (b) by a Trace that keeps them, over the same random pairs. In the plain call no event is made.
///
///     build/gjkstep-bench                                  all shapes, times per pair in the column "Time"
///     build/gjkstep-bench --benchmark_filter=triangles     one kind of shape
///     build/gjkstep-bench --benchmark_repetitions=5        mean, median and spread
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/gjk.hpp"
#include "tests/kit/dice.hpp"

namespace {

using gjk::PointSet;
using gjk::Sphere;
using V = gjk::Vec3<double>;

constexpr std::uint64_t seed = 7474;
constexpr int pairs = 1000;

V point(kit::Dice& dice) {
  const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0);
  return {x, y, dice.between(-1.0, 1.0)};
}

template <int Count>
struct Hulls {
  using Shape = PointSet<double>;
  static Shape make(kit::Dice& dice) {
    // Larger hulls lie farther apart, so that hits and misses stay mixed.
    const V offset = point(dice) * (Count <= 4 ? 0.5 : 1.5);
    std::vector<V> points;
    for (int i = 0; i < Count; ++i) points.push_back(point(dice) + offset);
    return PointSet<double>(points);
  }
};

struct Spheres {
  using Shape = Sphere<double>;
  static Shape make(kit::Dice& dice) {
    const V center = point(dice);
    return {center, dice.between(0.2, 1.0)};
  }
};

template <class Kind>
std::vector<std::pair<typename Kind::Shape, typename Kind::Shape>> make_pairs() {
  kit::Dice dice(seed);
  std::vector<std::pair<typename Kind::Shape, typename Kind::Shape>> made;
  for (int i = 0; i < pairs; ++i) {
    auto a = Kind::make(dice);
    made.emplace_back(std::move(a), Kind::make(dice));
  }
  return made;
}

struct Plain {
  template <class A>
  static gjk::Result<double> ask(const A& a, const A& b) {
    return gjk::collision<double>(a, b);
  }
};

struct ObservedByNothing {
  template <class A>
  static gjk::Result<double> ask(const A& a, const A& b) {
    return gjk::collision<double>(a, b, {}, [](const auto& event) { benchmark::DoNotOptimize(&event); });
  }
};

struct Traced {
  template <class A>
  static gjk::Result<double> ask(const A& a, const A& b) {
    gjk::Trace<double> trace;
    const auto result = gjk::collision<double>(a, b, {}, trace);
    benchmark::DoNotOptimize(trace.events.data());
    return result;
  }
};

template <class Kind, class Call>
void measure(benchmark::State& state) {
  const auto shapes = make_pairs<Kind>();
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& [a, b] = shapes[next];
    next = (next + 1) % shapes.size();
    auto result = Call::ask(a, b);
    benchmark::DoNotOptimize(result);
  }
  double hits = 0, iterations = 0;
  for (const auto& [a, b] : shapes) {
    const auto result = gjk::collision<double>(a, b);
    hits += result.status == gjk::Status::intersecting;
    iterations += result.iterations;
  }
  state.counters["hits"] = hits / pairs;
  state.counters["iterations"] = iterations / pairs;
}

template <class Kind>
void add(const std::string& name) {
  benchmark::RegisterBenchmark((name + "/plain").c_str(), measure<Kind, Plain>);
  benchmark::RegisterBenchmark((name + "/observed-by-nothing").c_str(), measure<Kind, ObservedByNothing>);
  benchmark::RegisterBenchmark((name + "/traced").c_str(), measure<Kind, Traced>);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("seed", std::to_string(seed));
  benchmark::AddCustomContext("pairs", std::to_string(pairs));
  add<Hulls<3>>("triangles");
  add<Hulls<4>>("tetrahedra");
  add<Hulls<32>>("hulls-of-32-points");
  add<Spheres>("spheres");
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
