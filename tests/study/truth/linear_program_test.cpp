#include "tests/study/truth/linear_program.hpp"

#include <limits>

#include "tests/kit/catch.hpp"
#include "tests/study/pairs/hulls.hpp"

namespace study {
namespace linear_program_test {

const Points triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const Points pierces_triangle{{1, 1, -1}, {1, 1, 1}};  // at (1,1,0): 1/2, 1/4, 1/4 of its corners
const Points above_triangle{{1, 1, 1}, {1, 2, 3}};

CommonPoint piercing() {
  return {{{0, Rational(1, 2)}, {1, Rational(1, 4)}, {2, Rational(1, 4)}}, {{0, Rational(1, 2)}, {1, Rational(1, 2)}}};
}

TEST_CASE("Certificates: a common point by hand holds", "[linear-program]") {
  REQUIRE(holds(piercing(), triangle, pierces_triangle));
}

TEST_CASE("Certificates: a common point is refused where the two combinations differ", "[linear-program]") {
  CommonPoint common = piercing();
  common.of_a = {{0, Rational(1, 4)}, {1, Rational(1, 4)}, {2, Rational(1, 2)}};
  REQUIRE_FALSE(holds(common, triangle, pierces_triangle));
}

TEST_CASE("Certificates: a common point is refused where weights do not add up to 1", "[linear-program]") {
  CommonPoint common = piercing();
  common.of_a[0].weight = Rational(1, 3);  // of the origin: the sum of the points stays the same
  REQUIRE_FALSE(holds(common, triangle, pierces_triangle));
}

TEST_CASE("Certificates: a common point is refused where a weight is negative", "[linear-program]") {
  const Points segment{{0, 0, 0}, {1, 0, 0}}, beyond{{2, 0, 0}};
  REQUIRE_FALSE(holds(CommonPoint{{{0, -1}, {1, 2}}, {{0, 1}}}, segment, beyond));
}

TEST_CASE("Certificates: a common point is refused where it names a point that is not there", "[linear-program]") {
  Points points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {5, 5, 5}};
  points.pop_back();  // after which it still lies behind the others
  REQUIRE_FALSE(holds(CommonPoint{{{3, 1}}, {{0, 1}}}, points, Points{{5, 5, 5}}));
}

TEST_CASE("Certificates: a common point is refused where a list is empty", "[linear-program]") {
  REQUIRE_FALSE(holds(CommonPoint{}, triangle, pierces_triangle));
}

TEST_CASE("Certificates: a separating direction by hand holds, its opposite does not", "[linear-program]") {
  REQUIRE(holds(SeparatingDirection{{0, 0, -1}}, triangle, above_triangle));
  REQUIRE_FALSE(holds(SeparatingDirection{{0, 0, 1}}, triangle, above_triangle));
}

TEST_CASE("Certificates: a direction is refused where the sets touch along it, and where it is zero",
          "[linear-program]") {
  REQUIRE_FALSE(holds(SeparatingDirection{{0, 0, -1}}, triangle, Points{{1, 1, 0}, {1, 2, 3}}));
  REQUIRE_FALSE(holds(SeparatingDirection{{0, 0, 0}}, triangle, above_triangle));
}

TEST_CASE("Certificates: a direction is refused where only the last point of B is on the wrong side",
          "[linear-program]") {
  REQUIRE_FALSE(holds(SeparatingDirection{{0, 0, -1}}, triangle, Points{{1, 1, 1}, {1, 2, -1}}));
}

TEST_CASE("Certificates: a direction is refused where only the last point of A is on the wrong side",
          "[linear-program]") {
  REQUIRE_FALSE(holds(SeparatingDirection{{0, 0, -1}}, Points{{0, 0, 0}, {0, 0, 2}}, above_triangle));
}

TEST_CASE("Certificates: a gap of 10^-40 of the coordinates is a gap", "[linear-program]") {
  const Points one{{1, 0, 0}}, other{{1, 1e-40, 0}};
  REQUIRE(holds(SeparatingDirection{{0, -1, 0}}, one, other));
}

TEST_CASE("Linear program: the answer comes with a certificate of its kind", "[linear-program]") {
  const Certificate hit = certificate(triangle, pierces_triangle), miss = certificate(triangle, above_triangle);
  REQUIRE(holds(std::get<CommonPoint>(hit), triangle, pierces_triangle));
  REQUIRE(holds(std::get<SeparatingDirection>(miss), triangle, above_triangle));
}

TEST_CASE("Linear program: what the last bit decides is decided", "[linear-program]") {
  const Points box{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  REQUIRE(truth_by_linear_program(box, plus({1, 0.5, 0.5}, box)) == Truth::intersecting);
  REQUIRE(truth_by_linear_program(box, plus({1 - 0x1p-53, 0.5, 0.5}, box)) == Truth::intersecting);
  REQUIRE(truth_by_linear_program(box, plus({1 + 0x1p-52, 0.5, 0.5}, box)) == Truth::separated);
}

TEST_CASE("Linear program: the least doubles count", "[linear-program]") {
  constexpr double t = std::numeric_limits<double>::denorm_min();
  const Points segment{{1, 0, 0}, {1, 6 * t, 3 * t}}, third_of_it{{1, 2 * t, t}}, beside_it{{1, 2 * t, 2 * t}};
  REQUIRE(truth_by_linear_program(segment, third_of_it) == Truth::intersecting);
  REQUIRE(truth_by_linear_program(segment, beside_it) == Truth::separated);
}

TEST_CASE("Linear program: where products of coordinates leave the range of doubles the answer stands",
          "[linear-program]") {
  for (const double unit : {0x1p-1070, 0x1p-500, 0x1p500, 0x1p1020}) {
    INFO("times " << unit);
    const Points big = times(unit, triangle);
    REQUIRE(truth_by_linear_program(big, times(unit, pierces_triangle)) == Truth::intersecting);
    REQUIRE(truth_by_linear_program(big, times(unit, above_triangle)) == Truth::separated);
  }
}

TEST_CASE("Linear program: no points, and coordinates that are not finite, are refused", "[linear-program]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  REQUIRE_THROWS_AS(truth_by_linear_program({}, triangle), std::invalid_argument);
  REQUIRE_THROWS_AS(truth_by_linear_program(triangle, {}), std::invalid_argument);
  REQUIRE_THROWS_AS(truth_by_linear_program(triangle, {{0, nan, 0}}), std::invalid_argument);
  REQUIRE_THROWS_AS(truth_by_linear_program({{0, 0, infinite}}, triangle), std::invalid_argument);
}

}  // namespace linear_program_test
}  // namespace study
