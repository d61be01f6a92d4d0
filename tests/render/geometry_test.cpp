#include "render/geometry.hpp"

#include <utility>

#include "tests/catch.hpp"

using namespace render;

namespace {
const Box box{{10, 20}, {30, 40}};
}

TEST_CASE("a segment is clipped on both sides of a box, whichever way it runs") {
  for (const auto& [from, to] : {std::pair{Vec2(0, 30), Vec2(40, 30)}, std::pair{Vec2(20, 10), Vec2(20, 50)},
                                 std::pair{Vec2(40, 30), Vec2(0, 30)}}) {
    const auto inside = clip_segment(from, to, box);
    REQUIRE(inside);
    REQUIRE(inside->from == Approx(0.25));
    REQUIRE(inside->to == Approx(0.75));
  }
}

TEST_CASE("a segment inside a box stays whole, also without length") {
  const auto whole = clip_segment({15, 25}, {25, 38}, box);
  REQUIRE(whole);
  REQUIRE(whole->from == 0);
  REQUIRE(whole->to == 1);
  REQUIRE(clip_segment({15, 25}, {15, 25}, box));
}

TEST_CASE("a segment beside a box, past its corner or short of it is outside") {
  REQUIRE_FALSE(clip_segment({0, 45}, {40, 45}, box));
  REQUIRE_FALSE(clip_segment({0, 15}, {9, 30}, box));
  REQUIRE_FALSE(clip_segment({0, 30}, {9, 30}, box));
  REQUIRE_FALSE(clip_segment({25, 14.8}, {35, 24.8}, box));  // past the corner (30,20)
  REQUIRE(clip_segment({24.8, 15}, {34.8, 25}, box).has_value());
}

TEST_CASE("boxes overlap only where they share area") {
  REQUIRE(box.overlaps({{29, 39}, {50, 50}}));
  REQUIRE_FALSE(box.overlaps({{30, 20}, {50, 40}}));
  REQUIRE_FALSE(box.overlaps({{10, 41}, {30, 50}}));
  REQUIRE(box.grown(2).overlaps({{31, 20}, {50, 40}}));
}
