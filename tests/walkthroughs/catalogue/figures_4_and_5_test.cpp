// Figures 4 and 5 as Sections 3.1.2 and 3.1.3 tell them.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace figures_4_and_5_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using walkthroughs::test::Told;

namespace {

const std::vector<Vec2> left_corners = {{3.75, 3.25},  {2, 3.75}, {-0.75, 4}, {-2.5, 3},
                                        {-2.25, 1.25}, {0, -1},   {3.5, -0.5}};
const std::vector<Vec2> right_corners = {{4.25, 4.5},  {0.75, 5}, {-1.5, 4.5}, {-1.25, 3.5},
                                         {-0.25, 2.5}, {3, 0.5},  {4, 3}};

/// Returns: the letters found, and behind each what is kept then, oldest first: "A:A E:AE G:EG".
std::string steps_of(const Told& told) {
  std::string steps, kept;
  for (const auto& event : told.trace.events) {
    if (const auto* e = std::get_if<gjk::SupportFound<double>>(&event)) {
      steps += kept + (steps.empty() ? "" : " ") + told.hull.name(e->vertex.w);
      kept.clear();
    }
    if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&event)) kept = ":" + told.names(e->simplex);
    if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event)) kept = ":" + told.names(e->after);
  }
  return steps + kept;
}

}  // namespace

TEST_CASE(
    "Both sets of Figures 4 and 5 are heptagons named A to G, counter-clockwise, and only the left holds the origin") {
  for (const auto& corners : {left_corners, right_corners}) {
    bool inside = true;
    for (std::size_t i = 0; i < 7; ++i) {
      const Vec2 side = corners[(i + 1) % 7] - corners[i];
      CHECK(cross(side, corners[(i + 2) % 7] - corners[i]) > 0);
      inside = inside && cross(side, -corners[i]) > 0;
    }
    CHECK(inside == (corners == left_corners));
  }
  for (const auto& [name, scene] : {std::pair("figure-4-left", 0u), {"figure-4", 0u}, {"figure-5", 0u}})
    CHECK(Told(name, scene).hull.corners == left_corners);
  for (const auto& [name, scene] : {std::pair("figure-4-right", 0u), {"figure-4", 1u}, {"figure-5", 1u}})
    CHECK(Told(name, scene).hull.corners == right_corners);
}

TEST_CASE("The searches of Figure 4 find the points that the report names, keep what it keeps, and end as it says") {
  const auto says = [](const char* name, const char* steps, gjk::Reason reason) {
    INFO(name);
    const Told told(name);
    CHECK(steps_of(told) == steps);
    CHECK(told.result().reason == reason);
  };
  says("figure-4-left", "A:A E:AE G:EG F:EGF", gjk::Reason::simplex_contains_origin);
  says("figure-4-right", "A:A E", gjk::Reason::origin_not_crossed);
  says("figure-4-right-no-crossing-test", "A:A E:AE F:EF E", gjk::Reason::no_new_vertex);
}

}  // namespace figures_4_and_5_test
