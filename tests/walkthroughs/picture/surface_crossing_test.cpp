// The line in which two surfaces cross, held against formulas.

#include "walkthroughs/picture/surface_crossing.hpp"

#include <numbers>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/shapes.hpp"
#include "tests/walkthroughs/support.hpp"

namespace surface_crossing_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

constexpr double pi = std::numbers::pi;

Eigen::Matrix3d turned() { return Eigen::AngleAxisd(0.7, Point(1, -2, 3).normalized()).toRotationMatrix(); }

double length_of(const std::vector<CrossingPiece>& pieces) {
  double sum = 0;
  for (const CrossingPiece& piece : pieces) sum += (piece.to - piece.from).norm();
  return sum;
}

std::vector<CrossingPiece> crossing(const AnyShape& a, const AnyShape& b, const Point& of_b) {
  const Object one{"a", a, {turned(), {1, 2, 3}}}, other{"b", b, {turned(), Point(1, 2, 3) + turned() * of_b}};
  return crossing_of(one, body_of(one, Dimension::space), other, body_of(other, Dimension::space));
}

}  // namespace

TEST_CASE("The line in which two surfaces cross is as long as formulas have it") {
  CHECK(length_of(crossing(box(1, 1, 1), box(1, 1, 1), {1.5, 1.25, 0.75})) == Approx(2 * (0.5 + 0.75 + 1.25)));
  CHECK(length_of(crossing(box(1, 1, 1), box(2, 0.5, 0.5), {0, 0, 0.25})) == Approx(2 * 4));  // through and through
  CHECK(length_of(crossing(ball(1), ball(1), {1, 0, 0})) == Approx(2 * pi * std::sqrt(0.75)).epsilon(0.01));
  CHECK(length_of(crossing(ball(1), box(3, 3, 0.5), {0, 0, 1})) == Approx(2 * pi * std::sqrt(0.75)).epsilon(0.01));
  const Cylinder upright{{0, 0, 0}, {0, 0, 1}, 1, 2};
  CHECK(length_of(crossing(upright, box(3, 3, 1), {0, 0, 1})) == Approx(2 * pi).epsilon(0.01));
}

TEST_CASE("Surfaces that do not cross have no such line, and one of flat objects is seen from either side once") {
  CHECK(crossing(box(1, 1, 1), box(1, 1, 1), {2.5, 0, 0}).empty());
  CHECK(crossing(box(3, 3, 3), box(1, 1, 1), {0, 0, 0}).empty());
  CHECK(crossing(ball(3), ball(1), {0, 0, 0}).empty());
  CHECK(crossing(box(1, 1, 1), Points{{-1, 0, 0}, {2, 0, 0}}, {0, 0, 0}).empty());
  const auto pieces = crossing(triangle(), Points{{1, 1, -1}, {1, 1, 1}, {2, 0.5, 0}}, {0, 0, 0});
  REQUIRE(pieces.size() == 4);
  const Lens lens{render::Camera(35, 25)};
  CHECK(1 == std::ranges::count_if(pieces, [&](const CrossingPiece& piece) {
          return lens.sees(piece.outward_a) && lens.sees(piece.outward_b);
        }));
  CHECK(length_of(pieces) == Approx(4 * std::sqrt(1.25)));
}

}  // namespace surface_crossing_test
