/// Balls and cylinders: the oracle's formulas by hand and against other ways, and the gaps of the families.
#include <cmath>
#include <string>

#include "tests/kit/catch.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace families_round_test {

constexpr Truth separated = Truth::separated, intersecting = Truth::intersecting;
constexpr double ulp = 0x1p-52;  // of numbers from 1 to 2

void require_truth(const Body& a, const Body& b, Truth expected) {
  REQUIRE(truth({a, b}) == expected);
  REQUIRE(truth({b, a}) == expected);
}

const Can upright{{0, 0, 0}, {0, 0, 1}, 5, 4};

TEST_CASE("Oracle: balls that touch, and one ulp apart", "[oracle]") {
  const Ball ball{{0, 0, 0}, 1};
  require_truth(ball, Ball{{2, 0, 0}, 1}, intersecting);
  require_truth(ball, Ball{{2 + 2 * ulp, 0, 0}, 1}, separated);
  require_truth(ball, Ball{{1, 2, 2}, 2}, intersecting);  // 3 apart, askew
  require_truth(ball, Ball{{1, 2, 2 + 2 * ulp}, 2}, separated);
  require_truth(ball, Ball{{0, 0, 0}, 0.5}, intersecting);
}

TEST_CASE("Oracle: parallel cylinders, side by side and end to end", "[oracle]") {
  const Can thin{{6, 8, 1}, {0, 0, -2}, 5, 1};  // 10 from axis to axis
  require_truth(upright, thin, intersecting);
  require_truth(upright, Can{{6, 8 + 8 * ulp, 1}, {0, 0, 1}, 5, 1}, separated);
  require_truth(upright, Can{{1, 1, 3}, {0, 0, 1}, 1, 2}, intersecting);
  require_truth(upright, Can{{1, 1, 3 + 2 * ulp}, {0, 0, 1}, 1, 2}, separated);
  require_truth(upright, Can{{0, 0, 1}, {0, 0, 1}, 1, 1}, intersecting);  // inside
}

TEST_CASE("Oracle: crossed cylinders, side against side and rim against rim", "[oracle]") {
  require_truth(upright, Can{{0, 7, 0}, {3, 0, 0}, 2, 2}, intersecting);  // sides: 5 + 2
  require_truth(upright, Can{{0, 7 + 4 * ulp, 0}, {3, 0, 0}, 2, 2}, separated);
  // The end of the other is 3 along x: there A's disc is 4 wide; its axis is 3 above A's cap: there it is 4 wide.
  require_truth(upright, Can{{4, 8, 5}, {1, 0, 0}, 5, 2}, intersecting);
  require_truth(upright, Can{{4, 8 + 8 * ulp, 5}, {1, 0, 0}, 5, 2}, separated);
  require_truth(upright, Can{{6 + 4 * ulp, 0, 0}, {1, 0, 0}, 1, 2}, separated);  // beyond the side
  require_truth(upright, Can{{6, 0, 0}, {1, 0, 0}, 1, 2}, intersecting);         // its cap on the side
  require_truth(upright, Can{{0, 0, 7}, {0, 1, 0}, 5, 2}, intersecting);         // its side on the cap
  require_truth(upright, Can{{0, 0, 7 + 4 * ulp}, {0, 1, 0}, 5, 2}, separated);
}

TEST_CASE("Oracle: a ball on a cylinder's side, cap and rim", "[oracle]") {
  require_truth(Ball{{6, 8, 1}, 5}, upright, intersecting);
  require_truth(Ball{{6, 8 + 8 * ulp, 1}, 5}, upright, separated);
  require_truth(Ball{{1, 2, 3}, 1}, upright, intersecting);
  require_truth(Ball{{1, 2, 3 + 2 * ulp}, 1}, upright, separated);
  require_truth(Ball{{9, 0, 5}, 5}, upright, intersecting);  // 4 off the side, 3 above the cap
  require_truth(Ball{{9 + 8 * ulp, 0, 5}, 5}, upright, separated);
  require_truth(Ball{{0, 0, 0}, 0.5}, upright, intersecting);
}

TEST_CASE("Oracle: what it cannot judge, it refuses", "[oracle]") {
  REQUIRE_THROWS_AS(truth({upright, Can{{0, 0, 0}, {1, 1, 0}, 1, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(truth({upright, Can{{0, 0, 0}, {0, 0, 0}, 1, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(truth({Ball{{0, 0, 0}, 1}, Points{{0, 0, 0}}}), std::invalid_argument);
  REQUIRE_THROWS_AS(truth({Ball{{0, 0, 0}, 1}, Ball{{HUGE_VAL, 0, 0}, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(truth({upright, Can{{0, 0, 0}, {0, 0, 1}, HUGE_VAL, 1}}), std::invalid_argument);
  const Points triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  REQUIRE_THROWS_AS(truth({triangle, Points{{0, 0, 0}, {1, 0, 0}, {0, HUGE_VAL, 0}}}), std::invalid_argument);
}

/// Corners of a prism inside the cylinder, whose sides are nearly those of the cylinder.
Points prism_in(const Can& can) {
  Eigen::Index axis = 0;
  can.axis.cwiseAbs().maxCoeff(&axis);
  Points corners;
  for (int i = 0; i < 64; ++i)
    for (const double end : {-0.5, 0.5}) {
      const double angle = i * std::acos(-1) / 32;
      Vec corner = can.center;
      corner[axis] += end * can.height;
      corner[(axis + 1) % 3] += can.radius * std::cos(angle);
      corner[(axis + 2) % 3] += can.radius * std::sin(angle);
      corners.push_back(corner);
    }
  return corners;
}

Can grown(Can can, double factor) {
  can.radius *= factor;
  can.height *= factor;
  return can;
}

TEST_CASE("Oracle: cylinders are judged as prisms in and around them are, where these agree", "[oracle]") {
  int agreed = 0;
  for (std::uint64_t index = 0; index < 200; ++index) {
    const Pair pair = family_named("cylinders").make(1, index);
    const Can &a = std::get<Can>(pair.a), &b = std::get<Can>(pair.b);
    const Truth within = truth({prism_in(a), prism_in(b)});
    const Truth around = truth({prism_in(grown(a, 1.01)), prism_in(grown(b, 1.01))});
    INFO(index);
    if (within != around) continue;
    ++agreed;
    REQUIRE(truth(pair) == within);
  }
  REQUIRE(agreed > 150);
}

// -- Gaps -------------------------------------------------------------------------------------------------------------

Vec center(const Body& body) {
  if (const auto* ball = std::get_if<Ball>(&body)) return ball->center;
  return std::get<Can>(body).center;
}

/// B moved away from A's center, or toward it.
Pair apart(Pair pair, double factor) {
  const Vec moved = center(pair.a) + factor * (center(pair.b) - center(pair.a));
  if (auto* ball = std::get_if<Ball>(&pair.b)) ball->center = moved;
  if (auto* can = std::get_if<Can>(&pair.b)) can->center = moved;
  return pair;
}

TEST_CASE("Families: balls and cylinders with a gap: three times that gap the other way, and the answer is the other",
          "[families]") {
  for (const std::string kind : {"spheres-gap-", "cylinders-gap-"})
    for (const std::string gap : {"1e-3", "1e-6", "1e-9", "1e-12"}) {
      INFO(kind + gap);
      const double g = std::stod(gap);
      for (std::uint64_t index = 0; index < 100; ++index) {
        const Pair pair = family_named(kind + gap).make(1, index);
        const bool meet = truth(pair) == intersecting;
        REQUIRE(truth(apart(pair, meet ? 1 + 3 * g : 1 - 3 * g)) != truth(pair));
      }
    }
}

TEST_CASE("Families: balls with a gap have that gap", "[families]") {
  for (std::uint64_t index = 0; index < 100; ++index) {
    const Pair pair = family_named("spheres-gap-1e-6").make(1, index);
    const Ball &a = std::get<Ball>(pair.a), &b = std::get<Ball>(pair.b);
    const double distance = (b.center - a.center).norm() / (a.radius + b.radius);
    REQUIRE(std::abs(std::abs(distance - 1) - 1e-6) < 1e-14);
  }
}

}  // namespace families_round_test
}  // namespace study
