/// Balls and cylinders, anywhere and with a stated gap.
#include <array>
#include <cmath>
#include <string>

#include "walkthroughs/pairs/families_recipes.hpp"

namespace walkthroughs::pairs {
namespace {

Vec unit_vector(int axis) { return Vec::Unit(axis); }

// -- Balls ------------------------------------------------------------------------------------------------------------

/// Two balls, their centers `distance` times the sum of the radii apart.
Pair balls(Dice& dice, double distance) {
  const Ball a{dice.in_cube(1), dice.between(0.25, 1)};
  const double radius = dice.between(0.25, 1);
  const Vec center = a.center + distance * (a.radius + radius) * dice.direction();
  return {a, Ball{center, radius}};
}

// -- Cylinders --------------------------------------------------------------------------------------------------------

Can can(Dice& dice, const Vec& center, int axis) {
  const double radius = dice.between(0.25, 1);
  return {center, dice.sign() * unit_vector(axis), radius, dice.between(0.5, 2)};
}

Pair cans(Dice& dice) {
  const Can a = can(dice, dice.in_cube(1), dice.whole(0, 2));
  const Vec center = a.center + dice.between(0, 2.6) * dice.direction();
  return {a, can(dice, center, dice.whole(0, 2))};
}

/// Parallel axes, the curved sides `distance` times the sum of the radii apart, seen from axis to axis.
Vec side_by_side(Dice& dice, const Can& a, const Can& b, int axis, double distance) {
  const double angle_sine = dice.between(-1, 1), angle_cosine = dice.sign() * std::sqrt(1 - angle_sine * angle_sine);
  const double apart = distance * (a.radius + b.radius);
  return 0.4 * (a.height + b.height) * dice.between(-1, 1) * unit_vector(axis) +
         apart * angle_cosine * unit_vector((axis + 1) % 3) + apart * angle_sine * unit_vector((axis + 2) % 3);
}

/// Parallel axes, one cap over the other.
Vec end_to_end(Dice& dice, const Can& a, const Can& b, int axis, double distance) {
  const double along = dice.sign() * distance * (a.height + b.height) / 2;
  const Vec across = 0.5 * (a.radius + b.radius) * dice.in_cube(1);
  Vec by = across;
  by[axis] = along;
  return by;
}

/// Half of a disc's chord, and how far the other cylinder's end is along the disc: 0 where it reaches across the axis.
struct Chord {
  double offset, half;
};

Chord chord(Dice& dice, double radius, double other_height) {
  const double offset = dice.sign() * dice.between(0, other_height / 2 + 0.8 * radius);
  const double short_by = std::max(0.0, std::abs(offset) - other_height / 2);
  return {offset, std::sqrt(radius * radius - short_by * short_by)};
}

/// Axes at right angles, sides or rims against each other.
Vec crossed(Dice& dice, const Can& a, const Can& b, int a_axis, int b_axis, double distance) {
  const Chord of_a = chord(dice, a.radius, b.height), of_b = chord(dice, b.radius, a.height);
  return of_a.offset * unit_vector(b_axis) + of_b.offset * unit_vector(a_axis) +
         dice.sign() * distance * (of_a.half + of_b.half) * unit_vector(3 - a_axis - b_axis);
}

/// Two cylinders, in one direction at `distance` times the distance at which they touch.
Pair cans_near_touching(Dice& dice, double distance) {
  const int axis = dice.whole(0, 2), kind = dice.whole(0, 2);
  const int other_axis = kind == 2 ? (axis + dice.whole(1, 2)) % 3 : axis;
  const Can a = can(dice, dice.in_cube(1), axis);
  Can b = can(dice, a.center, other_axis);
  if (kind == 0) b.center += side_by_side(dice, a, b, axis, distance);
  if (kind == 1) b.center += end_to_end(dice, a, b, axis, distance);
  if (kind == 2) b.center += crossed(dice, a, b, axis, other_axis, distance);
  return {a, b};
}

}  // namespace

std::vector<Family> round_families() {
  std::vector<Family> all{thrown("spheres", "centers up to twice the sum of the radii apart",
                                 [](Dice& dice) { return balls(dice, dice.between(0, 2)); })};
  const std::array<std::string, 4> gaps{"1e-3", "1e-6", "1e-9", "1e-12"};
  for (const std::string& gap : gaps) {
    const double g = std::stod(gap);
    all.push_back(thrown("spheres-gap-" + gap, "gap or depth of " + gap + " of the sum of the radii",
                         [=](Dice& dice) { return balls(dice, 1 + g * dice.sign()); }));
  }
  all.push_back(thrown("cylinders", "axes parallel to coordinate axes, centers up to 2.6 apart", cans));
  for (const std::string& gap : gaps) {
    const double g = std::stod(gap);
    all.push_back(thrown("cylinders-gap-" + gap,
                         "side, end or rim against another: gap or depth of " + gap + " of the distance of touching",
                         [=](Dice& dice) { return cans_near_touching(dice, 1 + g * dice.sign()); }));
  }
  return all;
}

}  // namespace walkthroughs::pairs
