/// How many pairs a second does gjkstep query answer on one core: lines read, asked about and answered with all evidence,
/// without the system's share of reading and writing? The column "items_per_second".
///
///     build/gjkstep-query-bench                                      double, all shapes; of points reading and writing apart
///     python3 tests/bench/query_report.py build/gjkstep-query-bench  the table in query.md
///     build/gjkstep query <pairs.jsonl >/dev/null                    the whole program, by the shell's `time`
#include <benchmark/benchmark.h>

#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "tests/kit/dice.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/query/query.hpp"
#include "walkthroughs/query/query_certified.hpp"
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
std::vector<std::string> lines() {
  kit::Dice dice(seed);
  std::vector<std::string> all;
  for (int i = 0; i < pairs; ++i) {
    const std::string a = object(dice);
    all.push_back(R"({"a":)" + a + R"(,"b":)" + object(dice) + "}");
  }
  return all;
}

QueryOptions options_with(QueryEvidence evidence) {
  QueryOptions options;
  options.evidence = evidence;
  return options;
}

template <std::string (*object)(kit::Dice&), QueryEvidence evidence = QueryEvidence::of_the_search>
void answers(benchmark::State& state) {
  std::string text;
  for (const std::string& line : lines<object>()) text += line + "\n";
  for (auto _ : state) {
    std::string_view rest = text;
    const auto read = [&](std::span<char> bytes) {
      const std::size_t count = std::min(bytes.size(), rest.size());
      std::memcpy(bytes.data(), rest.data(), count);
      rest.remove_prefix(count);
      return count;
    };
    const QueryTally tally =
        answer_lines(options_with(evidence), read, [](std::string_view out) { benchmark::DoNotOptimize(out.data()); });
    if (tally.bad != 0) state.SkipWithError("a line is bad");
  }
  state.SetItemsProcessed(state.iterations() * pairs);
}

// -- Parts of a certified answer about points -------------------------------------------------------------------------

constexpr QueryEvidence certificate = QueryEvidence::certificate;

template <std::string (*object)(kit::Dice&)>
void reads(benchmark::State& state) {
  const std::vector<std::string> all = lines<object>();
  const QueryOptions options = options_with(certificate);
  for (auto _ : state)
    for (const std::string& line : all) benchmark::DoNotOptimize(read_pair(line, options).value.a.form.index());
  state.SetItemsProcessed(state.iterations() * pairs);
}

struct Ready {
  ProvablePoints<double> pair;
  gjk::CertifiedResult result;
};

template <std::string (*object)(kit::Dice&)>
std::vector<Ready> made_ready() {
  const QueryOptions options = options_with(certificate);
  std::vector<Ready> all;
  for (const std::string& line : lines<object>()) {
    auto pair = std::get<ProvablePoints<double>>(provable<double>(read_pair(line, options).value, options));
    all.push_back({pair, proven(pair)});
  }
  return all;
}

template <std::string (*object)(kit::Dice&)>
void proves(benchmark::State& state) {
  const std::vector<Ready> all = made_ready<object>();
  for (auto _ : state)
    for (const Ready& each : all) benchmark::DoNotOptimize(proven(each.pair).iterations);
  state.SetItemsProcessed(state.iterations() * pairs);
}

template <std::string (*object)(kit::Dice&)>
void writes(benchmark::State& state) {
  const std::vector<Ready> all = made_ready<object>();
  std::string out;
  for (auto _ : state)
    for (const Ready& each : all) {
      out.clear();
      write_answer(each.result, CertificateWriter<double>{each.pair.a, each.pair.b, certificate, out});
      benchmark::DoNotOptimize(out.data());
    }
  state.SetItemsProcessed(state.iterations() * pairs);
}

BENCHMARK(answers<points<3>, certificate>)->Name("triangles, certified");
BENCHMARK(reads<points<3>>)->Name("triangles, certified: read");
BENCHMARK(proves<points<3>>)->Name("triangles, certified: proven");
BENCHMARK(writes<points<3>>)->Name("triangles, certified: written");
BENCHMARK(answers<points<32>, certificate>)->Name("hulls of 32 points, certified");
BENCHMARK(reads<points<32>>)->Name("hulls of 32 points, certified: read");
BENCHMARK(proves<points<32>>)->Name("hulls of 32 points, certified: proven");
BENCHMARK(writes<points<32>>)->Name("hulls of 32 points, certified: written");
BENCHMARK(answers<points<3>>)->Name("triangles");
BENCHMARK(answers<points<4>>)->Name("tetrahedra");
BENCHMARK(answers<points<32>>)->Name("hulls of 32 points");
BENCHMARK(answers<sphere>)->Name("spheres");
BENCHMARK(answers<cylinder>)->Name("cylinders");

}  // namespace
