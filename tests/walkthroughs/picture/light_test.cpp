// What of a round body gets how much light.

#include "walkthroughs/picture/light.hpp"

#include <numbers>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace light_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

TEST_CASE("The parts of a ball that get more light lie within each other, and their rims get just so much") {
  const Lens lens{render::Camera(35, 25)};
  const auto parts = lit_parts({"ball", Ball{Point::Zero(), 1}, {}}, lens);
  REQUIRE(parts.size() == light_steps.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(render::signed_area(parts[i]) > 0.1);
    if (i > 0) CHECK(render::signed_area(parts[i]) < render::signed_area(parts[i - 1]));
    for (const Vec2& p : parts[i]) {
      const double depth = std::sqrt(std::max(0.0, 1 - p.squaredNorm()));
      const Point outward =
          lens.camera->right() * p.x() + lens.camera->up() * p.y() + lens.camera->toward_viewer() * depth;
      const double light = light_on(outward, *lens.camera);
      CHECK(light > light_steps[i] - 1e-6);
      if (depth > 1e-3) CHECK(light < light_steps[i] + 1e-6);
    }
  }
}

TEST_CASE("A cap turned to the light gets it all at once") {
  const Lens lens{render::Camera(35, 25)};
  const Point axis = lens.camera->up() + lens.camera->toward_viewer();
  const double on_cap = light_on(axis, *lens.camera);
  const Object can{"can", Cylinder{Point::Zero(), axis, 1, 2}, {}};
  const auto parts = lit_parts(can, lens);
  for (std::size_t i = 0; i < parts.size(); ++i)
    CHECK((render::signed_area(parts[i]) > std::numbers::pi * 0.7) == (light_steps[i] < on_cap));
}

}  // namespace light_test
