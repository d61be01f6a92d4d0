// Shapes told by their fields: converted, measured, named and asked without knowing which they are.

#include "walkthroughs/model/any_shape.hpp"

#include "core/certified/fraction.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/support.hpp"

namespace any_shape_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

Point point_at_random(kit::Dice& dice) {
  const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0);
  return {x, y, dice.between(-1.0, 1.0)};
}

Points points_at_random(kit::Dice& dice, int count) {
  Points list;
  for (int i = 0; i < count; ++i) list.push_back(point_at_random(dice));
  return list;
}

AnyShape shape_at_random(kit::Dice& dice, int sums = 2) {
  const int kind = dice.between(0, sums > 0 ? 5 : 4);
  if (kind == 0) return points_at_random(dice, 5);
  if (kind == 5) {
    const AnyShape one = shape_at_random(dice, sums - 1);
    return Sum{{one, shape_at_random(dice, sums - 1)}};
  }
  const Point center = point_at_random(dice), axis = point_at_random(dice);
  const double radius = dice.between(0.0, 1.0);
  if (kind == 1) return Ball{center, radius};
  if (kind == 3) return BoxOf<double>{center, axis.cwiseAbs()};
  if (kind == 4) return CapsuleOf<double>{center, axis, radius};
  return Cylinder{center, axis, radius, dice.between(0.0, 1.0)};
}

Points all_sums(const Points& a, const Points& b) {
  Points all;
  for (const Point& p : a)
    for (const Point& q : b) all.push_back(p + q);
  return all;
}

/// Returns: how far a shape reaches along d, from the formulas of each.
double reach(const AnyShape& shape, const Point& d) {
  if (const auto* points = std::get_if<Points>(&shape)) {
    double most = points->at(0).dot(d);
    for (const Point& p : *points) most = std::max(most, p.dot(d));
    return most;
  }
  if (const auto* ball = std::get_if<Ball>(&shape)) return ball->center.dot(d) + ball->radius * d.norm();
  if (const auto* can = std::get_if<Cylinder>(&shape)) {
    const Point n = can->axis.normalized();
    return can->center.dot(d) + std::abs(n.dot(d)) * can->height / 2 + n.cross(d).norm() * can->radius;
  }
  if (const auto* box = std::get_if<BoxOf<double>>(&shape)) return box->center.dot(d) + box->size.dot(d.cwiseAbs()) / 2;
  if (const auto* capsule = std::get_if<CapsuleOf<double>>(&shape))
    return std::max(capsule->from.dot(d), capsule->to.dot(d)) + capsule->radius * d.norm();
  const auto& sum = std::get<Sum>(shape);
  return reach(sum.summands.at(0), d) + reach(sum.summands.at(1), d);
}

Cylinder can() { return {{1, -2, 3}, {0, 5, 0}, 0.5, 7}; }

}  // namespace

TEST_CASE("Support of a sum (Eq. 7): the farthest point reaches as far as those of the two together") {
  kit::Dice dice(3);
  for (int i = 0; i < 500; ++i) {
    const AnyShape one = shape_at_random(dice), shape = Sum{{one, shape_at_random(dice)}};
    const Point d = point_at_random(dice);
    const gjk::SupportPoint<double> found = Asked<double>(shape).support(d);
    CHECK(found.point.dot(d) == Approx(reach(shape, d)).margin(1e-12));
    CHECK(!found.index);
    CHECK(middle(shape).dot(d) <= reach(shape, d));  // which lies inside
  }
}

TEST_CASE(
    "A sum of point sets is, to the support function and to GJK, the set of all sums, in doubles and in fractions") {
  kit::Dice dice(5);
  for (int i = 0; i < 100; ++i) {
    Points
        sets[3];  // of quarters: doubles hold all that is computed from these, so that both ways find the same numbers
    for (Points& points : sets) {
      points = points_at_random(dice, 4);
      for (Point& p : points) p = (p * 64).array().round() / 4;
    }
    const AnyShape sum = Sum{{sets[0], sets[1]}}, all_of_them = all_sums(sets[0], sets[1]);
    const Point d = point_at_random(dice);
    CHECK(Asked<double>(sum).support(d).point == Asked<double>(all_of_them).support(d).point);
    const auto in_fractions = [&](const AnyShape& shape) {
      return Asked<gjk::Fraction>(converted<gjk::Fraction>(shape, Cast<gjk::Fraction>{}))
          .support(d.cast<gjk::Fraction>())
          .point;
    };
    CHECK(in_fractions(sum) == in_fractions(all_of_them));
    const auto result = [&](const AnyShape& shape) {
      return all<gjk::Finished>(run({.name = "", .a = {"a", shape}, .b = {"b", sets[2]}})).at(0).result;
    };
    const gjk::Result<double> found = result(sum), expected = result(all_of_them);
    CHECK(found.status == expected.status);
    CHECK(found.iterations == expected.iterations);
    REQUIRE(found.simplex.size() == expected.simplex.size());
    for (int k = 0; k < found.simplex.size(); ++k) CHECK(found.simplex[k].w == expected.simplex[k].w);
  }
}

TEST_CASE("A box has as many corners as it needs: eight, four where it is flat, one where it has no size") {
  const auto corners = [](const Point& size) {
    return std::get<Points>(ShapeRow<BoxOf<double>>::as_sum({{1, 2, 3}, size}).summands[1]).size();
  };
  CHECK(corners({1, 2, 3}) == 8);
  CHECK(corners({1, 0, 3}) == 4);
  CHECK(corners({0, 0, 0}) == 1);
}

TEST_CASE("Converting turns each number by what it is") {
  struct Marked {
    Point point(const Point& p) const { return p + Point(100, 0, 0); }
    Point direction(const Point& d) const { return -d; }
    double length(double x) const { return 2 * x; }
  };
  const AnyShape shape = Sum{{Points{{1, 2, 3}, {4, 5, 6}}, Sum{{Ball{{7, 8, 9}, 10}, can()}}}};
  const AnyShape found = converted<double>(shape, Marked{});
  const Sum& sum = std::get<Sum>(found);
  CHECK(std::get<Points>(sum.summands.at(0)) == Points{{101, 2, 3}, {104, 5, 6}});
  const Sum& inner = std::get<Sum>(sum.summands.at(1));
  CHECK(std::get<Ball>(inner.summands.at(0)).center == Point(107, 8, 9));
  CHECK(std::get<Ball>(inner.summands.at(0)).radius == 20);
  const Cylinder& cylinder = std::get<Cylinder>(inner.summands.at(1));
  CHECK(cylinder.center == Point(101, -2, 3));
  CHECK(cylinder.axis == Point(0, -5, 0));
  CHECK(cylinder.radius == 1);
  CHECK(cylinder.height == 14);
}

TEST_CASE("A shape whose points need square roots cannot be asked in fractions, a sum of such neither") {
  const auto ask = [](const AnyShape& shape) {
    Asked<gjk::Fraction> asked(converted<gjk::Fraction>(shape, Cast<gjk::Fraction>{}));
  };
  CHECK_NOTHROW(ask(Sum{{Points{{1, 2, 3}}, Points{{4, 5, 6}}}}));
  CHECK_THROWS_AS(ask(can()), CannotBeAsked);
  CHECK_THROWS_AS(ask(Sum{{Points{{1, 2, 3}}, Ball{{0, 0, 0}, 1}}}), CannotBeAsked);
}

}  // namespace any_shape_test
