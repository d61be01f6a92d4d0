#include "walkthroughs/pairs/families_recipes.hpp"

namespace walkthroughs::pairs {

Family thrown(std::string name, std::string what, std::function<Pair(Dice&)> recipe) {
  auto make = [name, recipe = std::move(recipe)](std::uint64_t seed, std::uint64_t index) {
    Dice dice(seed, name, index);
    return recipe(dice);
  };
  return {std::move(name), std::move(what), {}, std::move(make)};
}

Points points_in_unit_cube(Dice& dice, int count) {
  Points points(static_cast<std::size_t>(count));
  for (Vec& p : points)
    for (double& coordinate : p) coordinate = dice.unit();
  return points;
}

Points points_in_ball(Dice& dice, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(dice.in_ball());
  return points;
}

Points moved(Points points, const Vec& by) {
  for (Vec& p : points) p += by;
  return points;
}

Points scaled(Points points, const Vec& factors) {
  for (Vec& p : points) p = p.cwiseProduct(factors);
  return points;
}

Rotation rotation(Dice& dice) {
  const Vec x = dice.direction();
  const Vec other = dice.direction();
  const Vec across = x.cross(other);
  if (across.squaredNorm() < 0.01) return rotation(dice);
  const Vec y = across / std::sqrt(across.squaredNorm());
  Rotation frame;
  frame << x, y, x.cross(y);
  return frame;
}

Points turned(Points points, const Rotation& rotation) {
  for (Vec& p : points) p = rotation.col(0) * p[0] + rotation.col(1) * p[1] + rotation.col(2) * p[2];
  return points;
}

Vec point_within(Dice& dice, const Points& points) {
  Vec sum = Vec::Zero();
  double total = 0;
  for (const Vec& p : points) {
    const double weight = dice.unit();
    sum += weight * p;
    total += weight;
  }
  return sum / total;
}

double power_of_two_near_1e(int exponent) {
  constexpr double binary_digits = 3.321928094887362;  // of a decimal one: log2(10)
  return std::ldexp(1.0, static_cast<int>(std::lround(exponent * binary_digits)));
}

}  // namespace walkthroughs::pairs
