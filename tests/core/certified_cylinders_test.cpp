/// C11: cylinders along one coordinate axis, with each other and with balls and capsules, against distances in fractions.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/certified/cylinders.hpp"
#include "core/certified/shapes.hpp"
#include "tests/core/certified_support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace certified_cylinders_test {
namespace {

using V = Vec3<double>;

constexpr auto apart = Status::separated, together = Status::intersecting;

AxialCylinder can(const V& center, const V& axis, double radius, double height, const Motion& motion = {}) {
  return AxialCylinder::of(center, axis, radius, height, motion).value();
}

V unit(int axis) { return V::Unit(axis); }

/// Returns: whether √q − r, or 0 where that is less, and `beyond` are the sides of a right triangle whose longest is at
/// most s: the square of √q against what it may be, searched for by halves.
bool is_within(const Rational& q, const Rational& beyond, const Rational& r, const Rational& s) {
  if (beyond > s) return false;
  if (q <= r * r) return true;
  Rational low = 0, high = s;  // for √(s² − beyond²)
  const Rational left = s * s - beyond * beyond;
  for (int i = 0; i < 120; ++i) {
    const Rational middle = (low + high) / 2;
    (middle * middle <= left ? low : high) = middle;
  }
  if (q <= (r + low) * (r + low)) return true;
  return (high * high == left) && q <= (r + high) * (r + high);
}

}  // namespace

TEST_CASE("C11: cylinders meet where their discs and their intervals do", "[certified]") {
  for (int axis = 0; axis < 3; ++axis) {
    const V along = unit(axis), across = 3 * unit((axis + 1) % 3) + 4 * unit((axis + 2) % 3);
    const auto status = [&](double radius, double height, double rise) {
      const AxialCylinder a = can(V(0, 0, 0), V(-2 * along), 2, 1);
      const AxialCylinder b = can(V(across + rise * along), along, radius, height);
      REQUIRE(certified_status(a, b) == certified_status(b, a));
      return certified_status(a, b);
    };
    REQUIRE(status(3, 1, 1) == together);
    REQUIRE(status(below(3.0), 1, 1) == apart);
    REQUIRE(status(3, below(1.0), 1) == apart);
    REQUIRE(status(3, 1, -1) == together);
    REQUIRE(status(3, below(1.0), -1) == apart);
    REQUIRE(status(3, 0, 0.5) == together);
    REQUIRE(status(3, 0, above(0.5)) == apart);
  }
}

TEST_CASE("C11: a ball meets a cylinder that is at most its radius away", "[certified]") {
  Dice dice(7);
  int touching = 0;
  for (int i = 0; i < 3000; ++i) {
    const int axis = dice.between(0, 2);
    const double r = dice.between(0, 5), h = 2 * dice.between(0, 4), s = dice.between(0, 13);
    const V center = vec<double>(dice.point(3)), ball = vec<double>(dice.point(12));
    const V way = ball - center;
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    const Rational q = Rational(way[y]) * Rational(way[y]) + Rational(way[z]) * Rational(way[z]);
    const Rational beyond = std::max(Rational(0), Rational(std::abs(way[axis])) - Rational(h / 2));
    const bool expected = is_within(q, beyond, Rational(r), Rational(s));
    INFO("pair " << i);
    REQUIRE(certified_status(can(center, unit(axis), r, h), Grown(Sphere<double>(ball, s))) ==
            (expected ? together : apart));
    if (s > 0) {
      const bool closer = is_within(q, beyond, Rational(r), Rational(below(s)));
      REQUIRE(certified_status(can(center, unit(axis), r, h), Grown(Sphere<double>(ball, below(s)))) ==
              (closer ? together : apart));
      touching += expected && !closer;
    }
  }
  REQUIRE(touching > 5);
}

TEST_CASE("C11: a capsule along the axis meets a cylinder as its segment grown by a ball does", "[certified]") {
  const AxialCylinder a = can(V(0, 0, 0), V(0, 0, 1), 1, 2);
  const auto status = [&](double x, double from, double to, double radius) {
    return certified_status(a, Grown({{{{x, 0, from}, {x, 0, to}}}}, radius));
  };
  REQUIRE(status(3, -9, 9, 2) == together);
  REQUIRE(status(3, -9, 9, below(2.0)) == apart);
  REQUIRE(status(4, 5, 9, 5) == together);
  REQUIRE(status(4, 5, 9, below(5.0)) == apart);
  REQUIRE(status(4, -9, -5, 5) == together);
  REQUIRE(status(4, -9, -5, below(5.0)) == apart);
  REQUIRE_FALSE(certified_status(a, Grown({{{{3, 0, 0}, {4, 0, 1}}}}, 1)).has_value());  // it is oblique
  REQUIRE_FALSE(certified_status(a, Grown({{{{3, 0, 0}}}, {{{0, 0, 0}, {0, 0, 1}}}}, 1)).has_value());
}

TEST_CASE("A motion moves center and axis of a cylinder, exactly", "[certified]") {
  const Quaternion fifth{2, 0, 0, 1};  // by cosine 3/5 about z
  const auto turned = AxialCylinder::of(V(5, 0, 0), V(0, 0, 1), 1, 2, {fifth, V(0, 0, 7)});
  REQUIRE(turned.has_value());
  REQUIRE(certified_status(*turned, can(V(3, 4, 8), V(0, 0, 1), 0, 0)) == together);
  REQUIRE(certified_status(*turned, can(V(3, 4, above(8.0)), V(0, 0, 1), 0, 0)) == apart);
  REQUIRE_FALSE(AxialCylinder::of(V(5, 0, 0), V(1, 0, 0), 1, 2, {fifth, V(0, 0, 7)}).has_value());
  const auto quarter = AxialCylinder::of(V(0, 0, 0), V(1, 0, 0), 1, 2, {Quaternion{1, 0, 0, 1}});
  REQUIRE(quarter.value().axis() == 1);
  REQUIRE_THROWS_AS(certified_status(*turned, *quarter), std::invalid_argument);
  REQUIRE_THROWS_AS(AxialCylinder::of(V(0, 0, 0), V(1, 0, 0), -1, 2), std::invalid_argument);
}

}  // namespace certified_cylinders_test
}  // namespace gjk::test
