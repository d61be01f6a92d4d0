#include "walkthroughs/picture/inset.hpp"

#include <cmath>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace inset_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using render::Box;
using render::Vec2;
using render::View;

namespace {

const Box room{{100, 100}, {500, 500}};
/// Ten page units for each unit of the scene, its zero in the middle.
const View view = View::fit({-10, -10}, {10, 10}, room, 10);
const Style style{render::themes::report};

std::optional<Inset> inset(const Surroundings& what, bool is_wanted = false) {
  return inset_of(what, room, view, is_wanted, style);
}

Surroundings beside(const Vec2& nearest, std::vector<Vec2> vertices = {}) {
  return {Vec2::Zero(), {{nearest, nearest.stableNorm()}}, std::move(vertices), {}, {{Vec2::Zero(), nearest}}};
}

/// Returns: where a place, from the origin, stands in the inset, as parts of it from its middle: at most 1/2.
Vec2 in_frame(const Inset& inset, const Vec2& place) {
  const Vec2 size = inset.frame.max - inset.frame.min;
  return ((place - inset.at) * (inset.factor * view.scale())).cwiseQuotient(size);
}

}  // namespace

TEST_CASE("What is nearer to the origin than a mark is wide is magnified until both are seen, at any distance") {
  for (int e = 0; e <= 300; ++e) {
    const double distance = 1.3 * std::pow(10, -e);
    INFO(e);
    const Vec2 nearest(0.6 * distance, -0.8 * distance), vertex(-0.3 * distance, -0.4 * distance);
    const std::optional<Inset> found = inset(beside(nearest, {vertex, {3, 4}}));
    REQUIRE(found);
    const double seen = found->factor * distance * view.scale();
    CHECK((seen >= 25 && seen <= 76));
    for (const Vec2& place : {nearest, vertex, Vec2(0, 0)}) CHECK(in_frame(*found, place).cwiseAbs().maxCoeff() < 0.4);
    CHECK(round_factor(found->factor) == found->factor);
  }
  CHECK_FALSE(inset(beside({3, 1.5})));
  CHECK_FALSE(inset(beside({0, 0})));  // which no magnification tells from the origin
}

TEST_CASE("Of two that are near the nearer one is magnified, and one that is in the origin's place is not") {
  Surroundings what = beside({0, 0.5});
  what.nearest.push_back({{1e-9, 0}, 1e-9});
  what.nearest.push_back({{0, 0}, 0});
  CHECK(inset(what)->factor > 1e8);
}

TEST_CASE("In space the distance counts, also where it leads toward the viewer") {
  Surroundings what{Vec2::Zero(), {{{0, 0}, 0.001}}, {}, {}, {}};
  REQUIRE(inset(what));
  CHECK(inset(what)->at == Vec2(0, 0));
}

TEST_CASE("Two vertices whose marks cover each other are magnified until they stand apart") {
  const std::optional<Inset> found = inset(beside({0, 8}, {{4, 4}, {4.5, 4}, {-9, 0}}));
  REQUIRE(found);
  CHECK(found->at == Vec2(4.25, 4));
  CHECK(found->factor * 0.5 * view.scale() >= 25);
  CHECK_FALSE(inset(beside({0, 8}, {{4, 4}, {5.5, 4}})));
  CHECK_FALSE(inset(beside({0, 8}, {{4, 4}, {4, 4}})));
}

TEST_CASE("Where it is wanted, what is around the origin is magnified, and what is nearest stays in sight") {
  for (const double distance : {2.0, 5.0, 9.0}) {
    const std::optional<Inset> found = inset(beside({0, distance}), true);
    REQUIRE(found);
    CHECK(found->at == Vec2(0, 0));
    CHECK((found->factor == 2 || found->factor * distance * view.scale() <= 61));
  }
  CHECK_FALSE(inset({Vec2::Zero(), {}, {}, {}, {}}, true));
}

TEST_CASE("An inset stands in a corner of the room, away from what it shows") {
  for (const double side : {-1.0, 1.0}) {
    Surroundings what = beside({0, 0.5});
    what.origin = {8 * side, 0};
    what.shape = {{{2 * side, 0}, {9 * side, 0}}};
    const std::optional<Inset> found = inset(what);
    CHECK((found->frame.center().x() < 300) == (side > 0));
    CHECK((found->frame.min.array() >= room.min.array()).all());
    CHECK((found->frame.max.array() <= room.max.array()).all());
  }
}

TEST_CASE("An inset that would cover a vertex is smaller, or left out where the origin is seen without it") {
  const auto covered = [&](double distance) {  // vertices near all corners
    return inset(beside({0, distance}, {{-7, 7}, {7, 7}, {-7, -7}, {7, -7}}));
  };
  CHECK_FALSE(covered(1.3));
  CHECK(covered(0.01));
  Surroundings what = beside({0, 1.3});
  what.origin = {8, 0};
  const double whole = inset(what)->frame.width();
  what.vertices = {{-10, 3}, {-10, -3}};
  REQUIRE(inset(what));
  CHECK(inset(what)->frame.width() < whole);
}

TEST_CASE("A magnification is 1, 2 or 5 times a power of ten, and short in words") {
  CHECK(round_factor(4.9) == 2);
  CHECK(round_factor(5) == 5);
  CHECK(round_factor(1e300) == 1e300);
  CHECK(round_factor(9.9e22) == 5e22);
  CHECK(words_of_factor(500) == "×500");
  CHECK(words_of_factor(2e14) == "×2e14");
}

}  // namespace inset_test
