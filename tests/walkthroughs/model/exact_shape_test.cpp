// What can be said of cylinders that lie askew, where a pose puts them.

#include "walkthroughs/model/exact_shape.hpp"

#include <cmath>
#include <map>

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/truth_about.hpp"

namespace exact_shape_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Status;
using gjk::test::exact;
using gjk::test::ExactVec;
using gjk::test::Rational;
using gjk::test::times;

namespace {

/// q p q⁻¹.
ExactVec turned(const gjk::Quaternion& q, const Point& p) {
  const ExactVec v = exact(Point(q.x, q.y, q.z)), of = exact(p);
  const Rational w = q.w, square = w * w + v.dot(v);
  const auto cross = [](const ExactVec& a, const ExactVec& b) {
    return ExactVec(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  };
  const ExactVec sum = times(w * w - v.dot(v), of) + times(2 * v.dot(of), v) + times(2 * w, cross(v, of));
  return times(1 / square, sum);
}

/// Without a square root: all lengths are squared and multiplied by that of the axis.
Status truth_of_point(const Object& can, const Point& p) {
  const auto& [center, axis, radius, height] = std::get<Cylinder>(can.form);
  const ExactVec a = turned(*can.pose.quaternion, axis),
                 way = exact(p) - turned(*can.pose.quaternion, center) - exact(can.pose.translation);
  const Rational along = way.dot(a), square = a.dot(a), r = radius, h = Rational(height) / 2;
  const bool is_inside = along * along <= h * h * square && way.dot(way) * square - along * along <= r * r * square;
  return is_inside ? Status::intersecting : Status::separated;
}

Object point_at(const Point& p) { return {"point", Points{p}}; }

double size_of(const Object& can) {
  const auto& [center, axis, radius, height] = std::get<Cylinder>(can.form);
  return center.lpNorm<1>() + can.pose.translation.lpNorm<1>() + radius + height;
}

}  // namespace

TEST_CASE("Of a cylinder that a quaternion turns no answer is wrong, in doubles and rounded to floats") {
  kit::Dice dice(5);
  const auto number = [&] { return dice.between(-1.0, 1.0); };
  std::map<Status, int> seen;
  for (int i = 0; i < 2000; ++i) {
    Scene scene = walkthrough_of({{0, 0, 0}}).scenes[0];
    Object& can = scene.a;
    can.form = Cylinder{{number(), number(), number()},
                        {number(), number(), number()},
                        dice.between(0.1, 1.0),
                        std::pow(10.0, dice.between(-1.0, 2.0))};
    can.pose.translation = {number(), number(), number()};
    can.pose.quaternion = gjk::Quaternion{number(), number(), number(), number()};
    can.pose.rotation = matrix_of(*can.pose.quaternion);
    // At the rim, or on the side, and a little beside it.
    const auto& [center, axis, radius, height] = std::get<Cylinder>(can.form);
    const Point up = axis.normalized(), out = up.cross(Point(number(), number(), number())).normalized();
    const double beside = 1 + std::pow(10.0, -dice.between(3, 17)) * (dice.coin() ? 1 : -1);
    const Point p = center + up * (height / 2 * (dice.coin() ? 1 : number())) * beside + out * radius * beside;
    scene.b = point_at(can.pose(p));
    if (dice.coin()) scene = in_float(scene);
    const Status truth = truth_of_point(scene.a, std::get<Points>(scene.b.form)[0]);
    INFO("scene " << i);
    const gjk::ShapesResult said = bounded_answer(scene.a, scene.b);
    ++seen[said.status];
    if (said.status == Status::undecided)
      REQUIRE(said.gap <= 10 * 0x1p-53 * size_of(scene.a));
    else
      REQUIRE(said.status == truth);
  }
  CHECK(seen[Status::separated] > 500);
  CHECK(seen[Status::intersecting] > 300);
}

TEST_CASE("Numbers that only long doubles can be asked about are answered, too") {
  const Object can{"can", Cylinder{{0, 0, 0}, {1, 1, 0}, 1, 1}};
  for (const double far : {1e303, 1e305, 1e306, 1e307})
    CHECK(bounded_answer(can, point_at({far, 0, 0})).status == Status::separated);
  const Object huge{"huge", Cylinder{{0, 0, 0}, {1, 1, 0}, 1e306, 1e306}};
  CHECK(bounded_answer(huge, point_at({0, 0, 1})).status == Status::intersecting);
}

TEST_CASE("Cylinders whose sizes no double can add up are answered as small ones") {
  const auto status = [](double unit, double away) {
    const Object can{"can", Cylinder{{unit, unit, unit}, {1, 1, 0}, unit, 1.5 * unit}};
    Object other{"other", Sum{{Cylinder{{-unit, unit, 0}, {0, 1, 1}, unit, unit}, Points{{0, 0, away * unit}}}}};
    other.pose.translation = {unit, -unit, 0};
    return bounded_answer(can, other).status;
  };
  for (const double unit : {1.0, 0x1p1022, 0x1p1023}) {
    CAPTURE(unit);
    CHECK(status(unit, 1) == Status::intersecting);
    CHECK(status(unit, -1.9) == Status::separated);
  }
  const auto touching = [](double unit) {
    return bounded_answer({"can", Cylinder{{unit, 0, 0}, {1, 1, 0}, 0, unit}}, point_at({unit, 0, 0}));
  };
  REQUIRE(touching(0x1p1023).status == Status::undecided);
  CHECK(touching(0x1p1023).gap == std::ldexp(touching(1).gap, 1023));
}

TEST_CASE("Thin cylinders side by side are undecided only where rounding leaves it open") {
  // Three points of their difference lie so nearly in one line that doubles do not know the plane.
  const auto can = [](const Point& center, double radius, double height, const Point& translation) {
    Object made{"can", Cylinder{center, {4.1638127659546747e-10, 0, 1}, radius, height}};
    made.pose.translation = translation;
    made.pose.quaternion = gjk::Quaternion{0, 1e-150, -2e-150, 1e-150};
    made.pose.rotation = matrix_of(*made.pose.quaternion);
    return made;
  };
  const Object a = can({-0.3151901406856107, -0.0, 0.06265191115913661}, 0.0, 0.04125727746978125,
                       {-0.23108783860136192, -0.7560753250262263, -2.460035221614305}),
               b = can({0.0, -0.0, -0.00023812629745351553}, 1.1430806342090707e-05, 7.040598926312652,
                       {0.0, -0.5878837249668296, -2.6070179585579});
  const gjk::ShapesResult said = bounded_answer(a, b);
  if (said.status == Status::undecided) CHECK(said.gap <= 0x1p-53 * size_of(b));
}

}  // namespace exact_shape_test
