/// certified_status(): balls and balls, balls and sets of points, against distances in fractions.
#include "core/certified/balls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/oracle.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

constexpr auto apart = Status::separated, together = Status::intersecting;

/// Returns: the square of the distance of the origin from the hull of some points: the least over all their subsets whose
/// point nearest to it, on the line or plane through them, is a combination without a weight below 0.
Rational squared_distance_of_hull(const ExactVecs& points) {
  Rational least = -1;
  for (unsigned subset = 1; subset < 1U << points.size(); ++subset) {
    ExactVecs some;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (subset >> i & 1U) some.push_back(points[i]);
    if (some.size() > 4 || gram_determinant(some) == 0) continue;
    const auto weights = coordinates_of_origin(some);
    const Rational squared = toward_origin(some).squaredNorm();
    const bool is_inside = std::ranges::all_of(weights, [](const Rational& w) { return w >= 0; });
    if (is_inside && (least < 0 || squared < least)) least = squared;
  }
  return least;
}

template <class S>
ExactVecs seen_from(const Sphere<S>& ball, const PointSet<S>& points) {
  ExactVecs differences = exact(points.points());
  for (ExactVec& w : differences) w -= exact(ball.center());
  return differences;
}

}  // namespace

TEMPLATE_TEST_CASE("Two balls meet where their centers are at most the sum of their radii apart, exactly",
                   "[certified]", float, double) {
  using S = TestType;
  Dice dice(1);
  int touching = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto point = [&] { return vec<S>(dice.point(6)); };
    const Sphere<S> a(point(), static_cast<S>(dice.between(1, 6)));
    const Sphere<S> b(point(), static_cast<S>(dice.between(1, 4)) + (i % 2 ? std::scalbn(S(1), -15) : S(0)));
    const ExactVec way = exact(a.center()) - exact(b.center());
    const Rational reach = Rational(a.radius()) + Rational(b.radius());
    INFO("pair " << i);
    touching += way.dot(way) == reach * reach;
    REQUIRE(certified_status(a, b) == (way.dot(way) <= reach * reach ? together : apart));
    REQUIRE(certified_status(b, a) == certified_status(a, b));
  }
  REQUIRE(touching > 10);
}

TEMPLATE_TEST_CASE("A ball and a set of points meet where its center is at most a radius from their hull, exactly",
                   "[certified]", float, double) {
  using S = TestType;
  Dice dice(2);
  int touching = 0, inside = 0;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Vec3<S>> list;
    for (int more = dice.between(1, 6); more > 0; --more) list.push_back(vec<S>(dice.point(3)));
    const PointSet<S> points(list);
    const Sphere<S> ball(vec<S>(dice.point(5)), i % 4 ? S(dice.between(1, 4)) : std::sqrt(S(dice.between(1, 30))));
    const Rational squared = squared_distance_of_hull(seen_from(ball, points));
    const Rational radius(ball.radius());
    INFO("pair " << i);
    touching += squared == radius * radius;
    inside += squared == 0;
    REQUIRE(certified_status(points, ball) == (squared <= radius * radius ? together : apart));
    REQUIRE(certified_status(ball, points) == certified_status(points, ball));
  }
  REQUIRE(touching > 5);
  REQUIRE(inside > 5);
}

TEMPLATE_TEST_CASE("A radius smaller by one unit in the last place no longer reaches", "[certified]", float, double) {
  using S = TestType;
  const auto require_edge = [](const auto& other, const Vec3<S>& center, S radius) {
    REQUIRE(certified_status(other, Sphere<S>(center, radius)) == together);
    REQUIRE(certified_status(other, Sphere<S>(center, std::nextafter(radius, S(0)))) == apart);
  };
  const int range = std::numeric_limits<S>::max_exponent - 6;
  for (const int power : {0, 1, -1, range, -range}) {
    const S one = std::scalbn(S(1), power);
    INFO("times 2^" << power);
    require_edge(Sphere<S>({0, 0, 0}, one), {3 * one, 4 * one, 12 * one}, 12 * one);
    require_edge(PointSet<S>({{0, 0, 0}}), {3 * one, 4 * one, 12 * one}, 13 * one);                        // a vertex
    require_edge(PointSet<S>({{-one, 0, 0}, {one, 0, 0}}), {0, 3 * one, 4 * one}, 5 * one);                // an edge
    require_edge(PointSet<S>({{-one, 0, 0}, {one, 0, 0}, {0, one, 0}}), {0, one / 4, -3 * one}, 3 * one);  // a face
  }
}

TEST_CASE("Balls are told apart from sets far smaller and far larger than they", "[certified]") {
  const double huge = 1e300, tiny = 1e-300;
  const PointSet<double> small({{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}});
  REQUIRE(certified_status(small, Sphere<double>({huge, 0, 0}, huge)) == together);
  REQUIRE(certified_status(small, Sphere<double>({-huge, 0, 0}, huge)) ==
          apart);  // which touches the plane x = 0 at 0 only
  const PointSet<double> beyond({{tiny, 0, 0}, {tiny, tiny, 0}});
  REQUIRE(certified_status(beyond, Sphere<double>({-huge, 0, 0}, huge)) == apart);
  REQUIRE(certified_status(Sphere<double>({tiny, 0, 0}, tiny), Sphere<double>({-huge, 0, 0}, huge)) == together);
  REQUIRE(certified_status(Sphere<double>({3 * tiny, 0, 0}, tiny), Sphere<double>({-huge, 0, 0}, huge)) == apart);
}

}  // namespace gjk::test
