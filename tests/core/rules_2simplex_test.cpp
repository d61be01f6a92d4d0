/// Algorithm 4: a triangle.
#include <map>

#include "tests/core/rules_support.hpp"

namespace gjk::test {
namespace {

// Acute, so that each edge's region is where Fig. 7 draws it; even, so that the middles of its edges are lattice points.
const Point C{0, 0, 0}, B{12, 0, 0}, A{4, 10, 0};
const Points CBA{C, B, A};
constexpr int above = -3, below = 3;  // AB×AC points to -z

const std::string skipped_by_algorithm_4 = "B R4, BC R5, C R6, A R2";

template <class S>
void require_outcome_at(const Point& origin, const Outcome& expected, const std::vector<Frame<S>>& frames) {
  require_outcome_at(origin, CBA, skipped_by_algorithm_4, expected, frames);
}

const Outcome R3{"AB R3: yes", "BA", "AB×AO×AB"};
const Outcome R7{"AB R3: no, AC R7: yes", "CA", "AC×AO×AC"};
const Outcome R1_above{"AB R3: no, AC R7: no, ABC R1: yes", "CBA", "ABCn"};
const Outcome R1_below{"AB R3: no, AC R7: no, ABC R1: yes", "CAB", "−ABCn"};
const Outcome R1_in_plane{"AB R3: no, AC R7: no, ABC R1: yes", "", ""};

TEMPLATE_TEST_CASE("Algorithm 4: off the plane of the triangle", "[rules]", float, double, long double, Rational) {
  const auto everywhere = frames<TestType>();
  SECTION("beyond AB (R3) keeps [B, A]") {
    for (const int z : {above, below}) require_outcome_at<TestType>({12, 8, z}, R3, everywhere);
  }
  SECTION("beyond AC (R7) keeps [C, A]") {
    for (const int z : {above, below}) require_outcome_at<TestType>({-4, 6, z}, R7, everywhere);
  }
  SECTION("above (R1) keeps the order") { require_outcome_at<TestType>({6, 4, above}, R1_above, everywhere); }
  SECTION("below (R1) swaps A and B") { require_outcome_at<TestType>({6, 4, below}, R1_below, everywhere); }
}

TEMPLATE_TEST_CASE("Algorithm 4: the origin exactly on the triangle is contained", "[rules]", float, double,
                   long double, Rational) {
  const auto exactly = frames_without_rounding<TestType>();
  SECTION("inside") { require_outcome_at<TestType>({6, 4, 0}, R1_in_plane, exactly); }
  SECTION("on AB") { require_outcome_at<TestType>({8, 5, 0}, R1_in_plane, exactly); }
  SECTION("on AC") { require_outcome_at<TestType>({2, 5, 0}, R1_in_plane, exactly); }
  SECTION("on BC") { require_outcome_at<TestType>({6, 0, 0}, R1_in_plane, exactly); }
  SECTION("at A") { require_outcome_at<TestType>(A, R1_in_plane, exactly); }
  SECTION("at B") { require_outcome_at<TestType>(B, R1_in_plane, exactly); }
  SECTION("at C") { require_outcome_at<TestType>(C, R1_in_plane, exactly); }
}

TEMPLATE_TEST_CASE("Algorithm 4: in the plane, outside the triangle, the search stays in the plane", "[rules]", float,
                   double, long double, Rational) {
  const auto exactly = frames_without_rounding<TestType>();
  SECTION("beyond AB") { require_outcome_at<TestType>({12, 8, 0}, R3, exactly); }
  SECTION("beyond AC") { require_outcome_at<TestType>({-4, 6, 0}, R7, exactly); }
}

TEMPLATE_TEST_CASE("Algorithm 4: straight above or below an edge is not beyond it", "[rules]", float, double,
                   long double, Rational) {
  const auto exactly = frames_without_rounding<TestType>();
  SECTION("above AB") { require_outcome_at<TestType>({8, 5, above}, R1_above, exactly); }
  SECTION("below AB") { require_outcome_at<TestType>({8, 5, below}, R1_below, exactly); }
  SECTION("above AC") { require_outcome_at<TestType>({2, 5, above}, R1_above, exactly); }
  SECTION("below AC") { require_outcome_at<TestType>({2, 5, below}, R1_below, exactly); }
}

TEST_CASE("Algorithm 4: where both edges at an obtuse A see the origin, AB is asked first", "[rules]") {
  const std::vector<Vec3<Rational>> simplex =
      seen_from<Rational>({0, -9, 0}, {{-8, 4, 0}, {8, 4, 0}, {0, 0, 0}}, axis_aligned<Rational>("1", 1));
  REQUIRE(coordinates_of_origin(exact(simplex))[0] < 0);  // beyond AB
  REQUIRE(coordinates_of_origin(exact(simplex))[1] < 0);  // beyond AC
  require_outcome(R3, skipped_by_algorithm_4, simplex);
}

/// The region of Fig. 7, from coordinates in place of normals. Returns: nothing where the history of Algorithm 1 rules
/// the place out, that is beyond BC or beyond a corner.
std::optional<Outcome> outcome_by_coordinates(const ExactVecs& cba) {
  const auto of_triangle = coordinates_of_origin(cba);
  const auto within = [](const ExactVecs& edge) {
    const auto c = coordinates_of_origin(edge);
    return c[0] >= 0 && c[1] >= 0;
  };
  if (of_triangle[2] < 0) return std::nullopt;
  if (of_triangle[0] < 0) return within({cba[1], cba[2]}) ? std::optional(R3) : std::nullopt;
  if (of_triangle[1] < 0) return within({cba[0], cba[2]}) ? std::optional(R7) : std::nullopt;
  const Rational height = orientation({0, 0, 0}, cba[2], cba[1], cba[0]);  // of the origin over AB×AC
  return height > 0 ? R1_above : height < 0 ? R1_below : R1_in_plane;
}

/// ABn·AO is minus C's coordinate, ACn·AO minus B's, times four times the square of the area; also where rejected.
void require_values_by_coordinates(const Told<Rational>& told, const ExactVecs& cba) {
  const auto coordinates = coordinates_of_origin(cba);
  const Rational area = gram_determinant(cba);
  REQUIRE(std::get<Rational>(told.region("AB").value) == -coordinates[0] * area);
  if (told.decided != R3.decided) REQUIRE(std::get<Rational>(told.region("AC").value) == -coordinates[1] * area);
  if (told.regions.back().feature == "ABC")
    REQUIRE(std::get<Rational>(told.region("ABC").value) == orientation({0, 0, 0}, cba[2], cba[1], cba[0]));
}

TEST_CASE(
    "Algorithm 4 agrees with linear equations in every region it can be called in, whatever the order of vertices",
    "[rules][unsanitized]") {
  std::map<std::string, int> reached;
  for (const auto& frame : frames<Rational>()) {
    Points order = CBA;
    std::sort(order.begin(), order.end());
    do
      for (int x = -5; x <= 17; x += 2)
        for (int y = -4; y <= 12; y += 2)
          for (const int z : {-4, 0, 3}) {
            const auto simplex = seen_from({x, y, z}, order, frame);
            const auto expected = outcome_by_coordinates(exact(simplex));
            if (!expected) continue;
            INFO(frame.name << ", origin at " << x << " " << y << " " << z);
            const auto told = require_outcome(*expected, skipped_by_algorithm_4, simplex);
            require_values_by_coordinates(told, exact(simplex));
            ++reached[expected->expression];
          }
    while (std::next_permutation(order.begin(), order.end()));
  }
  for (const Outcome& outcome : {R3, R7, R1_above, R1_below, R1_in_plane}) {
    INFO(outcome.decided << " " << outcome.next);
    REQUIRE(reached[outcome.expression] >= 100);
  }
}

TEST_CASE("Algorithm 4 gives Eqs. 10 and 11 their reasons and texts", "[rules]") {
  const auto told = ask_rules(seen_from<double>({6, 4, above}, CBA, axis_aligned("1", 1.0)));
  REQUIRE(told.region("AB").expression == "ABn·AO");
  REQUIRE(told.region("AB").formula == "AB×ABCn");
  REQUIRE(told.region("AC").expression == "ACn·AO");
  REQUIRE(told.region("AC").formula == "ABCn×AC");
  REQUIRE(told.region("ABC").expression == "ABCn·AO");
  REQUIRE(told.region("ABC").formula == "AB×AC");
}

}  // namespace
}  // namespace gjk::test
