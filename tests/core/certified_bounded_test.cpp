/// A double that knows its error: the bounds, looked at in fractions where they are tight.
#include "core/certified/bounded.hpp"

#include <limits>

#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace certified_bounded_test {

using detail::Bounded;

constexpr double u = 0x1p-53, largest = std::numeric_limits<double>::max(),
                 infinity = std::numeric_limits<double>::infinity();

/// A bounded number and one of those that it may stand for.
struct Known {
  Bounded bounded;
  Rational meant;

  explicit Known(double value) : bounded{value, 0}, meant(value) {}
  Known(Bounded b, Rational m) : bounded(b), meant(std::move(m)) {}

  bool holds() const { return abs(meant - Rational(bounded.value)) <= Rational(bounded.error); }
  friend Known operator-(const Known& x) { return {-x.bounded, -x.meant}; }
  friend Known operator+(const Known& x, const Known& y) { return {x.bounded + y.bounded, x.meant + y.meant}; }
  friend Known operator-(const Known& x, const Known& y) { return {x.bounded - y.bounded, x.meant - y.meant}; }
  friend Known operator*(const Known& x, const Known& y) { return {x.bounded * y.bounded, x.meant * y.meant}; }
};

/// The least number that `x` may stand for, itself, and the largest.
std::array<Known, 3> extremes(const Bounded& x) {
  const Rational value(x.value), error(x.error);
  return {{{x, value - error}, {x, value}, {x, value + error}}};
}

void require_all_hold(const Bounded& x, const Bounded& y) {
  INFO(x.value << " ± " << x.error << " and " << y.value << " ± " << y.error);
  for (const Known& known_x : extremes(x))
    for (const Known& known_y : extremes(y)) {
      REQUIRE((known_x + known_y).holds());
      REQUIRE((known_x - known_y).holds());
      REQUIRE((known_x * known_y).holds());
    }
}

TEST_CASE("The error of one operation, to the last bit: neither too small nor, where nothing asks for it, larger") {
  const double rounded = 1 + 0x1p-49;  // 16u
  const Bounded one{1, 0}, zero{0, 0}, about_zero{0, 3}, further{0, 5}, three{3, 0.5};
  CHECK((one + one).error == 0x1p-52 * rounded);
  CHECK((one - one).error == 0);
  CHECK((one * one).error == 0x1p-53 * rounded);
  CHECK((one * zero).error == 1e-300);
  CHECK((about_zero * further).error == 15 * rounded);
  CHECK((three * further).error == 17.5 * rounded);
  CHECK((further * three).error == 17.5 * rounded);
  CHECK((about_zero - further).error == 8 * rounded);
  CHECK((-three).error == 0.5);
}

TEST_CASE("What comes in with an error goes out with all that it does at its extremes", "[bounded]") {
  const std::vector<Bounded> numbers{{0, 0},  {0, 1},       {0, 0x1p-60},  {3, 0},     {3, 1},        {3, 0x1p-60},
                                     {-3, 1}, {-3, 0x1p-9}, {1000, 0.125}, {0.1, 0.3}, {1e-9, 1e-12}, {-7e8, 3e5}};
  for (const Bounded& x : numbers)
    for (const Bounded& y : numbers) require_all_hold(x, y);
}

TEST_CASE("Errors that are rounded down themselves are enlarged for it", "[bounded]") {
  Dice dice(51);
  require_all_hold({1, 1}, {-1, u});
  for (int i = 0; i < 1000; ++i) {  // values that need no rounding leave nothing that would make up for it
    const Bounded x{0, dice.between(0.0, 1.0)}, y{0, std::ldexp(dice.between(0.0, 1.0), dice.between(-60, 60))};
    require_all_hold(x, y);
    require_all_hold({1, x.error}, {1, y.error});
  }
}

TEST_CASE("A product of two errors that underflows is allowed for", "[bounded]") {
  require_all_hold({0, 1e-200}, {0, 1e-200});
  require_all_hold({0, 0x1p-537}, {0, 0x1p-538});
  require_all_hold({0x1.6p-538, 0x1.6p-539},
                   {0x1.6p-538, 0x1.6p-538});  // four parts, each less than half the least number
  require_all_hold({1e-200, 0}, {0, 1e-200});
  require_all_hold({0, 1e-200}, {1e-200, 0});
}

TEST_CASE("A product that underflows is no certain zero", "[bounded]") {
  const Known x(1e-200), nothing = x * x;
  REQUIRE(nothing.bounded.value == 0);
  REQUIRE(nothing.holds());
  REQUIRE_FALSE(nothing.bounded.has_certain_sign());
  for (const double small : {0x1p-537, 0x1.8p-537, 0x1p-538, 0x1.123456789p-515})
    REQUIRE((Known(small) * Known(0x1.00000001p-537)).holds());
  const Known sum = Known(5e-324) - Known(1e-323);  // of sums nothing is lost
  REQUIRE(sum.bounded.has_certain_sign());
  REQUIRE(sign_of(sum.bounded) == -1);
}

TEST_CASE("Where something overflows no sign is certain", "[bounded]") {
  const Bounded huge{largest, 0}, x{1, 0}, vague{1, largest}, lost = huge + huge;
  for (const Bounded& overflow : {lost, -lost, huge * huge, lost - lost, lost * x, lost * Bounded{0, 0}, lost + x,
                                  vague * vague, vague + vague, vague * huge, huge * vague, Bounded{0, infinity},
                                  Bounded{infinity, infinity}, Bounded{std::nan(""), std::nan("")}}) {
    INFO(overflow.value << " ± " << overflow.error);
    REQUIRE_FALSE(overflow.has_certain_sign());
  }
}

TEST_CASE("A sign is certain beyond the error, and without one", "[bounded]") {
  for (const double sign : {1.0, -1.0}) {
    REQUIRE_FALSE(Bounded{sign, 1}.has_certain_sign());
    REQUIRE_FALSE(Bounded{sign, 2}.has_certain_sign());
    const Bounded beyond{sign, 1 - u};
    REQUIRE(beyond.has_certain_sign());
    REQUIRE(sign_of(beyond) == static_cast<int>(sign));
  }
  REQUIRE(Bounded{0, 0}.has_certain_sign());
  REQUIRE(sign_of(Bounded{0, 0}) == 0);
  REQUIRE_FALSE(Bounded{0, 5e-324}.has_certain_sign());
}

}  // namespace certified_bounded_test
}  // namespace gjk::test
