#include "walkthroughs/picture/inset.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using render::Box;
using render::Vec2;
using render::View;

namespace {

const Box room{{100, 100}, {500, 400}};
/// Ten page units for each unit of the scene, its zero in the middle.
const View view = View::fit({-10, -10}, {10, 10}, room, 10);
const Segment level{{-10, 0}, {10, 0}};

std::optional<Inset> inset(const Vec2& at, const std::vector<Segment>& lines, bool is_wanted = false) {
  return inset_of(at, lines, lines, room, view, is_wanted);
}

}  // namespace

TEST_CASE("What stands so near to a line that its mark covers the side is magnified until it is plain") {
  for (const double distance : {1e-9, 0.001, 0.1, 1.0, 1.7}) {
    INFO(distance);
    const std::optional<Inset> found = inset({3, distance}, {level});
    REQUIRE(found);
    CHECK(found->at == Vec2(3, distance));
    CHECK(found->factor * distance * view.scale() >= 18);
    CHECK(round_factor(found->factor) == found->factor);
  }
  CHECK_FALSE(inset({3, 1.9}, {level}));
  CHECK_FALSE(inset({3, 0}, {level}));  // which no magnification tells from the line
}

TEST_CASE("Two vertices whose marks cover each other are magnified until they stand apart") {
  const Segment near{{4, 4}, {4.5, 4}};
  const std::optional<Inset> found = inset({3, -8}, {level, near});
  REQUIRE(found);
  CHECK(found->at == Vec2(4.25, 4));
  CHECK(found->factor * 0.5 * view.scale() >= 30);
  CHECK_FALSE(inset({3, -8}, {level, {{4, 4}, {5.5, 4}}}));
  CHECK_FALSE(inset({3, -8}, {level, {{4, 4}, {4, 4}}}));
}

TEST_CASE("Where it is wanted, what is around the origin is magnified, and the nearest line stays in sight") {
  for (const double distance : {2.0, 5.0, 9.0}) {
    const std::optional<Inset> found = inset({3, distance}, {level}, true);
    REQUIRE(found);
    CHECK(found->at == Vec2(3, distance));
    CHECK(found->factor >= 2);
    CHECK((found->factor == 2 || found->factor * distance * view.scale() <= 46));  // half the frame
  }
  CHECK_FALSE(inset({3, 5}, {}, true));
}

TEST_CASE("An inset stands in a corner of the room, away from what it shows") {
  const Box low_left = inset({8, 0.5}, {{{0, 0}, {10, 0}}, {{0, 0}, {0, 10}}})->frame;
  CHECK(low_left.min.x() < 150);
  const std::optional<Inset> found = inset({-8, 0.5}, {{{-10, 0}, {-4, 0}}});
  CHECK(found->frame.min.x() > 300);
  CHECK((found->frame.min.array() >= room.min.array()).all());
  CHECK((found->frame.max.array() <= room.max.array()).all());
}
