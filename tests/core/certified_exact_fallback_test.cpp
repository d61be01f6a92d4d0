// The bounds that the second search of certified_collision() goes by where it need not look exactly, each where it stands: of
// what may be lost of a coordinate, of a direction, and by a scan along it.
#include <array>
#include <cmath>
#include <string>

#include "core/certified/exact_fallback.hpp"
#include "tests/core/certified_support.hpp"

namespace gjk::test {
namespace certified_exact_fallback_test {

using detail::Bounded;
using V = Vec3<double>;

// -- Coordinates ------------------------------------------------------------------------------------------------------

Bounded coordinate(double largest, double x) {
  const Pair<double> pair = pair_of<double>({V(largest, x, 0)}, {V(0, 0, 0)});
  return detail::ExactDifference<double>(pair.a, pair.b).number<Bounded>(x);
}

TEST_CASE("A coordinate below 2^-960 of the largest may have lost digits, any other has not", "[certified]") {
  CHECK(coordinate(1, 0x1p-960).error == 0);
  CHECK(coordinate(1, -0x1p-960).error == 0);
  CHECK(coordinate(1, below(0x1p-960)).error == 1e-300);
  CHECK(coordinate(1, -below(0x1p-960)).error == 1e-300);
  CHECK(coordinate(1, 0).error == 0);
  for (const double x : {0x1.23456789abcdfp-959, 0x1.23456789abcdfp-1000, 0x1.23456789abcdfp-1022, 0x1p-1074})
    for (const double largest : {1.0, 0x1p10, 0x1p60, 0x1p1023}) {
      const Bounded near = coordinate(largest, x);
      INFO(x << " of " << largest << " is " << near.value << " ± " << near.error);
      const Rational meant = Rational(x) / Rational(largest);
      CHECK(abs(meant - Rational(near.value)) <= Rational(near.error));
      CHECK((meant == Rational(near.value) || near.error > 0));
    }
}

// -- Directions -------------------------------------------------------------------------------------------------------

/// How far a direction is off at most, as a share of its largest component.
double inaccuracy(const detail::Triple<Bounded>& d) {
  const double largest = std::max({std::abs(d.x.value), std::abs(d.y.value), std::abs(d.z.value)});
  return std::max({d.x.error, d.y.error, d.z.error}) / largest;
}

/// Whether the search goes along the normal of a triangle with that height as doubles have it; else it takes it of whole numbers.
struct Normal {
  double inaccuracy;
  bool is_of_doubles;
};
Normal normal_with(double height) {
  const Pair<double> pair = pair_of<double>({V(1, 1, 0), V(2, 2, 1), V(2, 2, 1 + height)}, {V(0, 0, 0)});
  const detail::ExactDifference<double> difference(pair.a, pair.b);
  detail::ExactSimplex triangle(difference);
  for (int i = 0; i < 3; ++i) triangle.add({i, 0});
  const auto of_doubles = triangle.toward_origin<Bounded>();
  const Bounded reach = detail::AlongDirection(difference, triangle).reach({0, 0});
  return {inaccuracy(of_doubles), reach.error == dot(difference.w<Bounded>({0, 0}), of_doubles).error};
}

TEST_CASE("A direction that doubles know to 2^-20 is theirs, any other that of whole numbers", "[certified]") {
  int closely_below = 0, closely_above = 0;
  for (int k = 20; k < 45; ++k) {
    const Normal normal = normal_with(std::ldexp(1.0, -k));
    INFO("2^-" << k << ": off by " << normal.inaccuracy);
    CHECK(normal.is_of_doubles == (normal.inaccuracy < 0x1p-20));
    closely_below += 0x1p-21 <= normal.inaccuracy && normal.inaccuracy < 0x1p-20;
    closely_above += 0x1p-20 <= normal.inaccuracy && normal.inaccuracy < 0x1p-19;
  }
  CHECK(closely_below > 0);
  CHECK(closely_above > 0);
}

TEST_CASE("Of whole numbers that no double holds the highest bits are off by 1 and a rounding at most", "[certified]") {
  using detail::Whole;
  const auto is_true = [](const Whole& x, const Bounded& found, unsigned cut) {
    return abs(Rational(x) / Rational(Whole(1) << cut) - Rational(found.value)) <= Rational(found.error);
  };
  Dice dice(7474);
  for (const unsigned bits : {3U, 59U, 60U, 61U, 130U, 700U})
    for (int i = 0; i < 200; ++i) {
      // Half way between two doubles, ones behind; or anything.
      const Whole half_way = ((Whole(1) << 59) + 64 + 128 * dice.between(0, 3)), one = 1;
      Whole any = dice.between(1, 3);
      while (msb(any) + 1 < bits) any = (any << 8) + dice.between(0, 255);
      any >>= msb(any) + 1 - bits;
      const Whole x = i < 20 && bits > 60 ? (half_way << (bits - 60)) + (one << (bits - 60)) - 1 : any;
      const detail::HighestBits found = detail::highest_bits({x, -x / 3, x / (one << 40)});
      INFO(x << " cut by " << found.cut);
      CHECK((found.cut == 0 || found.vector.x.value >= 0x1p59));
      CHECK(found.vector.x.value <= 0x1p60);
      CHECK(is_true(x, found.vector.x, found.cut));
      CHECK(is_true(-x / 3, found.vector.y, found.cut));
      CHECK(is_true(x / (one << 40), found.vector.z, found.cut));
    }
}

TEST_CASE("A direction is told as long as it is where each of its numbers can be written in full, else near 1",
          "[certified]") {
  const auto told = [](const Vec3<float>& w) {
    // The first search comes to no answer.
    const auto events =
        test::told<float>(pair_of<float>({w}, {Vec3<float>::Zero()}), {.first_direction = w, .iteration_limit = 1});
    return events_of_kind<DirectionChosen<float>>(events).back().direction;
  };
  const float x = 0x1p-100F, least = 0x1p-126F, less = 0x1p-127F;  // `less` has a digit less than others
  for (const auto& at : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
    const auto vector = [&](float y) {
      Vec3<float> w;
      w[at[0]] = x, w[at[1]] = y, w[at[2]] = 0;
      return w;
    };
    REQUIRE(told(vector(least)) == Vec3<float>(-vector(least)));
    CHECK(told(vector(less)).cwiseAbs().maxCoeff() > 0.1F);
  }
}

// -- Scans ------------------------------------------------------------------------------------------------------------

/// Sets of points on a line, by their places. Returns: whether the second search, which finds no vertex across, knows that
/// from the scan; else it has looked exactly.
template <class S>
bool is_known_from_scan(const std::vector<S>& a, const std::vector<S>& b) {
  const auto on_x = [](const std::vector<S>& places) {
    std::vector<Vec3<S>> points;
    for (const S x : places) points.emplace_back(x, 0, 0);
    return points;
  };
  const Pair<S> pair = pair_of<S>(on_x(a), on_x(b));
  // The first search comes to no answer.
  const auto events = told<S>(pair, {.first_direction = {0, 1, 0}, .iteration_limit = 1});
  const CertifiedResult result = std::get<Certified<S>>(events.back()).result;
  REQUIRE(result.status == Status::separated);
  REQUIRE(result.proof == Proof::exact_fallback);
  for (const auto& sign : events_of_kind<SignTaken<S>>(events))
    if (sign.expression == "max w·d") return sign.exact.empty();
  FAIL("no scan");
  return false;
}

TEMPLATE_TEST_CASE("A scan along d misleads by 16u of the extents at most, and twice as far as d itself is off",
                   "[certified]", float, double) {
  using S = TestType;
  const auto apart = [](int digits) { return 1 + static_cast<S>(digits) * std::numeric_limits<S>::epsilon(); };
  // Two extents of 16u are 16 digits; in double d, a difference, is off by u, of which floats see nothing.
  const int in_doubt = std::same_as<S, float> ? 16 : 18;
  const S near = apart(in_doubt), far = apart(in_doubt + 1);
  REQUIRE_FALSE(is_known_from_scan<S>({1}, {near}));
  REQUIRE(is_known_from_scan<S>({1}, {far}));
  REQUIRE_FALSE(is_known_from_scan<S>({near}, {1}));
  REQUIRE(is_known_from_scan<S>({far}, {1}));
  // The extents of both sets count.
  REQUIRE_FALSE(is_known_from_scan<S>({1, S(-1.5)}, {far}));
  REQUIRE_FALSE(is_known_from_scan<S>({1}, {far, S(1.5)}));
}

TEST_CASE("Of denormal numbers a scan loses 8 times the least at most, in each set", "[certified]") {
  // n of the least numbers apart they reach n²/1024 of them along d, which is n/1024; in double that is rounded to whole ones.
  const float least_float = std::numeric_limits<float>::denorm_min();
  REQUIRE_FALSE(is_known_from_scan<float>({0}, {128 * least_float}));
  REQUIRE(is_known_from_scan<float>({0}, {129 * least_float}));
  const double least = std::numeric_limits<double>::denorm_min();
  REQUIRE_FALSE(is_known_from_scan<double>({0}, {129 * least}));
  REQUIRE(is_known_from_scan<double>({0}, {130 * least}));
}

}  // namespace certified_exact_fallback_test
}  // namespace gjk::test
