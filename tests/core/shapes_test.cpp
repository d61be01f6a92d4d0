/// Support functions: Eqs. 5-8.
#include "core/shapes.hpp"

#include <limits>

#include "tests/catch.hpp"
#include "tests/core/support.hpp"

namespace gjk::test {
namespace {

using V = Vec3<double>;

TEMPLATE_TEST_CASE("Eq. 5: a point set answers with the point farthest in the direction, and with its index",
                   "[shapes]", float, double, long double, Rational) {
  using S = TestType;
  const auto points = point_set<S>({{0, 0, 0}, {3, 1, 0}, {-1, 4, 2}, {1, -1, -5}});
  const auto farthest = [&](const Point& d) { return *points.support(vec<S>(d)).index; };
  REQUIRE(farthest({1, 0, 0}) == 1);
  REQUIRE(farthest({0, 1, 0}) == 2);
  REQUIRE(farthest({0, 0, -1}) == 3);
  REQUIRE(farthest({-1, -1, 1}) == 0);
  REQUIRE(points.support(vec<S>({0, 0, -1})).point == vec<S>({1, -1, -5}));
}

TEST_CASE("Eq. 5: among equally far points the first in the list is the answer", "[shapes]") {
  const auto points = point_set<double>({{-1, 0, 0}, {2, 5, 0}, {2, -5, 0}, {2, 5, 0}});
  REQUIRE(points.support({1, 0, 0}).index == 1);
  REQUIRE(points.support({0, 1, 0}).index == 1);
  REQUIRE(points.support({0, 0, 1}).index == 0);
}

TEST_CASE("Eq. 5: the length of the direction does not matter, from 1e-200 to 1e200", "[shapes]") {
  const auto points = point_set<double>({{0, 0, 0}, {3, 1, 0}, {-1, 4, 2}});
  for (const double length : {1e-200, 1e-3, 1.0, 1e3, 1e200}) REQUIRE(points.support(V(-1, 2, 1) * length).index == 2);
}

TEST_CASE("A point set needs at least one point", "[shapes]") {
  REQUIRE_THROWS_AS(PointSet<double>({}), std::invalid_argument);
}

TEMPLATE_TEST_CASE("Eq. 6: a sphere answers with the end of its radius along the direction", "[shapes]", float, double,
                   long double) {
  using S = TestType;
  const Sphere<S> sphere(Vec3<S>(1, 2, 3), S(2));
  REQUIRE(sphere.support(Vec3<S>(1, 0, 0)).point == Vec3<S>(3, 2, 3));
  REQUIRE(sphere.support(Vec3<S>(0, -7, 0)).point == Vec3<S>(1, 0, 3));
  const Vec3<S> reach = sphere.support(Vec3<S>(1, -2, 2)).point - sphere.center();
  const S error = (reach - Vec3<S>(2, -4, 4) / S(3)).norm();
  REQUIRE(error <= S(4) * std::numeric_limits<S>::epsilon());
  REQUIRE_FALSE(sphere.support(Vec3<S>(1, 0, 0)).index.has_value());
}

TEST_CASE("Eq. 6: directions whose squared length under- or overflows reach the surface of a sphere too", "[shapes]") {
  const Sphere<double> sphere(V(0, 0, 0), 3.0);
  const V expected = sphere.support(V(1, -2, 3)).point;
  for (const double length : {1e-300, 1e-200, 1e200, 1e300}) {
    const V reach = sphere.support(V(1, -2, 3) * length).point;
    REQUIRE(reach.norm() == Approx(3.0));
    REQUIRE((reach - expected).norm() <= 1e-14);
  }
  REQUIRE(sphere.support(V(std::numeric_limits<double>::denorm_min(), 0, 0)).point == V(3, 0, 0));
}

TEST_CASE("A sphere needs a positive, finite radius", "[shapes]") {
  for (const double radius :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    REQUIRE_THROWS_AS(Sphere<double>(V(0, 0, 0), radius), std::invalid_argument);
}

TEST_CASE("Eq. 7: the support of a sum is the sum of the supports", "[shapes]") {
  const auto triangle = point_set<double>({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  const MinkowskiSum<double, PointSet<double>, Sphere<double>> rounded(triangle, Sphere<double>(V(0, 0, 5), 1));
  REQUIRE(rounded.support({1, 0, 0}).point == V(5, 0, 5));
  REQUIRE(rounded.support({0, 1, 0}).point == V(0, 5, 5));
  REQUIRE(rounded.support({0, 0, -1}).point == V(0, 0, 4));
}

TEST_CASE("Eq. 8: the support of a difference is support(A, d) - support(B, -d), and remembers both points",
          "[shapes]") {
  const auto a = point_set<double>({{0, 0, 0}, {4, 1, 0}, {0, 4, 0}});
  const auto b = point_set<double>({{7, 0, 0}, {10, 2, 0}, {9, -5, 0}});
  const MinkowskiDifference<double, PointSet<double>, PointSet<double>> difference(a, b);
  const auto vertex = difference.vertex({1, 0, 0});
  REQUIRE(vertex.a.index == 1);
  REQUIRE(vertex.b.index == 0);
  REQUIRE(vertex.w == V(-3, 1, 0));
  REQUIRE(vertex.w == V(vertex.a.point - vertex.b.point));
  REQUIRE(difference.support({1, 0, 0}).point == vertex.w);
}

TEST_CASE("Eq. 8: Section 2.4's triangles reach x = -1 and x = 1, and their difference x = -2", "[shapes]") {
  const auto c = point_set<double>({{-1, 0, 0}, {-3, 1, 0}, {-3, -1, 0}});
  const auto d = point_set<double>({{1, 0, 0}, {3, 1, 0}, {3, -1, 0}});
  const V plus_x(1, 0, 0);
  REQUIRE(c.support(plus_x).point.x() == -1);
  REQUIRE(d.support(-plus_x).point.x() == 1);
  REQUIRE(MinkowskiDifference<double, PointSet<double>, PointSet<double>>(c, d).support(plus_x).point.x() == -2);
}

/// A shape as a user may write it: no index, no base class.
struct UnitCube {
  V support(const V& d) const {
    return d.unaryExpr([](double x) { return x < 0 ? 0.0 : 1.0; });
  }
};

TEST_CASE("Anything with a support function is a shape, also one that returns a plain vector", "[shapes]") {
  STATIC_REQUIRE(Shape<UnitCube, double>);
  STATIC_REQUIRE(Shape<PointSet<Rational>, Rational>);
  STATIC_REQUIRE(Shape<MinkowskiSum<double, UnitCube, Sphere<double>>, double>);
  STATIC_REQUIRE_FALSE(Shape<V, double>);
  REQUIRE(collision<double>(UnitCube{}, Sphere<double>(V(2, 0.5, 0.5), 1.25)).status == Status::intersecting);
  REQUIRE(collision<double>(UnitCube{}, Sphere<double>(V(2, 0.5, 0.5), 0.75)).status == Status::separated);
  REQUIRE(collision<double>(UnitCube{}, UnitCube{}).status == Status::intersecting);
}

TEST_CASE("A sphere is a ball grown from a point: the sum of two spheres is the sphere of both radii", "[shapes]") {
  const MinkowskiSum<double, Sphere<double>, Sphere<double>> sum(Sphere<double>(V(1, 0, 0), 1),
                                                                 Sphere<double>(V(0, 2, 0), 2));
  const Sphere<double> both(V(1, 2, 0), 3);
  for (const V& d : {V(1, 0, 0), V(1, -2, 3), V(-4, 1, 1)})
    REQUIRE((sum.support(d).point - both.support(d).point).norm() <= 1e-14);
}

}  // namespace
}  // namespace gjk::test
