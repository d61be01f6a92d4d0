#include "tests/bench/peers/match.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace peers {
namespace {

/// Points on a sphere: each is a corner, so that no library can make the scan shorter by leaving some out.
study::Points points_on_unit_sphere(study::Dice& dice, int count) {
  study::Points points;
  for (int i = 0; i < count; ++i) points.push_back(dice.direction());
  return points;
}

study::Family hulls(int count) {
  const std::string name = "hulls-" + std::to_string(count) + "-all-corners";
  const auto make = [=](std::uint64_t seed, std::uint64_t index) {
    study::Dice dice(seed, name, index);
    study::Points a = points_on_unit_sphere(dice, count), b = points_on_unit_sphere(dice, count);
    const study::Vec apart = dice.between(0, 3.5) * dice.direction();
    for (study::Vec& point : b) point += apart;
    return study::Pair{std::move(a), std::move(b)};
  };
  return {name, std::to_string(count) + " points on a unit sphere, centers up to 3.5 apart", std::nullopt, make};
}

}  // namespace

std::vector<study::Family> everyday_families() {
  return {study::family_named("triangles"), study::family_named("tetrahedra"), study::family_named("boxes"), hulls(32),
          hulls(256)};
}

std::vector<study::Family> hard_families() {
  std::vector<study::Family> hard;
  for (const study::Family& family : study::families())
    if (family.name != "triangles" && family.name != "tetrahedra" && family.name != "boxes") hard.push_back(family);
  return hard;
}

}  // namespace peers
