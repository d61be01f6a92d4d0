/// certified_shapes(): shapes whose points are known to ε. Never wrong, and decided but where they all but touch.
#include <map>
#include <stdexcept>

#include "core/certified/shapes.hpp"
#include "tests/core/any_doubtful.hpp"
#include "tests/core/certified_support.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace certified_shapes_test {
namespace {

using V = Vec3<double>;
using Any = AnyDoubtful<double>;
constexpr auto apart = Status::separated, together = Status::intersecting, undecided = Status::undecided;

/// A cylinder whose points are each said to be off by `error`; and are too short by that, along whatever direction.
struct Short {
  Cylinder<double> can;
  double error;
};
SupportError support_error(const Short& s) {
  return {gjk::support_error(s.can).size + s.error, gjk::support_error(s.can).error + s.error};
}
V near_support(const Short& s, const V& d) { return gjk::near_support(s.can, d) - s.error * d.normalized(); }

/// Points that are each said to be off by `error`; and are, to that length, in a direction of its own each time.
struct Blurred {
  PointSet<double> points;
  double error;
  bool is_off = false;
  mutable Dice dice{7474};
};
SupportError support_error(const Blurred& blurred) {
  return {gjk::support_error(blurred.points).size + blurred.error, blurred.error};
}
V near_support(const Blurred& blurred, const V& d) {
  if (!d.allFinite() || d == V::Zero())
    throw std::logic_error("a support function is asked along what is no direction");
  const V p = blurred.points.support(d).point;
  if (!blurred.is_off) return p;
  auto& dice = blurred.dice;
  return p + V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)).normalized() * blurred.error;
}

/// Returns: what certified_shapes() says, compiled once.
ShapesResult said_of(const Any& a, const Any& b) { return certified_shapes(a, b); }

ShapesResult beside_cube(double error, const V& center) {
  return said_of(Blurred{point_set<double>(cube), error}, Blurred{PointSet<double>({center}), 0});
}

}  // namespace

// -- C7, C8 -----------------------------------------------------------------------------------------------------------

namespace {

/// A cube that ends at x = 0, its points known to a quarter, and a point beside or in it.
struct SideOfCube {
  explicit SideOfCube(double x) : point{PointSet<double>({V(x, 0, 0)}), 0} {}

  Status status() const { return said_of(box, point).status; }
  /// Returns: ε, a millionth greater: what it must be deeper or farther away than.
  double needed() const {
    const Any any_box(box), any_point(point);
    const detail::BoundedDifference<double, Any, Any> difference(any_box, any_point);
    return difference.unscaled(difference.error() * (1 + 0x1p-20));
  }

  Blurred box{PointSet<double>({V(-2, -1, -1), V(0, -1, -1), V(-2, 1, -1), V(0, 1, -1), V(-2, -1, 1), V(0, -1, 1),
                                V(-2, 1, 1), V(0, 1, 1)}),
              0.25},
      point;
};

}  // namespace

TEST_CASE("C7, C8: what is ε and two millionths far or deep is undecided, the next number is not", "[certified]") {
  double needed = 0.25;  // it depends on where the point is, which is so far away
  for (int i = 0; i < 9; ++i) needed = SideOfCube(needed).needed();
  REQUIRE(SideOfCube(needed).needed() == needed);
  const double epsilon = 0.25 + 9 * 0x1p-53 * (2 + 1 + 1 + 0.25 + needed);
  CHECK(needed == Approx(epsilon * (1 + 0x1p-19)).epsilon(0x1p-24));
  for (const double away : {needed, -needed}) {
    INFO(away);
    CHECK(SideOfCube(away).status() == undecided);
    CHECK(SideOfCube(std::nextafter(away, 2 * away)).status() == (away > 0 ? apart : together));
  }
}

TEST_CASE("C7: of points that are known exactly a gap of what is rounded separates nothing, a step more does",
          "[certified]") {
  // The cube and a point reach 3 and 1 from the origin: 9u(3 + 1) is 18 steps of the doubles above 1.
  for (const V& side : {V(1, 0, 0), V(0, -1, 0), V(0, 0, 1)}) {
    REQUIRE(beside_cube(0, side * (1 + 18 * 0x1p-52)).status == undecided);
    REQUIRE(beside_cube(0, side * (1 + 19 * 0x1p-52)).status == apart);
  }
}

TEST_CASE("C7: the direction separates by more than what is in doubt", "[certified]") {
  const ShapesResult result = beside_cube(0.25, V(2, 3, -2));
  REQUIRE(result.status == apart);
  REQUIRE(result.gap == 0);
  for (const Point& corner_of_cube : cube) {
    const V p = vec<double>(corner_of_cube);
    REQUIRE(p.dot(result.direction) < V(2, 3, -2).dot(result.direction) - 0.25 * result.direction.norm());
  }
}

TEST_CASE("C7, C8: where points are off by as much as they may be, no answer is wrong", "[certified]") {
  Dice dice(11);
  std::map<Status, int> seen;
  for (int i = 0; i < 3000; ++i) {
    const PairOfHulls hulls = random_pair(dice);
    const auto a = point_set<double>(hulls.a), b = point_set<double>(hulls.b);
    const double error = std::ldexp(1.0, -dice.between(1, 20));
    const ShapesResult result =
        said_of(Blurred{a, error, true, Dice(dice.between(0, 1000000))}, Blurred{b, error, true, Dice(i)});
    INFO("pair " << i);
    ++seen[result.status];
    if (result.status != undecided) REQUIRE(result.status == proven(Pair<double>{a, b}).status);
  }
  for (const Status each : {apart, together, undecided}) REQUIRE(seen[each] > 100);
}

TEST_CASE(
    "C8: tetrahedra of small whole numbers go around the origin where they hold it inside, and with a corner more, too",
    "[certified]") {
  Dice dice(7474);
  int around = 0, beside = 0;
  for (int i = 0; i < 1000; ++i) {
    std::array<V, 4> w;
    for (V& each : w)
      for (double& x : each) x = dice.between(-3, 3);
    const auto det = [](const V& x, const V& y, const V& z) { return x.cross(y).dot(z); };  // exact
    const double of[] = {det(w[1], w[2], w[3]), -det(w[0], w[2], w[3]), det(w[0], w[1], w[3]), -det(w[0], w[1], w[2])};
    if (std::ranges::count(of, 0.0) > 0 || of[0] + of[1] + of[2] + of[3] == 0) continue;
    const bool is_inside = std::ranges::all_of(of, [&](double x) { return x * of[0] > 0; });
    CAPTURE(i);
    CHECK(detail::Surface(w).goes_around_origin() == is_inside);
    ++(is_inside ? around : beside);
  }
  CHECK(around > 50);
  CHECK(beside > 300);
  const auto moved_by = [](const V& by) {
    return detail::Surface({V(1, 1, 1) + by, V(1, -1, -1) + by, V(-1, 1, -1) + by, V(-1, -1, 1) + by});
  };
  for (const V& by : {V(2, 0, 0), V(5, 5, 5), V(-1, -1, -1)})  // the last has a corner there
    CHECK_FALSE(moved_by(by).goes_around_origin());
  detail::Surface more = moved_by(V(0, 0, 0));
  more.add(V(3, 3, -3));
  CHECK(more.goes_around_origin());
  CHECK(more.lowest().height > 0);
}

// -- C9 ---------------------------------------------------------------------------------------------------------------

TEST_CASE("C9: what touches is undecided, with a bound that is true and small", "[certified]") {
  const Cylinder<double> can(V(0, 0, 0), V(0, 0, 1), 1, 2);
  for (const double gap : {0.0, 1e-15, -1e-15}) {
    INFO("gap " << gap);
    for (const ShapesResult& result :
         {said_of(can, Cylinder<double>(V(0.3, 0.2, 2 + gap), V(0, 0, -1), 0.5, 2)),
          said_of(can, Sphere<double>(V(3 + gap, 0, 0), 2)), said_of(Sphere<double>(V(0, 3 + gap, 0), 2), can),
          said_of(can, PointSet<double>({V(0, 0, 1 + gap), V(1, 2, 9)}))}) {
      REQUIRE(result.status == undecided);
      REQUIRE(result.gap >= std::abs(gap));
      REQUIRE(result.gap < 1e-6);
    }
  }
}

namespace {

/// Returns: how far from the origin the nearest of the points is that divide a triangle in so many steps.
double sampled_nearness(const V& a, const V& b, const V& c, int steps) {
  double least = a.norm();
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      least = std::min(least, (a + (b - a) * i / steps + (c - a) * j / steps).norm());
  return least;
}

}  // namespace

TEST_CASE("C9: a surface is as near to the origin as the nearest of its points, inside a triangle or on its rim",
          "[certified]") {
  Dice dice(7474);
  constexpr int steps = 40;
  for (int i = 0; i < 300; ++i) {
    std::array<V, 4> w;
    for (V& each : w)
      for (double& x : each) x = dice.between(-3, 6);
    if ((w[1] - w[0]).cross(w[2] - w[0]).dot(w[3] - w[0]) == 0) continue;
    const double sampled =
        std::min({sampled_nearness(w[0], w[1], w[2], steps), sampled_nearness(w[0], w[1], w[3], steps),
                  sampled_nearness(w[0], w[2], w[3], steps), sampled_nearness(w[1], w[2], w[3], steps)});
    const double nearness = detail::Surface(w).nearness();
    CAPTURE(i, sampled);
    CHECK(nearness <= sampled + 1e-12);
    CHECK(nearness >= sampled - 16.0 / steps);  // no edge is longer, and some sample is that near to any point
  }
}

TEST_CASE("C9: of points known to a quarter the bound holds for what is no nearer and no deeper", "[certified]") {
  for (const double x : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    const ShapesResult result = beside_cube(0.25, V(x, 0.1, -0.2));
    INFO("x " << x << ", gap " << result.gap);
    REQUIRE(result.status == undecided);
    REQUIRE(result.gap >= std::abs(1 - x) + 2 * 0.25);
    REQUIRE(result.gap <= std::abs(1 - x) + 2 * 0.25 + 1e-5);
  }
}

TEST_CASE("C9: a flat difference has a bound, too, and the same point twice has one that is next to nothing",
          "[certified]") {
  const Pose<double> turned{Eigen::AngleAxisd(1, V(1, -2, 3).normalized()).toRotationMatrix(), V(1, 2, 3)};
  const PointSet<double> a({V(0, 0, 0), V(2, 0, 0), V(0, 2, 0)}), b({V(0.5, 0.5, 0), V(3, 3, 0)}),
      far({V(5, 5, 0), V(3, 3, 0)});
  using Turned = Posed<double, PointSet<double>>;
  const ShapesResult flat = said_of(Turned(a, turned), Turned(b, turned));
  REQUIRE(flat.status == undecided);
  REQUIRE(flat.gap < 1e-5);
  REQUIRE(said_of(Turned(a, turned), Turned(far, turned)).status == apart);
  const PointSet<double> point({V(1, 2, 3)});
  const ShapesResult same = said_of(Turned(point, turned), Turned(point, turned));
  REQUIRE(same.status == undecided);
  REQUIRE(same.gap < 1e-12);
}

TEST_CASE("C9: the bound of a flat difference is some ε, however thin that is", "[certified]") {
  Dice dice(37);
  const auto any = [&] { return V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)); };
  for (int i = 0; i < 500; ++i) {
    const V p = any(), q = dice.between(-1.0, 1.0) * p + std::ldexp(1.0, -dice.between(0, 60)) * any();
    const PointSet<double> a({p, -p}), b({q, -q});  // they cross at the origin
    const Any any_a(a), any_b(b);
    const detail::BoundedDifference<double, Any, Any> difference(any_a, any_b);
    const ShapesResult result = said_of(a, b);
    CAPTURE(i);
    REQUIRE(result.status == undecided);
    REQUIRE(result.gap <= 16 * difference.unscaled(difference.error()));
  }
}

TEST_CASE(
    "C7: flat shapes in one plane are soon found apart, and no support function is asked along what is no direction",
    "[certified]") {
  const auto flat = [](std::vector<V> points, const Eigen::Matrix3d& turned) {
    for (V& p : points) p = V(turned * p);
    return Blurred{PointSet<double>(std::move(points)), 0};
  };
  Dice dice(14);
  for (int i = 0; i < 200; ++i) {
    const V axis(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(i == 0 ? 0 : dice.between(0.0, 3.0), axis.normalized()).matrix();
    const ShapesResult result = said_of(flat({V(0, 0, 0), V(2, 0, 0), V(0, 2, 0)}, turned),
                                        flat({V(1.5, 1.5, 0), V(2.5, 1.6, 0), V(1.6, 2.5, 0)}, turned));
    INFO("turn " << i << ", gap " << result.gap);
    REQUIRE(result.status == apart);
    REQUIRE(result.iterations < 200);
  }
}

TEST_CASE("C9: points that rounding moves out of one plane make no surface that runs through itself", "[certified]") {
  const PointSet<double> a({V(0x1.b6db6db6db6dap-1, 0x1.2db6db6db6db7p+2, 0), V(-0x1p-1074, 0, -0x1.9b6db6db6db6cp+2)});
  const PointSet<double> b({V(0x1.4924924924925p+0, 0x1.b6db6db6db6dbp+0, -0x1.1249249249248p+1),
                            V(-0x1.4924924924924p+0, -0x1.b6db6db6db6dbp+0, -0x1.56db6db6db6dap+3)});
  const ShapesResult result = said_of(a, b);
  REQUIRE(result.status == undecided);
  REQUIRE(result.gap < 1e-7);
  REQUIRE(result.iterations < 3000);
}

TEST_CASE("C8: a surface that passes the origin by less than a rounding goes around it or not, exactly",
          "[certified]") {
  Dice dice(7474);
  const auto det = [](const V& x, const V& y, const V& z) {
    const auto of = [](const V& v) {
      return detail::Triple<Rational>{Rational(v.x()), Rational(v.y()), Rational(v.z())};
    };
    return detail::dot(detail::cross(of(x), of(y)), of(z));
  };
  int beside = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto any = [&] { return V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)); };
    const V a = any(), b = any(),
            c = -dice.between(0.2, 1.0) * a - dice.between(0.2, 1.0) * b;  // the origin between them
    const V d = any();
    const Rational of[] = {det(b, c, d), -det(a, c, d), det(a, b, d), -det(a, b, c)};
    const bool is_inside = std::ranges::all_of(of, [&](const Rational& x) { return x * of[0] > 0; });
    CAPTURE(i);
    CHECK(detail::Surface({a, b, c, d}).goes_around_origin() == is_inside);
    beside += !is_inside;
  }
  CHECK(beside > 500);
}

TEST_CASE("C7 to C9: shapes of any size are answered as those of size 1", "[certified]") {
  const auto asked = [](int scale, const V& center) {
    const auto large = [scale](double x) { return std::ldexp(x, scale); };
    const Cylinder<double> can(V(0, 0, 0), V(0, 0, 1), large(1), large(2));
    const V moved(large(center.x()), large(center.y()), large(center.z()));
    return said_of(can, Cylinder<double>(moved, V(0, 0, 1), large(1), large(2)));
  };
  for (const auto& [center, status] : {std::pair{V(0.5, 0.1, 0.1), together}, std::pair{V(0.5, 0.1, 2.1), apart},
                                       std::pair{V(0.3, 0.2, 2), undecided}}) {
    const ShapesResult usual = asked(0, center);
    REQUIRE(usual.status == status);
    for (const int scale : {-950, -500, -250, 250, 500, 950}) {
      INFO(center.transpose() << " times 2^" << scale);
      const ShapesResult result = asked(scale, center);
      REQUIRE(result.status == status);
      REQUIRE(result.gap == std::ldexp(usual.gap, scale));
      REQUIRE(result.iterations == usual.iterations);
    }
  }
}

TEST_CASE("C9: a length that is rounded in the units of the shapes is rounded up", "[certified]") {
  const PointSet<double> point({V(0x1p-1060, 0, 0)});  // a least number is 2^-14 of the unit
  const Any small(point);
  const detail::BoundedDifference<double, Any, Any> difference(small, small);
  for (const double least : {100.2, 100.5, 100.7, 101.0, 101.5})
    CHECK(difference.unscaled(std::ldexp(least, -14)) == std::ldexp(std::ceil(least), -1074));
}

TEST_CASE("C8: a difference grown by a ball is known worse, by 16 roundings of its radius", "[certified]") {
  const PointSet<double> set({V(1, 0, 0)});
  const Any point(set);
  const detail::BoundedDifference<double, Any, Any> difference(point, point);
  for (const double radius : {0.5, 1.0, 1024.0})
    CHECK(difference.error(radius) - difference.error() == Approx(16 * 0x1p-53 * radius));
}

TEST_CASE("C9: of what might overflow nothing is known", "[certified]") {
  const ShapesResult result = said_of(Sphere<double>(V(1e307, 0, 0), 1), Sphere<double>(V(0, 0, 0), 1));
  REQUIRE(result.status == undecided);
  REQUIRE(std::isinf(result.gap));
  REQUIRE(result.iterations == 0);
}

// -- Right answers ----------------------------------------------------------------------------------------------------

namespace {

/// Two cylinders with axes along z, so made that their numbers are exact. `gap`: of caps, or of sides.
template <class S>
struct Cans {
  Cylinder<S> a, b;
};
template <class S>
Cans<S> cans_in_flat_contact(Dice& dice, S gap) {
  const auto quarter = [&](int low, int high) { return static_cast<S>(dice.between(low, high)) / 4; };
  const S r = quarter(1, 4), other_r = quarter(1, 4), h = quarter(2, 8) * 2, other_h = quarter(2, 8) * 2;
  const Vec3<S> axis(0, 0, dice.between(0, 1) ? 1 : -1);
  if (dice.between(0, 1))  // end to end, somewhere over the other
    return {{Vec3<S>(0, 0, 0), axis, r, h},
            {Vec3<S>(quarter(-1, 1), quarter(-1, 1), (h + other_h) / 2 + gap), axis, other_r, other_h}};
  return {{Vec3<S>(0, 0, 0), axis, r, h}, {Vec3<S>(0, -(r + other_r + gap), quarter(-1, 1)), axis, other_r, other_h}};
}

}  // namespace

TEMPLATE_TEST_CASE("Cylinders in flat contact are decided, rightly, down to gaps of some hundred roundings",
                   "[certified]", float, double, long double) {
  using S = TestType;
  Dice dice(12);
  const int finest = std::numeric_limits<S>::digits - 11;
  for (const int digits : {4, 10, finest - 8, finest})
    for (int i = 0; i < 500; ++i) {
      const S gap = std::scalbn(S(1), -digits);
      for (const S signed_gap : {gap, -gap}) {
        const auto [a, b] = cans_in_flat_contact<S>(dice, signed_gap);
        INFO("pair " << i << ", gap " << signed_gap);
        REQUIRE(certified_shapes<S>(AnyDoubtful<S>(a), AnyDoubtful<S>(b)).status ==
                (signed_gap > 0 ? apart : together));
        REQUIRE(certified_shapes<S>(AnyDoubtful<S>(b), AnyDoubtful<S>(a)).status ==
                (signed_gap > 0 ? apart : together));
      }
    }
}

namespace {

/// Two cylinders side by side, with one axis that lies anyhow. `gap`: of their sides.
Cans<double> parallel_cans(Dice& dice, double gap) {
  const auto any_direction = [&] {
    return V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)).normalized();
  };
  const V axis = any_direction(), across = axis.cross(any_direction()).normalized();
  const double r = dice.between(0.3, 1.0), other_r = dice.between(0.3, 1.0), h = dice.between(0.5, 2.0);
  return {{V(0, 0, 0), axis, r, h}, {(r + other_r + gap) * across + 0.1 * axis, axis, other_r, dice.between(0.5, 2.0)}};
}

}  // namespace

TEST_CASE("Parallel cylinders side by side are decided, rightly, however their axis lies", "[certified]") {
  Dice dice(15);
  for (const double gap : {0.3, 0.1, 1e-2, 1e-3, 1e-6, 1e-9})
    for (int i = 0; i < 200; ++i)
      for (const double signed_gap : {gap, -gap}) {
        const auto [a, b] = parallel_cans(dice, signed_gap);
        INFO("pair " << i << ", gap " << signed_gap);
        REQUIRE(said_of(a, b).status == (signed_gap > 0 ? apart : together));
      }
}

namespace {

using L = long double;

/// Two cylinders askew, the second moved from the first along a direction.
struct Askew {
  double r, h, other_r, other_h;
  V axis, other_axis, way;

  explicit Askew(Dice& dice) {
    for (double* x : {&r, &h, &other_r, &other_h}) *x = dice.between(0.2, 1.5);
    for (V* v : {&axis, &other_axis, &way})
      *v = V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
    way.normalize();
  }
  /// Returns: what is said of them in S, the second being there.
  template <class S>
  ShapesResult at(const Vec3<S>& center) const {
    const Cylinder<S> a(Vec3<S>::Zero(), axis.cast<S>(), S(r), S(h)),
        b(center, other_axis.cast<S>(), S(other_r), S(other_h));
    return certified_shapes<S>(AnyDoubtful<S>(a), AnyDoubtful<S>(b));
  }
  /// Returns: how far the second is moved where they touch, to a few roundings of long doubles, and a direction that separates.
  std::pair<L, V> contact() const {
    L deep = 0, far = 10;
    V separating(0, 0, 0);
    while (true) {
      const L middle = (deep + far) / 2;
      const ShapesResult result = at<L>(way.cast<L>() * middle);
      if (result.status == undecided || middle == deep || middle == far) return {middle, separating.normalized()};
      (result.status == apart ? far : deep) = middle;
      if (result.status == apart) separating = result.direction;
    }
  }
};

}  // namespace

TEST_CASE("C9: in long doubles cylinders askew are decided, or nearer than ten times their gap or ten roundings",
          "[certified]") {
  Dice dice(17);
  int seen = 0;
  for (int i = 0; i < 100; ++i) {
    const Askew pair(dice);
    const auto [touching, d] = pair.contact();
    const double steepness = std::abs(d.dot(pair.way));
    for (const double gap : {1e-1, 1e-6, 1e-12, 1e-15, 1e-16, 0.0})
      for (const double signed_gap : {gap, -gap}) {
        const V center = pair.way * static_cast<double>(touching) + pair.way * (signed_gap / steepness);
        const ShapesResult result = pair.at<L>(center.cast<L>());
        INFO("pair " << i << ", gap " << signed_gap << ", said " << result.gap);
        const double rounding = 0x1p-53 * center.norm();
        if (gap > 20 * rounding) REQUIRE(result.status == (signed_gap > 0 ? apart : together));
        if (result.status != undecided) continue;
        ++seen;
        REQUIRE(result.gap <= 10 * std::max(gap, rounding));
      }
  }
  REQUIRE(seen > 20);
}

TEST_CASE("C9: where rounding leaves open whether they meet they are no deeper in each other than is said",
          "[certified]") {
  Dice dice(16);
  int seen = 0;
  for (const double depth : {6e-14, 3e-14})
    for (int i = 0; i < 200; ++i) {
      const auto [a, b] = parallel_cans(dice, -depth);
      const ShapesResult result = said_of(Short{a, depth / 20}, Short{b, depth / 20});
      INFO("pair " << i << ", depth " << depth);
      REQUIRE(result.status != apart);
      if (result.status != undecided) continue;
      ++seen;
      REQUIRE(result.gap >= depth);
    }
  REQUIRE(seen > 50);
}

}  // namespace certified_shapes_test
}  // namespace gjk::test
