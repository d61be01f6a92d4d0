#include "tests/study/claims/claims.hpp"

#include <sstream>

#include "core/gjk.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/claims/claims_text.hpp"
#include "tests/study/claims/claims_verdict.hpp"

namespace study {
namespace {

const ClaimsOptions few{.pairs = 2000, .seed = 1, .threads = 2};

// -- Verdicts ---------------------------------------------------------------------------------------------------------

std::string verdict_of(Strength strength, std::vector<Measured> measured) {
  return verdict({"", "", "", strength, std::move(measured)});
}

TEST_CASE("One exception is told of an always and leaves an almost always standing", "[claims]") {
  REQUIRE(verdict_of(Strength::always, {{"boxes", {10000, 10000}}}) == "**holds**");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {9999, 10000}}}) ==
          "**mostly holds**; rare exceptions (under 1 %) everywhere");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {9800, 10000}}}) == "**does not hold**");
  REQUIRE(verdict_of(Strength::nearly_always, {{"boxes", {9999, 10000}}}) == "**holds**");
  REQUIRE(verdict_of(Strength::usually, {{"boxes", {4000, 10000}}}) == "**does not hold**");
}

TEST_CASE("A verdict names the places where a claim holds or those where it breaks whichever are fewer", "[claims]") {
  const Measured boxes{"boxes", {5000, 5000}}, hulls{"hulls", {5000, 5000}}, needles{"needles", {4, 5}};
  REQUIRE(verdict_of(Strength::always, {boxes, needles}) == "holds for boxes, not for needles");
  REQUIRE(verdict_of(Strength::always, {boxes, hulls, needles}) == "**mostly holds**, but not for needles");
  REQUIRE(verdict_of(Strength::always, {boxes, needles, {"flat", {4, 5}}}) == "**mostly fails**, but holds for boxes");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {0, 0}}}) == "nothing to look at");
}

TEST_CASE("A verdict names the places with rare exceptions or those without whichever are fewer", "[claims]") {
  const Measured boxes{"boxes", {5000, 5000}}, hulls{"hulls", {9999, 10000}}, cans{"cans", {9990, 10000}},
      needles{"needles", {4, 5}};
  const std::string rare = "rare exceptions (under 1 %) ";
  REQUIRE(verdict_of(Strength::always, {boxes, hulls}) == "**mostly holds**; " + rare + "for hulls");
  REQUIRE(verdict_of(Strength::always, {boxes, hulls, cans}) ==
          "**mostly holds**; " + rare + "everywhere, but none for boxes");
  REQUIRE(verdict_of(Strength::always, {hulls, boxes, cans, needles}) ==
          "**mostly holds**, but not for needles; " + rare + "elsewhere, but none for boxes");
  REQUIRE(verdict_of(Strength::always, {hulls, cans, needles}) ==
          "**mostly holds**, but not for needles; " + rare + "elsewhere");
  REQUIRE(verdict_of(Strength::always, {boxes, hulls, {"spheres", {3, 3}}}) ==
          "**mostly holds**; " + rare + "for hulls; left open for spheres (only 3 cases)");
}

TEST_CASE("A verdict names a group in place of all of its members that were looked at", "[claims]") {
  const Measured boxes{"boxes", {5000, 5000}, "random shapes"}, hulls{"hulls", {5000, 5000}, "random shapes"},
      spheres{"spheres", {0, 0}, "random shapes"}, flat{"flat", {4, 5}, "hard families"},
      needles{"needles", {4, 5}, "hard families"};
  REQUIRE(verdict_of(Strength::always, {boxes, hulls, spheres, flat, needles}) ==
          "holds for random shapes, not for hard families");
  REQUIRE(verdict_of(Strength::always, {boxes, flat}) == "holds for boxes, not for flat");
  REQUIRE(verdict_of(Strength::always, {boxes, hulls, {"cans", {4, 5}, "random shapes"}}) ==
          "**mostly holds**, but not for cans");
}

TEST_CASE("Where all cases that there are were looked at their number leaves nothing open", "[claims]") {
  const Measured cycles{"cycles", {3, 3}, "hard families", Cases::all};
  REQUIRE(verdict_of(Strength::always, {cycles}) == "**holds**");
  REQUIRE(verdict_of(Strength::usually, {{"cycles", {2, 3}, "", Cases::all}}) == "**holds**");
  REQUIRE(text_of(cycles) == "cycles: 100 % of all 3");
  REQUIRE(text_of(Measured{"boxes", {123, 1000}}) == "boxes: 12.3 % (10.4–14.5)");
}

TEST_CASE("Few cases without an exception leave an always open and one exception among them refutes it", "[claims]") {
  REQUIRE(verdict_of(Strength::always, {{"boxes", {5, 5}}}) == "left open: only 5 cases");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {1, 1}}}) == "left open: only 1 case");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {4, 5}}}) == "**does not hold**");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {380, 380}}}) == "left open: only 380 cases");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {381, 381}}}) == "**holds**");
}

TEST_CASE("A verdict says why it leaves places open", "[claims]") {
  REQUIRE(verdict_of(Strength::usually, {{"boxes", {500, 1000}}}) == "left open: 50 % lies within the interval");
  REQUIRE(verdict_of(Strength::usually, {{"boxes", {500, 500}}, {"hulls", {3, 3}}}) ==
          "holds for boxes; left open for hulls (only 3 cases)");
  REQUIRE(verdict_of(Strength::usually, {{"boxes", {500, 500}}, {"cans", {500, 500}}, {"hulls", {3, 3}}}) ==
          "**holds**; left open for hulls (only 3 cases)");
  REQUIRE(verdict_of(Strength::always, {{"boxes", {3, 3}}, {"hulls", {4, 4}}}) ==
          "left open for boxes (only 3 cases) and hulls (only 4 cases)");
}

TEST_CASE("Rates are told with as many digits as say something and with their interval", "[claims]") {
  REQUIRE(grouped(1234567) == "1,234,567");
  REQUIRE(grouped(123) == "123");
  REQUIRE(rate_text({123, 1000}) == "12.3 % (10.4–14.5)");
  REQUIRE(rate_text({0, 1000000}) == "0 (at most 3.84 per million)");
  REQUIRE(rate_text({2, 1000000}) == "2 (0.548–7.29) per million");
  REQUIRE(rate_text({999, 1000}) == "99.90 % (99.44–99.982)");
  REQUIRE(joined({"a", "b", "c"}) == "a, b and c");
}

// -- Counts -----------------------------------------------------------------------------------------------------------

TEST_CASE("Effort for a small seed is pinned", "[claims]") {
  const ShapeEffort e = measure_effort(claim_shape("triangles"), few);
  REQUIRE(e.hits.iterations.queries() == 555);
  REQUIRE(e.misses.iterations.queries() == 1445);
  REQUIRE(e.undecided.iterations.queries() == 0);
  REQUIRE(e.misses.iterations.max() == 8);
  REQUIRE(e.hits.cross_products.max() == 23);
  REQUIRE(e.most_in_a_3simplex.max() == 6);
  REQUIRE(e.shortcuts.in_triangle[3].edges == 159);
  REQUIRE(e.shortcuts.kept_the_nearest.trials == 427);
  REQUIRE(e.shortcuts.kept_the_nearest.count == 373);
  REQUIRE(e.shortcuts.nearest_was(4, 15).count == 555);
}

TEST_CASE("Effort for a hard family is held against the truth and for a listed one it is of all pairs", "[claims]") {
  const Shape& touching = claim_shape("touching-edge-askew");
  const ShapeEffort e = measure_effort(touching, few);
  REQUIRE(touching.pairs(few) == 200);
  REQUIRE(e.queries() == 200);
  REQUIRE(e.hits.iterations.queries() == 189);
  REQUIRE(e.misses.iterations.queries() == 0);  // all touch
  REQUIRE(e.wrong.iterations.queries() == 11);
  REQUIRE(e.undecided.iterations.queries() == 0);
  const Shape& cycles = claim_shape("cycles");
  const ClaimsOptions too_few{.pairs = 200};
  REQUIRE(cycles.pairs(few) == 48);
  REQUIRE(cycles.asks_all(few));
  REQUIRE_FALSE(cycles.asks_all(too_few));
  REQUIRE(measure_effort(cycles, few).answered_within(0, 20).count == 0);
}

TEST_CASE("An origin on a vertex is in the simplex and not beyond the vertex", "[claims]") {
  const Shortcuts s = measure_effort(claim_shape("touching-vertex-askew"), few).shortcuts;
  REQUIRE(s.nearest_was(2, feature_of(gjk::Role::A)).count == 0);
  REQUIRE(s.nearest_was(2, 3).count > 0);
}

TEST_CASE("What lies in a skipped region of a whole-number family in double does not in fractions", "[claims]") {
  const Shape& touching = claim_shape("touching-face-askew");
  const ClaimsOptions some{.pairs = 20'000, .seed = 1};
  const Shortcuts rounded = measure_effort(touching, some).shortcuts, exact = measure_in_fractions(touching, some);
  const auto exceptions = [](const Shortcuts& shortcuts) {
    std::uint64_t count = 0;
    for (const Skipped& skipped : skipped_regions()) count += not_nearest(shortcuts, skipped).opposite().count;
    return count;
  };
  REQUIRE(exceptions(rounded) == 3);
  REQUIRE(exact.nearest_was(4, 0).trials > 100);
  REQUIRE(exceptions(exact) == 0);
}

TEST_CASE("A hard family breaks a claim that all random shapes keep and the table says so", "[claims]") {
  std::ostringstream out;
  write_claims(out, {.pairs = 2000, .seed = 1});
  const std::string text = out.str(), words = "| GJK “rarely needs more than 10”";
  const auto start = text.find(words);
  const std::string line = text.substr(start, text.find('\n', start) - start);
  INFO(line);
  REQUIRE(line.find("cycles: 0 % of all 48") != std::string::npos);
  REQUIRE(line.find("**holds**") == std::string::npos);
}

struct FirstTriangle {
  gjk::Simplex<double> simplex;

  template <class E>
  void operator()(const E&) {}
  void operator()(const gjk::VertexAdded<double>& event) {
    if (event.simplex.size() == 3 && simplex.size() == 0) simplex = event.simplex;
  }
};

/// As the text about skipped regions says: without rounding, the first triangle's plane holds the origin.
TEST_CASE("The first three vertices of two spheres lie in one plane with the origin but for rounding", "[claims]") {
  int seen = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Pair pair = claim_shape("spheres").make(1, i);
    const Ball &a = std::get<Ball>(pair.a), &b = std::get<Ball>(pair.b);
    FirstTriangle first;
    gjk::collision<double>(gjk::Sphere<double>(a.center, a.radius), gjk::Sphere<double>(b.center, b.radius),
                           gjk::Options<double>{}, first);
    if (first.simplex.size() == 0) continue;
    const Vec A = first.simplex.point(gjk::Role::A), B = first.simplex.point(gjk::Role::B),
              C = first.simplex.point(gjk::Role::C);
    REQUIRE(std::abs(A.dot(B.cross(C))) < 1e-14);
    ++seen;
  }
  REQUIRE(seen > 500);
}

TEST_CASE("Moeller's test and GJK agree on random triangles and Algorithm 1 as printed does not", "[claims]") {
  const MollerCounts counts = measure_moller(triangle_kinds()[0], few);
  REQUIRE(counts.meet == 555);
  for (const Way way : {Way::double_computed, Way::float_computed, Way::double_snapped, Way::float_snapped}) {
    REQUIRE(counts.of(way).both_yes == 555);
    REQUIRE(counts.of(way).both_no == 1445);
    const Rate printed = counts.of(way, RulesAsked::as_printed).all_only_gjk();
    const bool in_double = way == Way::double_computed || way == Way::double_snapped;
    REQUIRE(printed.trials == (in_double ? 45 : 44));
    REQUIRE(printed.count == 0);
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
  const MollerCounts counts = measure_moller(triangle_kinds()[1], {.pairs = 20'000, .seed = 1, .threads = 2});
  REQUIRE(counts.edges_touch == 167);
  for (const Way way : {Way::double_computed, Way::double_snapped}) {
    const Comparison& c = counts.of(way);
    REQUIRE(c.only_gjk_of(Contact::edges).trials == 11);
    REQUIRE(c.all_only_gjk().trials == c.all_only_gjk().count);
    REQUIRE(c.all_only_moller().trials == 0);
    REQUIRE(c.gjk_right().share() == 1);
  }
}

TEST_CASE("Of triangles with a common vertex Moeller's test misses some in float and none in double", "[claims]") {
  const MollerCounts counts = measure_moller(common_vertex_kind(), {.pairs = 20'000, .seed = 1, .threads = 2});
  REQUIRE(counts.meet == counts.pairs);
  const auto missed = [&](Way way) { return counts.of(way).only_gjk_of(Contact::common_vertex); };
  REQUIRE(missed(Way::double_computed).trials == 0);
  REQUIRE(missed(Way::double_snapped).trials == 0);
  REQUIRE(missed(Way::float_snapped).trials == 5);
  REQUIRE(missed(Way::float_snapped).count == missed(Way::float_snapped).trials);
  const Rate seen = counts.common_vertex_seen[static_cast<std::size_t>(Way::float_snapped)];
  REQUIRE(seen.trials == counts.pairs);
  REQUIRE(seen.opposite().count == missed(Way::float_snapped).trials);
}

TEST_CASE("The row about agreement shows how often both agree, not how often they do not", "[claims]") {
  std::ostringstream out;
  write_claims(out, {.pairs = 1000, .seed = 1});
  const std::string text = out.str();
  const auto start = text.find("“agreed with TriTri");
  const std::string line = text.substr(start, text.find('\n', start) - start);
  REQUIRE(line.find("both say the same | double | 100 % (at least 99.62 %)") != std::string::npos);
  REQUIRE(line.find("left open for random triangles (only 1,000 cases)") != std::string::npos);
}

TEST_CASE("All but 2 of a million holds up to ten of a million and few pairs leave it open", "[claims]") {
  REQUIRE(verdict_of(Strength::all_but_few, {{"float", {999'997, 1'000'000}}}) == "**holds**");
  REQUIRE(verdict_of(Strength::all_but_few, {{"float", {999'900, 1'000'000}}}) == "**does not hold**");
  REQUIRE(verdict_of(Strength::all_but_few, {{"float", {2000, 2000}}}) == "left open: only 2,000 cases");
}

TEST_CASE("A sign that is flipped shows in the table and an order that is wrong hides", "[claims]") {
  const MistakeTable table = measure_mistakes(TestPairs::triangles, few);
  const auto of = [&](const std::string& part) -> const MistakeCounts& {
    for (std::size_t i = 0; i < mistakes().size(); ++i)
      if (mistakes()[i].name.find(part) != std::string::npos) return table.counts[i];
    throw std::invalid_argument("no mistake is called " + part);
  };
  REQUIRE(of("ABn of the triangle points inward").fails.count == 490);
  REQUIRE(of("wrong order, and").undecided == 1197);
  REQUIRE(of("ADB is kept in the wrong order").fails.count == 0);
  REQUIRE(of("ADB is kept in the wrong order").changed.count == 45);
}

std::string text_of_few_pairs() {
  static const std::string text = [] {
    std::ostringstream out;
    write_claims(out, {.pairs = 1000, .seed = 1});
    return out.str();
  }();
  return text;
}

TEST_CASE("Claims about mistakes stand in a table of their own with the numbers of the mistakes", "[claims]") {
  const std::string text = text_of_few_pairs();
  const auto claims = text.find("## Claim by claim"), next = text.find("\n## ", claims);
  REQUIRE(text.substr(claims, next - claims).find("can have a bug") == std::string::npos);
  REQUIRE(text.find("| The report says | Section | True of a mistake where … | Mistakes | Which | Verdict |") > next);
  REQUIRE(text.find("passes 100 random triangle pairs | 0 of 21 | – | left open |") != std::string::npos);
  REQUIRE(text.find("| 6 of 16 | M2, M11, M14, M18, M19 and M20 | **holds** for these |") != std::string::npos);
}

/// As the other results do: wrapped text would have lines of any length wherever a number is put in.
TEST_CASE("Every paragraph of the text is one line", "[claims]") {
  std::istringstream text(text_of_few_pairs());
  const auto both_are = [](const std::string& before, const std::string& line, const char* start) {
    return before.starts_with(start) && line.starts_with(start);
  };
  std::string before, line;
  while (std::getline(text, line)) {
    INFO(before << '\n' << line);
    const bool follows = both_are(before, line, "|") || both_are(before, line, "* ");
    REQUIRE((line.empty() || before.empty() || follows));
    before = line;
  }
}

TEST_CASE("The text is the same with one thread and with three", "[claims]") {
  const auto text = [](unsigned threads) {
    std::ostringstream out;
    write_claims(out, {.pairs = 600, .seed = 3, .threads = threads});
    return out.str();
  };
  const std::string one = text(1);
  REQUIRE(one == text(3));
  for (const char* const section : {"## Claim by claim", "## Iterations", "## The checks", "## The report's two pairs",
                                    "## How many tests does a mistake survive?"})
    REQUIRE(one.find(section) != std::string::npos);
}

}  // namespace
}  // namespace study
