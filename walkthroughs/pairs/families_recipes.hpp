/// How families are made: each list below is one part of the list of all.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "walkthroughs/pairs/dice.hpp"
#include "walkthroughs/pairs/family.hpp"

namespace walkthroughs::pairs {

/// A family whose pairs are thrown with dice of their own.
Family thrown(std::string name, std::string what, std::function<Pair(Dice&)> recipe);

std::vector<Family> random_families();
std::vector<Family> touching_families();
std::vector<Family> extreme_families();
std::vector<Family> listed_families();
std::vector<Family> round_families();

// -- What recipes share -----------------------------------------------------------------------------------------------

/// `count` points, all places of the unit cube alike.
Points points_in_unit_cube(Dice& dice, int count);

/// `count` points, all places of the ball of radius 1 alike.
Points points_in_ball(Dice& dice, int count);

Points moved(Points points, const Vec& by);
Points scaled(Points points, const Vec& factors);

/// Turned about the origin by a random rotation, all alike.
using Rotation = Eigen::Matrix3d;
Rotation rotation(Dice& dice);
Points turned(Points points, const Rotation& rotation);

/// Returns: a random point of the hull.
Vec point_within(Dice& dice, const Points& points);

/// 10^exponent as the nearest power of two, so that a product with it is exact.
double power_of_two_near_1e(int exponent);

}  // namespace walkthroughs::pairs
