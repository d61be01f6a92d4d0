// Which points are farthest: faces, lines and points of shapes and of their sums.

#include "walkthroughs/model/farthest_face.hpp"

#include "tests/kit/catch.hpp"

namespace farthest_face_test {

using namespace walkthroughs::program;
using render::Vec2;

namespace {

constexpr Tolerance fine{1e-12, 1e-12};

Points square() { return {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}; }
Cylinder can() { return {{0, 0, 0}, {0, 0, 3}, 2, 6}; }
Ball ball() { return {{0, 0, 5}, 1}; }

}  // namespace

TEST_CASE("The farthest points of a point set are a face, an edge or a corner") {
  const auto corners = [](const Point& d) { return farthest_face(square(), DirectionFrame(d), fine).hull.size(); };
  CHECK(corners({0, 0, 1}) == 4);
  CHECK(corners({1, 0, 0}) == 2);
  CHECK(corners({1, 2, 3}) == 1);
}

TEST_CASE("The farthest points of a cylinder are a cap, a line on its side or a point of a rim") {
  const FarthestFace cap = farthest_face(can(), DirectionFrame({0, 0, -1}), fine);
  CHECK(cap.reach == 3);
  CHECK(cap.hull.size() == 72);
  const FarthestFace line = farthest_face(can(), DirectionFrame({1, 0, 0}), fine);
  CHECK(line.reach == 2);
  REQUIRE(line.hull.size() == 2);
  CHECK((line.hull[0] - line.hull[1]).norm() == Approx(6));
  const FarthestFace point = farthest_face(can(), DirectionFrame({3, 0, 4}), fine);
  CHECK(point.reach == Approx(3 * 0.8 + 2 * 0.6));
  CHECK(point.hull.size() == 1);
}

TEST_CASE(
    "The slack of a round face is what its polygon cuts off, and what a rounded direction may move a point of a rim") {
  CHECK(farthest_face(can(), DirectionFrame({0, 0, 1}), fine).slack == Approx(2 * (1 - std::cos(std::acos(-1) / 72))));
  CHECK(farthest_face(can(), DirectionFrame({3, 0, 4}), {1e-9, 0.003}).slack == Approx(2 * 0.003 / 0.6));
  CHECK(farthest_face(ball(), DirectionFrame({3, 0, 4}), fine).slack == 0);
  CHECK(farthest_face(Sum{{can(), can()}}, DirectionFrame({0, 0, 1}), fine).slack ==
        Approx(4 * (1 - std::cos(std::acos(-1) / 72))));
}

TEST_CASE("The farthest points of a sum are the sums of the farthest points of its two") {
  const FarthestFace up = farthest_face(Sum{{square(), ball()}}, DirectionFrame({0, 0, 2}), fine);
  CHECK(up.reach == 6);
  CHECK(up.hull.size() == 4);
  const FarthestFace side = farthest_face(Sum{{square(), can()}}, DirectionFrame({1, 0, 0}), fine);
  CHECK(side.reach == 3);
  CHECK(side.hull.size() == 4);  // an edge of the square times a line of the side
  CHECK(bound_of(Sum{{square(), ball()}}) == 7);
}

TEST_CASE("The sum of two hulls: edges of both in order, points and segments move and stretch it") {
  const std::vector<Vec2> triangle{{0, 0}, {2, 0}, {0, 1}}, segment{{0, -1}, {0, 1}}, dot{{5, 5}};
  CHECK(sum_of_hulls(triangle, dot) == std::vector<Vec2>{{5, 5}, {7, 5}, {5, 6}});
  CHECK(sum_of_hulls(dot, triangle) == std::vector<Vec2>{{5, 5}, {7, 5}, {5, 6}});
  CHECK(sum_of_hulls(triangle, segment) == std::vector<Vec2>{{0, -1}, {2, -1}, {2, 1}, {0, 2}});
  CHECK(sum_of_hulls(segment, segment) == std::vector<Vec2>{{0, -2}, {0, 2}});
  CHECK(sum_of_hulls(triangle, triangle) == std::vector<Vec2>{{0, 0}, {4, 0}, {0, 2}});
  std::vector<Vec2> all;
  const std::vector<Vec2> star = convex_hull({{3, 1}, {-2, 2}, {-1, -3}, {2, -2}, {0, 4}});
  for (const Vec2& p : triangle)
    for (const Vec2& q : star) all.push_back(p + q);
  CHECK(sum_of_hulls(triangle, star) == convex_hull(all));
}

TEST_CASE("The distance to a hull is 0 within and that to the nearest edge or corner outside") {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(distance({1, 1}, square) == 0);
  CHECK(distance({3, 1}, square) == 1);
  CHECK(distance({5, 6}, square) == 5);
  CHECK(distance({4, 4}, {{1, 0}}) == 5);
  CHECK(distance({1, 3}, {{0, 0}, {2, 0}}) == 3);
  CHECK(distance({6, 3}, {{0, 0}, {2, 0}}) == 5);
}

}  // namespace farthest_face_test
