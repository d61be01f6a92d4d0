/// The words in which a step is told: they fit the verdict, the letters and the crossing test.
#include "core/telling.hpp"

#include <map>
#include <set>

#include "tests/core/rules_support.hpp"

namespace gjk::test {
namespace {

/// Returns: a simplex of 1 to 4 vertices with small whole numbers, so that products are often zero.
Simplex<double> random_simplex(Dice& dice, int size) {
  Simplex<double> simplex;
  for (int n = 0; n < size; ++n) {
    const Vec3<double> w = vec<double>(dice.point(2));
    simplex.add({{w}, {Vec3<double>(Vec3<double>::Zero())}, w});
  }
  return simplex;
}

std::string skipped_because(const RegionTested<double>& region, bool tests_crossing) {
  if (region.feature == "A")
    return tests_crossing ? "were the origin beyond A, the move to A would not have reached it"
                          : "only the crossing test rules this out, and this run does without it";
  const std::string left = std::string("BCD").substr(0, std::size_t(region.simplex_size) - 1);
  return region.feature == left ? "the search has just moved away from " + left + ", toward the origin"
                                : "ruled out when the search kept " + left;
}

std::string found_because(const RegionTested<double>& region, bool tests_crossing) {
  if (region.feature == "A") return region.relation == Relation::zero ? "A is the origin" : "the origin lies elsewhere";
  if (region.simplex_size == 2) {
    if (region.relation == Relation::not_zero) return "the origin lies to one side of AB";
    return tests_crossing ? "the origin lies on AB" : "the origin lies on the line AB";
  }
  if (region.feature == "ABCD") return "no face sees the origin: it lies in the tetrahedron";
  if (region.label == "R1") {
    if (region.relation == Relation::positive) return "the origin lies above the triangle, on the side of ABCn";
    if (region.relation == Relation::negative) return "the origin lies below the triangle, on the side of −ABCn";
    return tests_crossing ? "the origin lies in the triangle" : "the origin lies in its plane";
  }
  const bool points_there = region.verdict == Verdict::chosen;
  return region.feature + "n " + (points_there ? "points" : "does not point") + " toward the origin";
}

TEST_CASE("Each verdict is told with the reason that fits it", "[telling]") {
  Dice dice(51);
  std::map<std::string, int> told;
  for (int i = 0; i < 20000; ++i) {
    const CrossingTest crossing_test = i % 8 < 4 ? CrossingTest::on : CrossingTest::off;
    Simplex<double> simplex = random_simplex(dice, 1 + i % 4);
    for (const auto& region : events_of_kind<RegionTested<double>>(step(simplex, crossing_test).events)) {
      INFO(region.feature << " " << region.label << " " << region.face << " of " << region.simplex_size);
      const bool on = crossing_test == CrossingTest::on;
      REQUIRE(region.reason ==
              (region.verdict == Verdict::skipped ? skipped_because(region, on) : found_because(region, on)));
      ++told[region.reason];
    }
  }
  for (const auto& [reason, times] : told) {
    INFO(reason);
    CHECK(times >= 3);
  }
  CHECK(told.size() ==
        2 + 5 + 2 + 3 + 4 + 1 + 2 * 6);  // skipped; Algorithms 2-5; whether each of six normals points there
}

TEST_CASE("Why vertices are kept, and in this order, is told with them", "[telling]") {
  Dice dice(52);
  std::map<std::string, std::set<std::string>> kept;
  for (int i = 0; i < 20000; ++i) {
    Simplex<double> simplex = random_simplex(dice, 3 + i % 2);
    for (const auto& e : events_of_kind<SimplexReduced<double>>(step(simplex).events))
      kept[e.why].insert(std::to_string(e.before.size()) + ": " + e.kept + " without " + e.dropped);
  }
  CHECK(kept ==
        std::map<std::string, std::set<std::string>>{
            {"the origin lies beyond this edge; A stays the newest",
             {"3: BA without C", "3: CA without B", "4: BA without DC", "4: CA without DB", "4: DA without CB"}},
            {"in the list A and B change places: the normal, read from it, turns to the origin, and the next faces get "
             "theirs "
             "outward",
             {"3: CAB without "}},
            {"read from the list in this order, the face keeps its normal, toward the origin, and the next faces get "
             "theirs "
             "outward",
             {"4: BDA without C", "4: CBA without D", "4: DCA without B"}}});
}

/// Decides each time otherwise than the numbers say.
struct Contrary : AsIntended {
  static bool is_at_origin(const auto& AO) { return !AsIntended::is_at_origin(AO); }
  static bool is_on_segment(const auto& direction) { return !AsIntended::is_on_segment(direction); }
  static bool is_beyond_edge(const auto& AXn_AO) { return !AsIntended::is_beyond_edge(AXn_AO); }
  static bool is_above_face(const auto& APQn_AO) { return !AsIntended::is_above_face(APQn_AO); }
  static Side side_of_triangle(const auto& ABCn_AO) {
    return AsIntended::side_of_triangle(ABCn_AO) == Side::above ? Side::below : Side::above;
  }
};

/// Returns: what the first region that was tested gave as its reason.
template <class Rules>
std::string first_reason(const std::vector<Vec3<double>>& oldest_first) {
  Simplex<double> simplex = simplex_of(oldest_first);
  Trace<double> trace;
  process<Rules>(simplex, CrossingTest::on, trace);
  for (const auto& region : events_of_kind<RegionTested<double>>(trace.events))
    if (region.verdict != Verdict::skipped) return region.reason;
  return "";
}

/// Looks for the origin on AB by the vector to it: zero where A is the origin, which is more than that.
struct ByVertex : AsIntended {
  static auto from_segment(const auto& /*AB*/, const auto& AO) { return AO; }
};

TEST_CASE("Rules that decide otherwise than their numbers say, or by another vector, are told to do so", "[telling]") {
  using V = Vec3<double>;
  const std::string go_on = ", but these rules go on as if ";
  CHECK(first_reason<Contrary>({V(0, 0, 0)}) == "A is the origin" + go_on + "the origin lies elsewhere");
  CHECK(first_reason<Contrary>({V(1, 0, 0)}) == "the origin lies elsewhere" + go_on + "A is the origin");
  CHECK(first_reason<Contrary>({V(-1, 1, 0), V(1, 1, 0)}) ==
        "the origin lies to one side of AB" + go_on + "the origin lies on AB");
  CHECK(first_reason<Contrary>({V(1, 3, 0), V(-1, 1, 0), V(1, 1, 0)}) ==
        "ABn points toward the origin" + go_on + "ABn does not point toward the origin");
  CHECK(first_reason<Contrary>({V(1, -3, 0), V(-1, 1, 0), V(1, 1, 0)}) ==
        "ABn does not point toward the origin" + go_on + "ABn points toward the origin");
  CHECK(first_reason<ByVertex>({V(1, 0, 0), V(0, 0, 0)}) ==
        "AO is zero, from which these rules conclude: the origin lies on AB");
  CHECK(first_reason<ByVertex>({V(1, 0, 0), V(-1, 0, 0)}) ==
        "AO is not zero, from which these rules conclude: the origin lies to one side of AB");
}

}  // namespace
}  // namespace gjk::test
