#include "walkthroughs/judge/how_far.hpp"

#include <cmath>

#include "tests/kit/catch.hpp"
#include "walkthroughs/pairs/families.hpp"

namespace walkthroughs::judge {
namespace {

Case case_of(Points a, Points b) {
  Case made{"pair", "pairs", {std::move(a), std::move(b)}, {}};
  made.truth = truth_of(made.pair);
  return made;
}

Points box(const Vec& low, const Vec& high) {
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return corners;
}

TEST_CASE("How far: boxes apart by their gap, and in each other by the least of three overlaps") {
  const Points unit = box({0, 0, 0}, {1, 1, 1});
  const HowFar apart = how_far(case_of(unit, box({3, 0.5, 0.25}, {4, 1.5, 1.25})), false);
  CHECK(apart.length == 2);
  CHECK(apart.relative == Approx(2 / std::sqrt(16 + 2.25 + 1.5625)));
  CHECK_FALSE(apart.is_bound);
  const HowFar inside = how_far(case_of(unit, box({0.75, 0.5, 0.125}, {1.75, 1.5, 1.125})), false);
  CHECK(inside.length == Approx(0.25));
  CHECK_FALSE(inside.is_bound);
}

TEST_CASE("How far: in the plane nothing is moved out of it") {
  const Points triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, other{{1, 1, 0}, {5, 1, 0}, {1, 5, 0}};
  CHECK(how_far(case_of(triangle, other), true).length == Approx(std::sqrt(2.0)));
  CHECK(how_far(case_of(triangle, other), false).length == 0);  // each is flat: z parts them at once
}

TEST_CASE("How far: scales and places do not change what is relative, and of many points it is a bound") {
  const Case near = case_of(box({0, 0, 0}, {1, 1, 1}), box({0.75, 0.5, 0.125}, {1.75, 1.5, 1.125}));
  for (const double scale : {0x1p-300, 0x1p300}) {
    Case scaled = near;
    for (Points* const set : {&scaled.pair.a, &scaled.pair.b})
      for (Vec& p : *set) p *= scale;
    CHECK(how_far(scaled, false).relative == Approx(how_far(near, false).relative));
  }
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto pair = points_of(family_named("hulls-32").make(1, i));
    const Case many{"", "", *pair, truth_of(*pair)};
    if (!many.meet()) continue;
    const HowFar bound = how_far(many, false);
    CHECK(bound.is_bound);
    CHECK(bound.length >= 0);
    CHECK(bound.relative < 0.5);
  }
}

TEST_CASE("Contact is decided exactly: all that touch do, and by one unit in the last place they do not") {
  for (const char* const name : {"touching-vertex", "touching-edge", "touching-face", "touching-vertex-askew",
                                 "touching-edge-askew", "touching-face-askew"})
    for (std::uint64_t i = 0; i < 50; ++i) {
      INFO(name << " " << i);
      CHECK(only_touch(*points_of(family_named(name).make(1, i)), false));
    }
  for (const char* const name : {"one-ulp", "one-ulp-askew"})
    for (std::uint64_t i = 0; i < 50; ++i) {
      const PointPair pair = *points_of(family_named(name).make(1, i));
      INFO(name << " " << i);
      if (truth_of(pair) == gjk::Status::intersecting) CHECK_FALSE(only_touch(pair, false));
    }
  CHECK(only_touch({{{1, 2, 3}}, {{1, 2, 3}}}, false));
  CHECK(only_touch({{{0, 0, 0}, {1, 1, 1}}, {{-1, -1, -1}, {0.5, 0.5, 0.5}}}, false));  // along one line
}

}  // namespace
}  // namespace walkthroughs::judge
