/// How many pairs a second does gjkstep query answer on one core: lines read, asked about and answered with all evidence,
/// without the system's share of reading and writing? The column "items_per_second".
///
///     build/gjkstep-query-bench                                      double, all shapes
///     build/gjkstep query <pairs.jsonl >/dev/null                    the whole program, by the shell's `time`
#include <benchmark/benchmark.h>

#include <cstring>
#include <span>
#include <string>

#include "tests/kit/dice.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/query/query.hpp"
#include "walkthroughs/text/scene_values.hpp"

namespace {

using namespace walkthroughs::program;

constexpr std::uint64_t seed = 7474;
constexpr int pairs = 1000;

std::string point(kit::Dice& dice) {
  std::string text = "[" + number_text(dice.between(-1.0, 1.0));
  for (int i = 0; i < 2; ++i) text += "," + number_text(dice.between(-1.0, 1.0));
  return text + "]";
}

template <int count>
std::string points(kit::Dice& dice) {
  std::string text = R"({"points":[)" + point(dice);
  for (int i = 1; i < count; ++i) text += "," + point(dice);
  return text + "]}";
}

std::string sphere(kit::Dice& dice) { return R"({"sphere":{"center":)" + point(dice) + R"(,"radius":0.5}})"; }

std::string cylinder(kit::Dice& dice) {
  const std::string center = point(dice);
  return R"({"cylinder":{"center":)" + center + R"(,"axis":)" + point(dice) + R"(,"radius":0.4,"height":0.8}})";
}

template <std::string (*object)(kit::Dice&)>
void answers(benchmark::State& state) {
  kit::Dice dice(seed);
  std::string text;
  for (int i = 0; i < pairs; ++i) {
    const std::string a = object(dice);
    text += R"({"a":)" + a + R"(,"b":)" + object(dice) + "}\n";
  }
  for (auto _ : state) {
    std::string_view rest = text;
    const auto read = [&](std::span<char> bytes) {
      const std::size_t count = std::min(bytes.size(), rest.size());
      std::memcpy(bytes.data(), rest.data(), count);
      rest.remove_prefix(count);
      return count;
    };
    const QueryTally tally = answer_lines({}, read, [](std::string_view out) { benchmark::DoNotOptimize(out.data()); });
    if (tally.bad != 0) state.SkipWithError("a line is bad");
  }
  state.SetItemsProcessed(state.iterations() * pairs);
}

BENCHMARK(answers<points<3>>)->Name("triangles");
BENCHMARK(answers<points<4>>)->Name("tetrahedra");
BENCHMARK(answers<points<32>>)->Name("hulls-of-32-points");
BENCHMARK(answers<sphere>)->Name("spheres");
BENCHMARK(answers<cylinder>)->Name("cylinders");

}  // namespace
