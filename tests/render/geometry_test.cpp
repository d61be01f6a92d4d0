#include "render/geometry.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/kit/catch.hpp"

namespace geometry_test {

using namespace render;

namespace {
const Box box{{10, 20}, {30, 40}};
}

TEST_CASE("a segment beside a box, past its corner or short of it is outside") {
  REQUIRE_FALSE(clip_segment({0, 45}, {40, 45}, box));
  REQUIRE_FALSE(clip_segment({0, 15}, {9, 30}, box));
  REQUIRE_FALSE(clip_segment({0, 30}, {9, 30}, box));
  REQUIRE_FALSE(clip_segment({25, 14.8}, {35, 24.8}, box));  // past the corner (30,20)
  REQUIRE(clip_segment({24.8, 15}, {34.8, 25}, box).has_value());
}

TEST_CASE("a simplified polygon keeps the corners that stand out and leaves out those that do not") {
  const std::vector<Vec2> square = {{0, 0}, {2, -0.01}, {4, 0}, {4, 4}, {2, 4.2}, {0, 4}};
  REQUIRE(simplified(square, 0.1) == std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {2, 4.2}, {0, 4}});
  REQUIRE(simplified(square, 0.001) == square);
  REQUIRE(simplified({}, 1).empty());
  REQUIRE(simplified(std::vector<Vec2>{{1, 2}}, 1) == std::vector<Vec2>{{1, 2}});
}

TEST_CASE("a circle of very many corners keeps as few as the tolerance needs") {
  constexpr int corners = 50'000;
  constexpr double radius = 100, tolerance = 0.01;
  std::vector<Vec2> circle;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    circle.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  // A chord of angle t is radius t^2 / 8 away from the circle.
  const double fewest = 2 * std::numbers::pi / std::sqrt(8 * tolerance / radius);
  const auto kept = static_cast<double>(simplified(circle, tolerance).size());
  REQUIRE(kept >= fewest - 1);
  REQUIRE(kept <= 2 * fewest);
}

}  // namespace geometry_test
