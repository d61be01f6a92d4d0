/// Shapes and places that strain the range and the digits of a number.
#include <cmath>
#include <string>

#include "walkthroughs/pairs/families_recipes.hpp"

namespace walkthroughs::pairs {
namespace {

Points triangle_or_tetrahedron(Dice& dice) { return points_in_unit_cube(dice, dice.coin() ? 3 : 4); }

std::string power_of_ten(int exponent) { return "1e" + std::to_string(exponent); }

// -- Shapes -----------------------------------------------------------------------------------------------------------

Pair flat(Dice& dice, double thickness) {
  const Vec factors(1, 1, thickness);
  Points a = triangle_or_tetrahedron(dice);
  Points b = triangle_or_tetrahedron(dice);
  return {scaled(std::move(a), factors), scaled(std::move(b), factors)};
}

Pair flat_and_turned(Dice& dice, double thickness) {
  const Pair pair = flat(dice, thickness);
  const Rotation turn = rotation(dice);
  return {turned(std::get<Points>(pair.a), turn), turned(std::get<Points>(pair.b), turn)};
}

/// Two needles through nearly the same point, each in a direction of its own.
Pair needles(Dice& dice, double thickness, double farthest) {
  const Vec factors(1, thickness, thickness);
  Points a = turned(scaled(points_in_ball(dice, 4), factors), rotation(dice));
  Points b = turned(scaled(points_in_ball(dice, 4), factors), rotation(dice));
  const Vec place = point_within(dice, a) + thickness * farthest * dice.in_ball();
  const Vec inner = point_within(dice, b);
  return {std::move(a), moved(std::move(b), place - inner)};
}

/// A small tetrahedron near a face of a large one.
Pair sizes(Dice& dice, double ratio, double farthest) {
  Points large = points_in_ball(dice, 4);
  Points small = scaled(points_in_ball(dice, 4), {ratio, ratio, ratio});
  const Vec place = point_within(dice, {large[0], large[1], large[2]}) + ratio * farthest * dice.in_ball();
  small = moved(std::move(small), place);
  if (dice.coin()) std::swap(large, small);
  return {std::move(large), std::move(small)};
}

// -- Places and units -------------------------------------------------------------------------------------------------

Pair offset(Dice& dice, double far) {
  const Vec by = far * dice.direction();
  Points a = moved(points_in_unit_cube(dice, 4), by);
  return {std::move(a), moved(points_in_unit_cube(dice, 4), by)};
}

Pair in_unit(Dice& dice, double unit) {
  const Vec factors(unit, unit, unit);
  Points a = scaled(points_in_unit_cube(dice, 4), factors);
  return {std::move(a), scaled(points_in_unit_cube(dice, 4), factors)};
}

std::string beyond_single_precision(int exponent) {
  if (exponent < -45) return "; all zero in single precision";
  if (exponent > 38) return "; all infinite in single precision";
  return "";
}

}  // namespace

std::vector<Family> extreme_families() {
  std::vector<Family> all;
  for (const int exponent : {-3, -6, -9}) {
    const std::string power = power_of_ten(exponent);
    const double thickness = std::stod(power);
    all.push_back(thrown("flat-" + power, "triangles and tetrahedra in the unit cube, flattened to z·" + power,
                         [=](Dice& dice) { return flat(dice, thickness); }));
    all.push_back(thrown("flat-" + power + "-turned", "as flat-" + power + ", both then turned alike, anyhow",
                         [=](Dice& dice) { return flat_and_turned(dice, thickness); }));
  }
  all.push_back(thrown("needles-1e6", "tetrahedra a million times as long as thick, near to each other somewhere",
                       [](Dice& dice) { return needles(dice, 1e-6, 2); }));
  for (const int exponent : {3, 6}) {
    const std::string power = power_of_ten(exponent);
    const double ratio = 1 / std::stod(power);
    all.push_back(thrown("sizes-" + power, "a tetrahedron near a face of one that is " + power + " times as large",
                         [=](Dice& dice) { return sizes(dice, ratio, 2); }));
  }
  for (const int exponent : {4, 8, 12}) {
    const std::string power = power_of_ten(exponent);
    const double far = std::stod(power);
    all.push_back(thrown("offset-" + power, "tetrahedra of size 1 at " + power + " from the origin, rounded there",
                         [=](Dice& dice) { return offset(dice, far); }));
  }
  for (const int exponent : {-100, -75, -50, -10, 10, 50, 75, 100}) {
    const std::string power = power_of_ten(exponent);
    const double unit = power_of_two_near_1e(exponent);
    all.push_back(thrown("scale-" + power,
                         "tetrahedra times the power of two next to " + power + beyond_single_precision(exponent),
                         [=](Dice& dice) { return in_unit(dice, unit); }));
  }
  return all;
}

}  // namespace walkthroughs::pairs
