/// Support functions: Eqs. 5-8.
#include "core/shapes.hpp"

#include <algorithm>
#include <limits>

#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"

namespace gjk::test {
namespace shapes_test {

using V = Vec3<double>;

/// Small whole numbers: many points are equally far, and every sum is exact.
TEMPLATE_TEST_CASE("Eq. 5: of many points the first of the farthest is the answer", "[shapes]", float, double,
                   long double, Rational) {
  using S = TestType;
  kit::Dice dice(7474);
  const auto coordinate = [&] { return S(dice.between(-4, 4)); };
  const auto any_vector = [&] { return Vec3<S>(coordinate(), coordinate(), coordinate()); };
  for (int count = 1; count <= 280; ++count) {
    std::vector<Vec3<S>> list(static_cast<std::size_t>(count / 4 + 1));
    std::generate(list.begin(), list.end(), any_vector);
    const Vec3<S> d = any_vector() + (count % 2 ? Vec3<S>(S(9), S(0), S(0)) : Vec3<S>(S(0), S(0), S(-5)));
    const auto nearer = [&](const Vec3<S>& p, const Vec3<S>& q) { return p.dot(d) < q.dot(d); };
    const SupportPoint<S> found = PointSet<S>(list).support(d);
    INFO(count << " points");
    REQUIRE(found.index == std::max_element(list.begin(), list.end(), nearer) - list.begin());
    REQUIRE(found.point == list[static_cast<std::size_t>(*found.index)]);
  }
}

TEMPLATE_TEST_CASE("Eq. 5: many points are added up as few are, to the last bit", "[shapes]", float, double) {
  using S = TestType;
  kit::Dice dice(7474);
  const auto coordinate = [&] { return static_cast<S>(dice.between(-1.0, 1.0)); };
  const auto any_vector = [&] { return Vec3<S>(coordinate(), coordinate(), coordinate()); };
  for (int i = 0; i < 1000; ++i) {
    const Vec3<S> d = any_vector(), p = any_vector();
    // Points in the plane p·d: which of them comes first is decided by rounding alone.
    std::vector<Vec3<S>> list(20);
    for (Vec3<S>& q : list) q = p + any_vector().cross(d);
    const auto reach = [&](const Vec3<S>& q) { return q.x() * d.x() + (q.y() * d.y() + q.z() * d.z()); };
    const auto nearer = [&](const Vec3<S>& q, const Vec3<S>& r) { return reach(q) < reach(r); };
    REQUIRE(PointSet<S>(list).support(d).index == std::max_element(list.begin(), list.end(), nearer) - list.begin());
  }
}

TEMPLATE_TEST_CASE("Eq. 5: where products overflow or are no numbers, the answer is still one of the points",
                   "[shapes]", float, double) {
  using S = TestType;
  const S most = std::numeric_limits<S>::max();
  for (const std::size_t count : {3U, 16U, 40U})
    for (const S sign : {S(1), S(-1)}) {
      const PointSet<S> points(std::vector<Vec3<S>>(count, Vec3<S>(sign * most, -most, most)));
      REQUIRE(points.support(Vec3<S>(most, most, 1)).index.value() < static_cast<int>(count));
    }
}

/// Points as they come, on a ball, on a disc, in small whole numbers, on a cube, in a line.
template <class S>
std::vector<Vec3<S>> cloud(int kind, std::size_t count, Dice& dice) {
  std::vector<Vec3<S>> all(count);
  for (Vec3<S>& p : all) {
    for (S& x : p) x = static_cast<S>(dice.between(-1.0, 1.0));
    if (kind == 1 || kind == 2) p.stableNormalize();
    if (kind == 2) p.z() = S(0.1) * p.x();
    if (kind == 3) p = (4 * p).array().round().matrix();
    if (kind == 4) p /= p.cwiseAbs().maxCoeff();
    if (kind == 5) p.y() = p.z() = S(1) / 3;
  }
  return all;
}

TEMPLATE_TEST_CASE("A prepared point set answers as it did, to the last bit, equals and extremes included", "[shapes]",
                   float, double, long double) {
  using S = TestType;
  Dice dice(7474);
  for (const std::size_t count : {1U, 15U, 16U, 100U, 1500U})
    for (int kind = 0; kind < 6; ++kind) {
      const PointSet<S> points(cloud<S>(kind, count, dice));
      PointSet<S> prepared = points;
      prepared.prepare();
      for (int i = 0; i < 400; ++i) {
        Vec3<S> d = cloud<S>(i % 6, 1, dice)[0];
        if (d.isZero()) d = Vec3<S>(0, -1, 0);
        if (i % 3 == 0) d *= std::scalbn(S(1), dice.between(-1, 1) * (std::numeric_limits<S>::max_exponent - 4));
        if (i % 5 == 0) d = points.points()[0].cross(d) + Vec3<S>(0, 0, S(1e-30));
        INFO("kind " << kind << ", " << count << " points, d = " << d.transpose());
        REQUIRE(prepared.support(d) == points.support(d));
      }
    }
}

TEST_CASE("A prepared point set answers as it did also where its products lose what is below the least number",
          "[shapes]") {
  Dice dice(32);
  for (int set = 0; set < 20; ++set) {
    std::vector<Vec3<float>> list;
    for (int i = 0; i < 200; ++i) {
      Vec3<double> p(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      p *= 10 / p.norm();
      list.push_back(std::numeric_limits<float>::denorm_min() * p.array().round().matrix().cast<float>());
    }
    const PointSet<float> points(list);
    PointSet<float> prepared = points;
    prepared.prepare();
    for (int i = 0; i < 500; ++i) {
      const Vec3<double> d(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      const Vec3<float> along = d.cast<float>() * 1e36f;
      REQUIRE(prepared.support(along) == points.support(along));
    }
  }
}

TEST_CASE("A prepared point set looks at few points, but where most are as far", "[shapes]") {
  Dice dice(7474);
  const auto looked_at = [&](int kind, const V& d) {
    const PointSet<double> points(cloud<double>(kind, 10'000, dice));
    return detail::DirectionCells<double>(points.points(), points.extent()).along(d).size();
  };
  for (const int kind : {0, 1, 3}) {
    const std::size_t few = looked_at(kind, V(1, -2, 3));
    CHECK(few > 0);
    CHECK(few <= 12);
  }
  CHECK(looked_at(5, V(0, 1, 2)) == 0);  // none is left out
}

TEMPLATE_TEST_CASE("The mean of a point set is off by at most nur, and not finite where the sum overflows", "[shapes]",
                   float, double, long double) {
  using S = TestType;
  Dice dice(7474);
  bool is_any_off = false;
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec3<S>> list(static_cast<std::size_t>(dice.between(1, 40)));
    for (Vec3<S>& p : list)
      for (S& x : p) x = static_cast<S>(dice.between(-1.0, 1.0)) * std::scalbn(S(1), dice.between(-30, 30));
    const PointSet<S> points(list);
    for (int axis = 0; axis < 3; ++axis) {
      Rational sum = 0;
      for (const Vec3<S>& p : list) sum += Rational(p[axis]);
      const Rational n(list.size()), off = abs(Rational(points.mean()[axis]) - sum / n);
      is_any_off |= off > 0;
      REQUIRE(off <= n * Rational(std::numeric_limits<S>::epsilon() / 2) * Rational(points.extent()[axis]));
    }
  }
  REQUIRE(is_any_off);
  const S most = std::numeric_limits<S>::max();
  REQUIRE_FALSE(std::isfinite(PointSet<S>({Vec3<S>(most, 0, 0), Vec3<S>(most, 0, 0)}).mean().x()));
}

TEST_CASE(
    "Shapes refuse what is none: no points, lengths that are negative or not finite, an axis that is zero or not "
    "finite",
    "[shapes]") {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const V center(0, 0, 0), up(0, 0, 1);
  REQUIRE_THROWS_AS(PointSet<double>({}), std::invalid_argument);
  for (const double length : {-1.0, infinity, nan}) {
    REQUIRE_THROWS_AS(Sphere<double>(center, length), std::invalid_argument);
    REQUIRE_THROWS_AS(Cylinder<double>(center, up, length, 1), std::invalid_argument);
    REQUIRE_THROWS_AS(Cylinder<double>(center, up, 1, length), std::invalid_argument);
  }
  for (const V& axis : {V(0, 0, 0), V(infinity, 0, 0), V(0, 0, -infinity), V(nan, 0, 0), V(1, 0, nan), V(nan, 1, 0)})
    REQUIRE_THROWS_AS(Cylinder<double>(center, axis, 1, 1), std::invalid_argument);
  REQUIRE_NOTHROW(Cylinder<double>(center, up, 1e-3, 1e3));
}

TEST_CASE("A sphere without radius is a point, a cylinder without height a disc, one without radius a segment",
          "[shapes]") {
  const V center(1, 2, 3), up(0, 0, 2), d(3, 0, 4);
  CHECK(Sphere<double>(center, 0).support(d).point == center);
  CHECK(Cylinder<double>(center, up, 5, 0).support(d).point == V(6, 2, 3));
  CHECK(Cylinder<double>(center, up, 0, 6).support(d).point == V(1, 2, 6));
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
  REQUIRE(asked<double>(UnitCube{}, Sphere<double>(V(2, 0.5, 0.5), 1.25)).status == Status::intersecting);
  REQUIRE(asked<double>(UnitCube{}, Sphere<double>(V(2, 0.5, 0.5), 0.75)).status == Status::separated);
  REQUIRE(collision<double>(UnitCube{}, UnitCube{}).status == Status::intersecting);
}

// -- Cylinder ---------------------------------------------------------------------------------------------------------

/// Integer axes, so that their multiples are exact.
const Points axes{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, -2, 3}, {-3, 4, 0}, {7, 7, 7}, {-11, 2, 10}};

/// Where a point lies in the cylinder's own terms.
template <class S>
struct InCylinder {
  InCylinder(const Cylinder<S>& cylinder, const Vec3<S>& p) {
    const Vec3<S> from_center = p - cylinder.center(), up = cylinder.to_cap().normalized();
    along = from_center.dot(up);
    from_axis = (from_center - along * up).norm();
  }
  S along, from_axis;
};

template <class S>
std::vector<Vec3<S>> points_all_around(std::uint64_t seed, int count) {
  Dice dice(seed);
  std::vector<Vec3<S>> directions;
  while (static_cast<int>(directions.size()) < count) {
    const Vec3<S> d(S(dice.between(-1., 1.)), S(dice.between(-1., 1.)), S(dice.between(-1., 1.)));
    if (d.norm() > S(0.1)) directions.push_back(d);
  }
  return directions;
}

TEMPLATE_TEST_CASE("A cylinder answers with the rim point of the cap on the side of the direction", "[shapes]", float,
                   double, long double) {
  using S = TestType;
  const Cylinder<S> upright(Vec3<S>(1, 2, 3), Vec3<S>(0, 0, 5), S(2), S(6));
  REQUIRE(upright.support(Vec3<S>(1, 0, 1)).point == Vec3<S>(3, 2, 6));
  REQUIRE(upright.support(Vec3<S>(-7, 0, 1)).point == Vec3<S>(-1, 2, 6));
  REQUIRE(upright.support(Vec3<S>(0, 1, -4)).point == Vec3<S>(1, 4, 0));
  REQUIRE(upright.support(Vec3<S>(0, -1, -4)).point == Vec3<S>(1, 0, 0));
  const S error = (upright.support(Vec3<S>(3, 4, -1)).point - Vec3<S>(S(11) / S(5), S(18) / S(5), 0)).norm();
  REQUIRE(error <= S(8) * std::numeric_limits<S>::epsilon());
  REQUIRE_FALSE(upright.support(Vec3<S>(1, 0, 1)).index.has_value());
}

TEMPLATE_TEST_CASE("A cylinder answers with the middle of a cap, exactly, for every multiple of its axis", "[shapes]",
                   float, double) {
  using S = TestType;
  for (const Point& axis : axes) {
    const Cylinder<S> cylinder(Vec3<S>(1, 2, 3), vec<S>(axis), S(2), S(3));
    const Vec3<S> top = cylinder.center() + cylinder.to_cap(), bottom = cylinder.center() - cylinder.to_cap();
    REQUIRE(InCylinder<S>(cylinder, top).along == Approx(1.5));
    const S huge = std::numeric_limits<S>::max() / 64, tiny = std::numeric_limits<S>::denorm_min();
    for (const S k : {S(1), S(3), S(1001), S(0.125), std::exp2(std::floor(std::log2(huge))), tiny}) {
      INFO("axis " << axis[0] << " " << axis[1] << " " << axis[2] << ", k " << k);
      REQUIRE(cylinder.support(Vec3<S>(vec<S>(axis) * k)).point == top);
      REQUIRE(cylinder.support(Vec3<S>(vec<S>(axis) * -k)).point == bottom);
    }
  }
}

TEST_CASE("A cylinder asked perpendicular to its axis answers on the cap along the axis", "[shapes]") {
  const Cylinder<double> cylinder(V(1, 2, 3), V(1, -2, 3), 2.0, 3.0);
  for (const V& d : {V(2, 1, 0), V(-2, -1, 0), V(8, 4, 0)}) {
    const InCylinder<double> at(cylinder, cylinder.support(d).point);
    REQUIRE(at.along == Approx(1.5));
    REQUIRE(at.from_axis == Approx(2));
  }
  const Cylinder<double> turned_over(V(1, 2, 3), V(0, 0, -1), 2.0, 4.0);
  REQUIRE(turned_over.support({0, 1, 0}).point == V(1, 4, 1));
}

TEMPLATE_TEST_CASE("P1: a direction that rounding has put beside the axis still leads to a point of the cylinder",
                   "[shapes]", float, double) {
  using S = TestType;
  const S epsilon = std::numeric_limits<S>::epsilon();
  Dice dice(22);
  for (int i = 0; i < 3000; ++i) {
    const Vec3<S> axis = points_all_around<S>(static_cast<std::uint64_t>(i), 1)[0];
    const Cylinder<S> cylinder(Vec3<S>(0, 0, 0), axis, S(5), S(2));
    Vec3<S> d = axis;
    for (int k = 0; k < 3; ++k) d[k] *= S(1) + S(dice.between(-3, 3)) * epsilon;
    const Vec3<S> found = cylinder.support(d).point;
    const InCylinder<S> at(cylinder, found);
    INFO("number " << i);
    REQUIRE(std::abs(at.along - S(1)) <= 64 * epsilon);
    REQUIRE(at.from_axis <= S(5) * (1 + 64 * epsilon));
    REQUIRE(found.dot(d) >= axis.norm() * (1 - 64 * epsilon));
  }
}

TEST_CASE("Neither the length of the axis nor that of the direction changes a cylinder's answer, from 1e-300 to 1e300",
          "[shapes]") {
  const V axis(1, -2, 3), d(2, 3, -1), center(1, 2, 3);
  const V expected = Cylinder<double>(center, axis, 2, 3).support(d).point;
  for (const double length : {5e-320, 1e-300, 1e-200, 1e-3, 1e3, 1e200, 1e300}) {
    const double roughness = length < 1e-307 ? 1e-3 : 1e-14;  // subnormal numbers have few digits
    INFO("length " << length);
    REQUIRE((Cylinder<double>(center, axis * length, 2, 3).support(d).point - expected).norm() <= roughness);
    REQUIRE((Cylinder<double>(center, axis, 2, 3).support(d * length).point - expected).norm() <= roughness);
  }
  const Cylinder<double> upright(V(0, 0, 0), V(0, 0, 1), 2, 2);
  REQUIRE(upright.support({1e-200, 0, 1}).point == V(2, 0, 1));
  REQUIRE(upright.support({0, -1e200, 1e-200}).point == V(0, -2, 1));
  REQUIRE(upright.support({std::numeric_limits<double>::denorm_min(), 0, 1e308}).point == V(0, 0, 1));
}

// -- Poses ------------------------------------------------------------------------------------------------------------

/// A third of a full turn about (1,-2,3), more or less.
template <class S>
Pose<S> some_pose() {
  return {Eigen::AngleAxis<S>(S(2), Vec3<S>(1, -2, 3).normalized()).toRotationMatrix(), Vec3<S>(5, -7, S(0.5))};
}

TEMPLATE_TEST_CASE("A posed point set answers as the points do where the pose puts them, and keeps their numbers",
                   "[shapes]", float, double) {
  using S = TestType;
  const auto points = point_set<S>({{0, 0, 0}, {3, 1, 0}, {-1, 4, 2}, {1, -1, -5}, {-4, -2, 3}});
  const Pose<S> pose = some_pose<S>();
  std::vector<Vec3<S>> placed;
  for (const Vec3<S>& p : points.points()) placed.push_back(pose(p));
  const Posed<S, PointSet<S>> posed(points, pose);
  for (const Vec3<S>& d : points_all_around<S>(24, 200)) {
    REQUIRE(posed.support(d).index == PointSet<S>(placed).support(d).index);
    REQUIRE(posed.support(d).point == placed[static_cast<std::size_t>(*posed.support(d).index)]);
  }
}

TEST_CASE("P1: a pose turns the largest and the smallest directions without losing them", "[shapes]") {
  const auto pose = some_pose<double>();
  const Posed<double, Sphere<double>> ball(Sphere<double>(V(0, 0, 0), 1), pose);
  const double largest = std::numeric_limits<double>::max(), smallest = std::numeric_limits<double>::denorm_min();
  for (const double length : {largest, 1e200, 1e-200, smallest})
    for (const V& d : {V(1, 1, 1), V(1, 1, -1), V(1, 0, 0), V(0, -1, 0), V(0, 0, 1), V(-1, 1, 1)}) {
      const V reach = ball.support(d * length).point - pose.translation;
      REQUIRE((reach - d.normalized()).norm() <= 1e-14);
    }
}

TEST_CASE("No pose changes nothing, not even which of equally far points is the answer", "[shapes]") {
  const auto points = point_set<double>({{1, 3, 0}, {3, 1, 0}, {2, 2, 0}, {-3, 0, 7}});
  const Posed<double, PointSet<double>> posed(points, {});
  for (const V& d : {V(1, 1, 0), V(0.1, 0.1, 0), V(7e11, 7e11, 1e-3), V(-1, 2, 0.3)})
    REQUIRE(posed.support(d).index == points.support(d).index);
}

}  // namespace shapes_test
}  // namespace gjk::test
