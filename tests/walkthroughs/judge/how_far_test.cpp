#include "walkthroughs/judge/how_far.hpp"

#include <cmath>
#include <limits>

#include "tests/kit/catch.hpp"
#include "walkthroughs/pairs/families.hpp"

namespace walkthroughs::judge {
namespace how_far_test {

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

TEST_CASE("How far: a length relative to the size is finite, also where the length or the size is beyond doubles") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK(relative_to_size(2, {{{0, 0, 0}}, {{3, 4, 0}}}) == Approx(0.4));
  CHECK(relative_to_size(most, {{{-most, 0, 0}}, {{most, 0, 0}}}) == Approx(0.5));
  CHECK(relative_to_size(2 * least, {{{0, 0, 0}}, {{4 * least, 0, 0}}}) == Approx(0.5));
  CHECK(relative_to_size(most, {{{0, 0, 0}}, {{least, 0, 0}}}) == most);
  CHECK(relative_to_size(least, {{{0, 0, 0}}, {{most, 0, 0}}}) < 1e-300);
  CHECK(relative_to_size(least, {{{most, 0, 0}}, {{most, least, 0}}}) == 0);  // which is all that can be said
}

/// Below the plane w = 0 of a frame along none of the axes, of whole numbers; 49 of its points in that plane.
Points many_below(double sign) {
  Points points;
  for (int u = -3; u <= 3; ++u)
    for (int v = -3; v <= 3; ++v)
      for (const int w : {0, -1}) points.push_back(u * Vec(1, 2, 2) + v * Vec(2, 1, -2) + sign * w * Vec(2, -2, 1));
  return points;
}

TEST_CASE("Contact of sets of many points is decided exactly, too") {
  const Points below = many_below(1);
  Points above = many_below(-1);
  CHECK(only_touch({below, above}, false));
  CHECK(only_touch({below, {Vec(1, 2, 2)}}, false));  // a point that it has, inside a face
  CHECK(only_touch({below, {Vec(0.5, 1, 1)}}, false));
  for (Vec& p : above) p += 0x1p-40 * Vec(-2, 2, -1);
  CHECK_FALSE(only_touch({below, above}, false));
  CHECK_FALSE(only_touch({below, {-0x1p-40 * Vec(2, -2, 1)}}, false));
}

TEST_CASE("Contact in the plane and of lines is decided in all ways that two sets can touch") {
  const Points square{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, segment{{1, 1, 0}, {1, 3, 0}};
  CHECK_FALSE(only_touch({square, segment}, true));
  CHECK(only_touch({square, segment}, false));
  CHECK(only_touch({square, {{2, 2, 0}, {3, 0, 0}, {3, 2, 0}}}, true));  // a point of both
  CHECK_FALSE(only_touch({square, {{2, 2, 0}, {3, 0, 0}, {0, 1, 0}}}, true));
  CHECK(only_touch({square, {{2, 2, 0}}}, true));
  const Points tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(only_touch({tetrahedron, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, -1}}}, false));  // a point of both
  CHECK_FALSE(only_touch({tetrahedron, {{0, 0, 0}, {-1, -1, -1}, {1, 1, 2}}}, false));
}

TEST_CASE("Inside: all of one lies in the interior of the other, by one unit in the last place") {
  const Points outer = box({0, 0, 0}, {4, 4, 4});
  const auto inside = [&](const Points& inner, bool in_plane = false) {
    const bool is_inside = one_is_inside({inner, outer}, in_plane);
    CHECK(one_is_inside({outer, inner}, in_plane) == is_inside);
    return is_inside;
  };
  CHECK(inside(box({1, 1, 1}, {3, 3, 3})));
  CHECK(inside(box({1, 1, 1}, {3, 3, std::nextafter(4.0, 0)})));
  CHECK_FALSE(inside(box({1, 1, 1}, {3, 3, 4})));
  CHECK_FALSE(inside(box({1, 1, 1}, {3, 3, 5})));
  CHECK_FALSE(inside(box({5, 5, 5}, {6, 6, 6})));
  CHECK_FALSE(inside(outer));
  CHECK(inside({{2, 2, 2}}));
  CHECK(inside({{0x1p-1000, 1, 1}}));
  const Points square{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}, triangle{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  CHECK(one_is_inside({square, triangle}, true));
  CHECK_FALSE(one_is_inside({square, triangle}, false));  // which has no interior
  CHECK_FALSE(one_is_inside({square, {{1, 1, 0}, {2, 0, 0}}}, true));
  // Of many points, of which the one inside is one, too.
  Points many = many_below(1);
  many.push_back(-0x1p-40 * Vec(2, -2, 1));
  CHECK(one_is_inside({many, {many.back()}}, false));
  CHECK_FALSE(one_is_inside({many, {many.back(), Vec(1, 2, 2)}}, false));
}

}  // namespace how_far_test
}  // namespace walkthroughs::judge
