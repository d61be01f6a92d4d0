// What is counted for the report's claims, of few pairs.
#include "tests/study/claims/claims.hpp"

#include "core/gjk.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "tests/study/methods/mistakes.hpp"

namespace study {
namespace {

const ClaimsOptions few{.pairs = 2000, .seed = 1, .threads = 2}, more{.pairs = 20'000, .seed = 1, .threads = 2};

std::size_t most(const EffortCounts& counts, Effort effort) {
  return counts.histograms[static_cast<std::size_t>(effort)].size() - 1;
}

std::uint64_t all(const EffortCounts& counts, Effort effort) {
  return total(counts.histograms[static_cast<std::size_t>(effort)]);
}

TEST_CASE("Effort for a small seed is pinned", "[claims]") {
  using enum Effort;
  const EffortCounts e = count_effort(claim_shape("triangles"), few);
  CHECK(all(e, hits) == 555);
  CHECK(all(e, misses) == 1445);
  CHECK(all(e, undecided) == 0);
  CHECK(most(e, misses) == 8);
  CHECK(most(e, hit_cross_products) == 23);
  CHECK(most(e, most_in_a_3simplex) == 6);
  CHECK(most(e, simplices) == 4);
  CHECK(e.at(triangle_edges, 3) == 159);
  CHECK(e.at(kept_the_nearest, 0) == 427 - 373);
  CHECK(e.at(kept_the_nearest, 1) == 373);
  CHECK(e.at(nearest_of_4, 15) == 555);
}

TEST_CASE("Edges of either simplex that the report's missing checks would not keep are counted apart", "[claims]") {
  using enum Effort;
  const EffortCounts e = count_effort(claim_shape("tetrahedra"), more);
  using Checks = std::array<std::uint64_t, 3>;
  CHECK(Checks{all(e, triangle_edges), all(e, triangle_newest_false), all(e, triangle_older_false)} ==
        Checks{1390, 0, 0});
  CHECK(Checks{all(e, tetrahedron_edges), all(e, tetrahedron_newest_false), all(e, tetrahedron_older_false)} ==
        Checks{627, 1, 1});
}

TEST_CASE("Effort for a hard family is held against the truth and for a listed one it is of all pairs", "[claims]") {
  using enum Effort;
  const EffortCounts e = count_effort(claim_shape("touching-edge-askew"), few);
  CHECK(all(e, hits) == 189);
  CHECK(all(e, misses) == 0);  // all touch
  CHECK(all(e, wrong) == 11);
  CHECK(all(e, undecided) == 0);
  CHECK(claim_shape("cycles").pairs(few) == 48);
  CHECK(all(count_effort(claim_shape("cycles"), few), undecided) == 48);
}

TEST_CASE("An origin on a vertex is in the simplex and not beyond the vertex", "[claims]") {
  const EffortCounts e = count_effort(claim_shape("touching-vertex-askew"), few);
  CHECK(e.at(Effort::nearest_of_2, feature_of(gjk::Role::A)) == 0);
  CHECK(e.at(Effort::nearest_of_2, 3) > 0);
}

TEST_CASE("What lies in a skipped region of a whole-number family in double does not in fractions", "[claims]") {
  using enum Effort;
  const Shape& touching = claim_shape("touching-face-askew");
  const EffortCounts rounded = count_effort(touching, more), exact = count_in_fractions(touching, more);
  const auto exceptions =
      [](const EffortCounts& counts) {  // near A, B, C or BC, of 3-simplices anything with D but not A, too
        std::uint64_t sum = 0;
        for (const std::size_t feature : {1, 2, 4, 6})
          sum += counts.at(nearest_of_3, feature) + counts.at(nearest_of_4, feature);
        for (const std::size_t feature : {8, 10, 12, 14}) sum += counts.at(nearest_of_4, feature);
        return sum;
      };
  CHECK(exceptions(rounded) == 3);
  CHECK(all(exact, nearest_of_4) > 100);
  CHECK(exceptions(exact) == 0);
}

std::int64_t of(const Comparisons& compared, std::size_t rules, std::size_t way, Compared name) {
  return compared[rules][way][name];
}

TEST_CASE("Moeller's test and GJK agree on random triangles and Algorithm 1 as printed does not", "[claims]") {
  using enum Compared;
  const Comparisons compared = compare_with_moller(triangle_kinds()[0], few);
  for (std::size_t way = 0; way < way_names.size(); ++way) {
    INFO(way_names[way]);
    CHECK(of(compared, 0, way, meet) == 555);
    CHECK(of(compared, 0, way, both_yes) == 555);
    CHECK(of(compared, 0, way, both_no) == 1445);
    CHECK(of(compared, 1, way, only_gjk) == (way % 2 == 0 ? 45 : 44));
    CHECK(of(compared, 1, way, only_gjk_right) == 0);
  }
}

TEST_CASE("Float and double are given the same triangles", "[claims]") {
  for (const TriangleKind& kind : triangle_kinds())
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Pair pair = kind.make(1, i);
      for (const Body& body : {pair.a, pair.b})
        for (const Vec& p : std::get<Points>(body))
          for (const double x : p) REQUIRE(x == static_cast<double>(static_cast<float>(x)));
    }
}

TEST_CASE("Of triangles on a coarse grid Moeller's test misses some that touch along edges and GJK does not",
          "[claims]") {
  using enum Compared;
  const Comparisons compared = compare_with_moller(triangle_kinds()[1], more);
  for (const std::size_t way : {0, 2}) {  // double
    CHECK(of(compared, 0, way, touch_so) == 167);
    CHECK(of(compared, 0, way, only_gjk_touch_so) == 11);
    CHECK(of(compared, 0, way, only_gjk) == of(compared, 0, way, only_gjk_right));
    CHECK(of(compared, 0, way, only_moller) == 0);
  }
}

TEST_CASE("Of triangles with a common vertex Moeller's test misses some in float and none in double", "[claims]") {
  using enum Compared;
  const Comparisons compared = compare_with_moller(triangle_kinds().back(), more);
  CHECK(of(compared, 0, 0, meet) == 20'000);
  CHECK(of(compared, 0, 0, share_a_vertex) == 20'000);
  const auto missed = [&](std::size_t way) { return of(compared, 0, way, only_gjk_share_a_vertex); };
  CHECK(missed(0) == 0);
  CHECK(missed(2) == 0);
  CHECK(missed(3) == 5);
  CHECK(of(compared, 0, 3, only_gjk_right) == 5);
  CHECK(of(compared, 0, 3, share_seen_by_moller) == 20'000 - 5);
}

TEST_CASE("Of small triangles far apart for their size Moeller's test, snapped, says that they meet", "[claims]") {
  using enum Compared;
  const TriangleKind small{"small", [](std::uint64_t, std::uint64_t) {
                             return Pair{Points{{0, 0, 0}, {0x1p-10, 0, 0}, {0, 0x1p-10, 0}},
                                         Points{{0, 0, 0.5}, {0x1p-10, 0, 0.5}, {0, 0x1p-10, 0.5}}};
                           }};
  const Comparisons compared = compare_with_moller(small, {.pairs = 10, .seed = 1, .threads = 1});
  for (std::size_t way = 0; way < way_names.size(); ++way) {
    INFO(way_names[way]);
    CHECK(of(compared, 0, way, only_moller) == (way < 2 ? 0 : 10));
    CHECK(of(compared, 0, way, only_moller_right) == 0);
    CHECK(of(compared, 0, way, only_moller_beyond_plane) == (way < 2 ? 0 : 10));
    CHECK(of(compared, 0, way, both_no) == (way < 2 ? 10 : 0));
  }
}

TEST_CASE("A sign that is flipped shows in the table and an order that is wrong hides", "[claims]") {
  using enum OfMistake;
  const MistakeCounts counts = count_mistakes("triangles", few);
  const auto of = [&](const std::string& part) {
    for (std::size_t i = 0; i < mistakes().size(); ++i)
      if (kit::has(mistakes()[i].name, part)) return counts[i];
    throw std::invalid_argument("no mistake is called " + part);
  };
  CHECK(of("ABn of the triangle points inward")[fails] == 490);
  CHECK(of("wrong order, and")[undecided] == 1197);
  const auto hidden = of("ADB is kept in the wrong order"), printed = of("as printed"),
             inside = of("the three edges is inside");
  CHECK(hidden[asked] == 2000);
  CHECK(hidden[fails] == 0);
  CHECK(hidden[changed] == 45);
  CHECK(hidden[changed_meeting] + hidden[changed_apart] == 45);
  CHECK(hidden[healed_meeting] + hidden[healed_apart] == 45);
  CHECK(hidden[extra_iterations] == 64);
  CHECK(printed[wrong_yes] == 45);
  CHECK(printed[wrong_no] == 0);
  CHECK(inside[wrong_yes] == inside[fails]);
  CHECK(of("support(B, d)")[wrong_no] == 555);
}

TEST_CASE("Claims are written with their head, their columns and a row for each that was counted", "[claims]") {
  const std::vector<Csv> files = claims_csv({.pairs = 100, .seed = 3});
  REQUIRE(files.size() == 3);
  for (const Csv& file : files) {
    INFO(file.name);
    CHECK(file.text.starts_with("# command: gjkstep-study claims --pairs 100 --seed 3\n# compiler: "));
    const auto lines = kit::lines(file.text);
    const auto commas = [](std::string line) {  // but for those in quotes
      bool inside = false;
      return std::ranges::count_if(line, [&](char c) { return inside ^= c == '"', c == ',' && !inside; });
    };
    for (std::size_t i = 4; i < lines.size(); ++i) CHECK(commas(lines[i]) == commas(lines[3]));
  }
  CHECK(kit::lines(files[0].text).size() == 4 + 17 + 5);
  CHECK(kit::lines(files[1].text).size() == 4 + 10 * 2 * 4);
  CHECK(kit::lines(files[2].text).size() == 4 + 3 * 21);
  CHECK(kit::has(files[0].text, "\ncycles,double,hard,no,"));  // 10 of 48
  CHECK(kit::has(files[2].text, "\ngrid,M21,\"the origin in a face of the tetrahedron counts as outside\",3.2.4,100,"));
}

}  // namespace
}  // namespace study
