/// Shapes at random places: what everyday queries look like.
#include "walkthroughs/pairs/families_recipes.hpp"

namespace walkthroughs::pairs {
namespace {

Pair in_one_cube(Dice& dice, int count) {
  Points a = points_in_unit_cube(dice, count);
  return {std::move(a), points_in_unit_cube(dice, count)};
}

/// Edges of 1/2 to 2, turned anyhow.
Points box(Dice& dice) {
  Vec half;
  for (double& extent : half) extent = dice.between(0.25, 1);
  Points corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? half[0] : -half[0], i & 2 ? half[1] : -half[1], i & 4 ? half[2] : -half[2]);
  return turned(corners, rotation(dice));
}

Pair boxes(Dice& dice) {
  Points a = box(dice);
  Points b = box(dice);
  return {std::move(a), moved(std::move(b), dice.between(0, 2.7) * dice.direction())};
}

Pair hulls(Dice& dice, int count, double farthest) {
  Points a = points_in_ball(dice, count);
  Points b = points_in_ball(dice, count);
  return {std::move(a), moved(std::move(b), dice.between(0, farthest) * dice.direction())};
}

}  // namespace

std::vector<Family> random_families() {
  return {
      thrown("triangles", "corners anywhere in the unit cube", [](Dice& dice) { return in_one_cube(dice, 3); }),
      thrown("tetrahedra", "corners anywhere in the unit cube", [](Dice& dice) { return in_one_cube(dice, 4); }),
      thrown("boxes", "edges of 1/2 to 2, turned anyhow, centers up to 2.7 apart", boxes),
      thrown("hulls-8", "8 points in a unit ball, centers up to 2 apart", [](Dice& dice) { return hulls(dice, 8, 2); }),
      thrown("hulls-32", "32 points in a unit ball, centers up to 3 apart",
             [](Dice& dice) { return hulls(dice, 32, 3); }),
      thrown("hulls-128", "128 points in a unit ball, centers up to 3.5 apart",
             [](Dice& dice) { return hulls(dice, 128, 3.5); }),
  };
}

}  // namespace walkthroughs::pairs
