// Shapes told by their fields: converted, measured, named and asked without knowing which they are.

#include "walkthroughs/model/any_shape.hpp"

#include <random>
#include <set>

#include "core/gjk.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/model/exact_number.hpp"
#include "walkthroughs/model/scene.hpp"

using namespace walkthroughs;

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Point point() { return {number(), number(), number()}; }
  Points points(int count) {
    Points list;
    for (int i = 0; i < count; ++i) list.push_back(point());
    return list;
  }
  AnyShape shape(int sums = 2) {
    switch (std::uniform_int_distribution<int>(0, sums > 0 ? 3 : 2)(random_)) {
      case 0: return points(5);
      case 1: return Ball{point(), std::abs(number())};
      case 2: return Cylinder{point(), point(), std::abs(number()), std::abs(number())};
      default: return Sum{{shape(sums - 1), shape(sums - 1)}};
    }
  }

 private:
  std::mt19937 random_;
};

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
  const auto& sum = std::get<Sum>(shape);
  return reach(sum.summands.at(0), d) + reach(sum.summands.at(1), d);
}

Cylinder can() { return {{1, -2, 3}, {0, 5, 0}, 0.5, 7}; }

}  // namespace

TEST_CASE("Every shape has a key and a name of its own") {
  std::set<std::string> keys, kinds;
  for_each_kind([&]<class Shape>(std::type_identity<Shape>) {
    keys.emplace(ShapeRow<Shape>::key);
    kinds.emplace(ShapeRow<Shape>::kind);
  });
  CHECK(keys == std::set<std::string>{"points", "sphere", "cylinder", "sum"});
  CHECK(kinds.size() == keys.size());
}

TEST_CASE("Support of a sum (Eq. 7): the farthest point reaches as far as those of the two together") {
  Dice dice(3);
  for (int i = 0; i < 500; ++i) {
    const AnyShape shape = Sum{{dice.shape(), dice.shape()}};
    const Point d = dice.point();
    const gjk::SupportPoint<double> found = Asked<double>(shape).support(d);
    CHECK(found.point.dot(d) == Approx(reach(shape, d)).margin(1e-12));
    CHECK(!found.index);
  }
}

TEST_CASE("Support of a sum of point sets is the farthest of all sums, by trying them all") {
  Dice dice(4);
  for (int i = 0; i < 200; ++i) {
    const Points a = dice.points(6), b = dice.points(4);
    const Point d = dice.point();
    CHECK(Asked<double>(Sum{{a, b}}).support(d).point == Asked<double>(all_sums(a, b)).support(d).point);
  }
}

TEST_CASE("GJK answers for a sum of point sets as for the set of all sums: status, iterations, simplex") {
  Dice dice(5);
  const auto check = [&]<class S>(S) {
    for (int i = 0; i < 100; ++i) {
      Points quarters[3];  // doubles hold all that is computed from these, so that both ways find the same numbers
      for (Points& points : quarters) {
        points = dice.points(4);
        for (Point& p : points) p = (p * 64).array().round() / 4;
      }
      const auto in = [](const AnyShape& shape) { return Asked<S>(converted<S>(shape, Cast<S>{})); };
      const Asked<S> sum = in(Sum{{quarters[0], quarters[1]}}), all = in(all_sums(quarters[0], quarters[1]));
      const Asked<S> other = in(quarters[2]);
      const auto found = gjk::collision<S>(sum, other, gjk::Options<S>{}),
                 expected = gjk::collision<S>(all, other, gjk::Options<S>{});
      CHECK(found.status == expected.status);
      CHECK(found.iterations == expected.iterations);
      REQUIRE(found.simplex.size() == expected.simplex.size());
      for (int k = 0; k < found.simplex.size(); ++k) CHECK(found.simplex[k].w == expected.simplex[k].w);
    }
  };
  check(double{});
  check(Exact{});
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

TEST_CASE("The largest number of a shape is that of all its fields, also within sums") {
  CHECK(largest_number(AnyShape(Points{{1, -9, 3}, {4, 5, 6}})) == 9);
  CHECK(largest_number(AnyShape(Ball{{1, 2, 3}, 4})) == 4);
  CHECK(largest_number(AnyShape(can())) == 7);
  CHECK(largest_number(AnyShape(Sum{{can(), Ball{{0, -20, 0}, 1}}})) == 20);
}

TEST_CASE("The middle of a shape lies inside, of a sum it is the sum of the middles") {
  Dice dice(6);
  for (int i = 0; i < 200; ++i) {
    const AnyShape shape = dice.shape();
    const Point d = dice.point();
    CHECK(middle(shape).dot(d) <= reach(shape, d));
  }
  CHECK(middle(AnyShape(Sum{{Points{{0, 0, 0}, {2, 4, 6}}, can()}})) == Point(2, 0, 6));
}

TEST_CASE("A shape whose points need square roots cannot be asked in fractions, a sum of such neither") {
  const auto ask = [](const AnyShape& shape) { Asked<Exact> asked(converted<Exact>(shape, Cast<Exact>{})); };
  CHECK_NOTHROW(ask(Sum{{Points{{1, 2, 3}}, Points{{4, 5, 6}}}}));
  CHECK_THROWS_AS(ask(can()), CannotBeAsked);
  CHECK_THROWS_AS(ask(Sum{{Points{{1, 2, 3}}, Ball{{0, 0, 0}, 1}}}), CannotBeAsked);
}

TEST_CASE("A shape says what it is, in the plane and in space") {
  const AnyShape triangle = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, ball = Ball{{0, 0, 0}, 1};
  CHECK(kind_of(ball, Dimension::space) == "sphere");
  CHECK(kind_of(Sum{{triangle, ball}}, Dimension::plane) == "sum of a point set and a disc");
  CHECK(described(Sum{{triangle, Sum{{ball, can()}}}}, Dimension::space) ==
        "sum of 3 points and a sum of a sphere and a cylinder");
  CHECK(described(Points{{0, 0, 0}}, Dimension::space) == "1 point");
}
