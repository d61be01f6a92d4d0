#include "walkthroughs/pairs/graded.hpp"

#include <cmath>
#include <map>

#include "tests/kit/catch.hpp"
#include "walkthroughs/judge/how_far.hpp"

namespace walkthroughs::judge {
namespace graded_test {

TEST_CASE("Graded: gaps and depths of every power of ten, as far as doubles tell") {
  for (const Family& family : graded_families()) {
    INFO(family.name);
    std::map<int, int> gaps, depths;  // by the power of ten
    for (std::uint64_t i = 0; i < 320; ++i) {
      const PointPair pair = *points_of(family.make(1, i));
      const Case made{"", "", pair, truth_of(pair)};
      const HowFar far = how_far(made, false);
      if (far.relative > 0) ++(made.meet() ? depths : gaps)[static_cast<int>(std::floor(std::log10(far.relative)))];
    }
    for (int power = -14; power <= -2; ++power) {
      INFO(power);
      CHECK(gaps[power] + gaps[power - 1] > 0);
      CHECK(depths[power] + depths[power - 1] > 0);
    }
  }
}

TEST_CASE("Graded: the nearest point is where one would look for it") {
  CHECK(nearest_point({{{0, 0, 0}, {1, 0, 0}}, {{3, 1, 0}, {3, -1, 0}}}) == Vec(-2, 0, 0));
  CHECK(nearest_point({{{0, 0, 0}}, {{0, 0, 0}}}) == Vec(0, 0, 0));
}

}  // namespace graded_test
}  // namespace walkthroughs::judge
