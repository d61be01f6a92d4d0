// The regions as pictures draw them: they tile the picture, and a point lies in the region of its nearest feature.

#include "walkthroughs/picture/region_picture.hpp"

#include <map>

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/catalogue/nearest_feature.hpp"
#include "tests/walkthroughs/polygons.hpp"

namespace region_picture_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;
using Polygon = std::vector<Vec2>;

namespace {

constexpr double half_side = 10;
const Polygon clip = {
    {-half_side, -half_side}, {half_side, -half_side}, {half_side, half_side}, {-half_side, half_side}};

Vec2 point_at_random(kit::Dice& dice, double limit) {
  const double x = dice.between(-limit, limit);
  return {x, dice.between(-limit, limit)};
}

std::string nearest_feature(const Polygon& newest_first, const Vec2& p) {
  Simplex simplex;
  for (std::size_t i = newest_first.size(); i-- > 0;) {
    gjk::Vertex<double> vertex;
    vertex.w = {newest_first[i].x(), newest_first[i].y(), 0};
    simplex.add(vertex);
  }
  return test::nearest_feature(simplex, {p.x(), p.y(), 0});
}

/// `number_of`: that of the region, from 1, in which a point belongs whose nearest feature is known.
template <class NumberOf>
void check_regions(kit::Dice& dice, const std::vector<Polygon>& regions, const Polygon& corners, NumberOf number_of) {
  double sum = 0;
  for (const Polygon& region : regions) sum += std::abs(area(region));
  CHECK(sum == Approx(area(clip)).epsilon(1e-9));
  for (int i = 0; i < 50; ++i) {
    const Vec2 p = point_at_random(dice, half_side);
    std::vector<int> found;
    for (std::size_t k = 0; k < regions.size(); ++k)
      if (holds(regions[k], p)) found.push_back(static_cast<int>(k) + 1);
    CHECK(found == std::vector<int>{number_of(nearest_feature(corners, p), p)});
  }
}

}  // namespace

TEST_CASE("The regions of a triangle tile the picture and a point lies in that of its nearest feature") {
  const std::map<std::string, int> numbers{{"ABC", 1}, {"A", 2}, {"AB", 3}, {"B", 4}, {"BC", 5}, {"C", 6}, {"AC", 7}};
  kit::Dice dice(2015);
  for (int round = 0; round < 200; ++round) {
    const Vec2 A = point_at_random(dice, 5), B = point_at_random(dice, 5), C = point_at_random(dice, 5);
    if (std::abs(cross(B - A, C - A)) < 0.5) continue;
    const std::vector<Polygon> regions = regions_of_triangle(A, B, C, {A, B, C}, clip);
    REQUIRE(regions.size() == 7);
    check_regions(dice, regions, {A, B, C},
                  [&](const std::string& nearest, const Vec2&) { return numbers.at(nearest); });
  }
}

TEST_CASE("The regions of a segment tile the picture and are numbered as in Fig. 6") {
  kit::Dice dice(7474);
  for (int round = 0; round < 200; ++round) {
    const Vec2 A = point_at_random(dice, 5), B = point_at_random(dice, 5);
    if ((B - A).norm() < 0.1) continue;
    const std::vector<Polygon> regions = regions_of_segment(A, B, A, clip);
    REQUIRE(regions.size() == 4);
    check_regions(dice, regions, {A, B}, [&](const std::string& nearest, const Vec2& p) {  // B was there first
      return nearest == "B" ? 1 : nearest == "A" ? 2 : cross(A - B, p - B) > 0 ? 3 : 4;
    });
  }
}

}  // namespace region_picture_test
