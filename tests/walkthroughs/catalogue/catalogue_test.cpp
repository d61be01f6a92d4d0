#include "walkthroughs/catalogue/catalogue.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace catalogue_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

TEST_CASE("Names of walkthroughs are unique, and fit for a folder and a command line; each finds its own") {
  for (const Walkthrough& w : whole_catalogue()) {
    INFO(w.name);
    CHECK(std::ranges::count(whole_catalogue(), w.name, &Walkthrough::name) == 1);
    CHECK(w.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-/") == std::string::npos);
    CHECK(std::ranges::count(w.name, '/') <= 1);
    for (const char end : {'-', '/'}) CHECK_FALSE((w.name.starts_with(end) || w.name.ends_with(end)));
    CHECK(w.name.find("/-") == std::string::npos);
    CHECK(find_walkthrough(w.name) == &w);
    CHECK(find_walkthroughs(w.name) == std::vector{&w});
    CHECK(nearest_name(w.name) == w.name);
  }
  for (const char* unknown : {"", "regions", "figure-9", "figure-5 ", "Figure-5", "figure-55", "*"})
    CHECK(find_walkthrough(unknown) == nullptr);
}

TEST_CASE("The name of a folder stands for all walkthroughs in it, in their order") {
  for (const char* folder : {"regions", "regions/", "vehicle-and-threat"}) {
    const std::string start = std::string(folder) + (std::string_view(folder).ends_with('/') ? "" : "/");
    std::vector<const Walkthrough*> expected;
    for (const Walkthrough& w : whole_catalogue())
      if (w.name.starts_with(start)) expected.push_back(&w);
    CHECK(expected.size() > 1);
    CHECK(find_walkthroughs(folder) == expected);
  }
  for (const char* unknown : {"", "/", "region", "regions/1", "vehicle", "figure-4-left/"})
    CHECK(find_walkthroughs(unknown).empty());
}

TEST_CASE("The nearest name is the one with the fewest letters to insert, delete or replace") {
  CHECK(nearest_name("figure-4-lef") == "figure-4-left");
  CHECK(nearest_name("figure-4-rigth") == "figure-4-right");
  CHECK(nearest_name("4-right") == "figure-4-right");
  CHECK(nearest_name("figure-4-right-no-crosing-tests") == "figure-4-right-no-crossing-test");
  CHECK(nearest_name("Figure_5") == "figure-5");
  CHECK(nearest_name("figure-6-left") == "figure-4-left");
  CHECK(nearest_name("cycle-seperated") == "cycle-separated");
  CHECK(nearest_name("regions/2-simplex-r8") == "regions/2-simplex-r3");
  CHECK(nearest_name("figure-4-") == "figure-4-left");  // what begins so goes first
}

TEST_CASE("A walkthrough has one scene, or two to compare, of different names and diagrams have none") {
  for (const Walkthrough& w : whole_catalogue()) {
    INFO(w.name);
    const std::size_t scenes = w.layout == Layout::search ? 1 : w.layout == Layout::diagrams ? 0 : 2;
    REQUIRE(w.scenes.size() == scenes);
    CHECK(static_cast<bool>(w.diagrams) == (w.layout == Layout::diagrams));
    CHECK(w.close_up.has_value() == (w.layout == Layout::close_ups));
    for (const Scene& scene : w.scenes) {
      CHECK_FALSE(scene.name.empty());
      if (w.naming == Naming::corners)  // which need a planar hull that has them
        CHECK((scene.dimension == Dimension::plane && difference_hull(scene).corners.size() >= 3));
    }
    if (scenes == 2) CHECK(w.scenes[0].name != w.scenes[1].name);
  }
}

}  // namespace catalogue_test
