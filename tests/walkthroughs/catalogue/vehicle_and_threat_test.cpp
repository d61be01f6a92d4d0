// The report's own motive: what the names of the walkthroughs promise is what the search answers.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

gjk::Status answer(const std::string& name) { return Told("vehicle-and-threat/" + name).result().status; }

}  // namespace

TEST_CASE("A hit is an intersection") {
  CHECK(answer("vehicle-hit") == gjk::Status::intersecting);
  CHECK(answer("counter-munition-hit") == gjk::Status::intersecting);
}

TEST_CASE("A near miss is none, and has a direction to prove it") {
  for (const std::string name : {"vehicle-near-miss", "counter-munition-near-miss"}) {
    CHECK(answer(name) == gjk::Status::separated);
    const auto proof = Told("vehicle-and-threat/" + name).result().separation;
    REQUIRE(proof);
    CHECK(proof->support_value < 0);
  }
}

TEST_CASE("Vehicle, threat and counter-munition stand in space and each is always the same body") {
  for (const Walkthrough* w : find_walkthroughs("vehicle-and-threat")) {
    INFO(w->name);
    const Scene& scene = w->scenes.at(0);
    CHECK(scene.dimension == Dimension::space);
    for (const Object* object : {&scene.a, &scene.b}) {
      if (object->name == "vehicle") CHECK(std::get<Points>(object->form).size() == 10);
      if (object->name == "threat") CHECK(std::get<Cylinder>(object->form).radius == 0.25);
      if (object->name == "counter-munition") CHECK(std::get<Ball>(object->form).radius == 0.4);
    }
  }
}
