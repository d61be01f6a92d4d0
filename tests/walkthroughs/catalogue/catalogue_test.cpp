#include "walkthroughs/catalogue/catalogue.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const Walkthrough& w : catalogue()) list.push_back(w.name);
  return list;
}

}  // namespace

TEST_CASE(
    "The catalogue has the figures in the order of the report, then the regions, then what goes wrong, then mistakes") {
  std::vector<std::string> outside_of_folders = names();
  std::erase_if(outside_of_folders,
                [](const std::string& name) { return name.starts_with("regions/") || name.starts_with("mistakes/"); });
  CHECK(names().back().starts_with("mistakes/m21-"));
  CHECK(outside_of_folders == std::vector<std::string>{"figure-1",
                                                       "figure-2",
                                                       "figure-3",
                                                       "figure-4",
                                                       "figure-4-left",
                                                       "figure-4-right",
                                                       "figure-4-right-no-crossing-test",
                                                       "figure-5",
                                                       "figure-6",
                                                       "figure-7",
                                                       "figure-8",
                                                       "vehicle-and-threat/vehicle-hit",
                                                       "vehicle-and-threat/vehicle-near-miss",
                                                       "vehicle-and-threat/counter-munition-hit",
                                                       "vehicle-and-threat/counter-munition-near-miss",
                                                       "cycle-separated",
                                                       "cycle-intersecting",
                                                       "complete/cycle-separated",
                                                       "complete/cycle-intersecting",
                                                       "complete/beside-the-report",
                                                       "as-printed-spheres",
                                                       "eager-between-centers",
                                                       "failures/vanished-product",
                                                       "failures/overflowed-product",
                                                       "failures/beyond-an-edge",
                                                       "failures/coplanar-askew",
                                                       "failures/far-from-the-origin",
                                                       "certified/separation",
                                                       "certified/tetrahedron",
                                                       "certified/touching",
                                                       "certified/one-step-apart",
                                                       "certified/vanished-product",
                                                       "certified/overflowed-product",
                                                       "certified/beyond-an-edge",
                                                       "certified/coplanar-askew",
                                                       "certified/far-from-the-origin",
                                                       "certified/cycle-separated",
                                                       "certified/cycle-intersecting"});
  std::string simplices;  // of the regions, by their dimension
  for (const Walkthrough* w : find_walkthroughs("regions")) simplices += w->name.at(std::string("regions/").size());
  CHECK(std::ranges::is_sorted(simplices));
  CHECK(simplices.find_first_not_of("0123") == std::string::npos);
}

TEST_CASE("Names of walkthroughs are unique, and fit for a folder and a command line") {
  const std::vector<std::string> list = names();
  for (const std::string& name : list) {
    INFO(name);
    CHECK(std::ranges::count(list, name) == 1);
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-/") == std::string::npos);
    CHECK(std::ranges::count(name, '/') <= 1);
    for (const char end : {'-', '/'}) {
      CHECK_FALSE(name.starts_with(end));
      CHECK_FALSE(name.ends_with(end));
    }
    CHECK(name.find("/-") == std::string::npos);
  }
}

TEST_CASE("Title, source and summary of a walkthrough are one line each") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    for (const std::string& text : {w.title, w.source, w.summary}) {
      CHECK_FALSE(text.empty());
      CHECK(text.find('\n') == std::string::npos);
    }
    CHECK(std::ranges::any_of(std::vector{"Section ", "Sections ", "Algorithm "},
                              [&](const std::string& part) { return w.source.starts_with("ARL-TR-7474, " + part); }));
  }
}

TEST_CASE("A walkthrough has one scene, or two to compare, of different names and diagrams have none") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    const std::size_t scenes = w.layout == Layout::search ? 1 : w.layout == Layout::diagrams ? 0 : 2;
    REQUIRE(w.scenes.size() == scenes);
    CHECK(static_cast<bool>(w.diagrams) == (w.layout == Layout::diagrams));
    CHECK(w.close_up.has_value() == (w.layout == Layout::close_ups));
    for (const Scene& scene : w.scenes) CHECK_FALSE(scene.name.empty());
    if (scenes == 2) CHECK(w.scenes[0].name != w.scenes[1].name);
  }
}

TEST_CASE("The scenes of Figures 4 and 5 are the left set and the right set") {
  for (const char* both : {"figure-4", "figure-5"}) {
    CHECK(walkthrough(both).scenes.at(0).name == "left");
    CHECK(walkthrough(both).scenes.at(1).name == "right");
  }
  CHECK(walkthrough("figure-4-left").scenes.at(0).name == "left");
  for (const char* right : {"figure-4-right", "figure-4-right-no-crossing-test"})
    CHECK(walkthrough(right).scenes.at(0).name == "right");
}

TEST_CASE("Vertices are called by corners only where there is a planar hull that has them") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    if (w.naming != Naming::corners) continue;
    for (const Scene& scene : w.scenes) {
      CHECK(scene.dimension == Dimension::plane);
      CHECK(difference_hull(scene).corners.size() >= 3);
    }
  }
}

TEST_CASE("A walkthrough is found by its exact name only") {
  for (const Walkthrough& w : catalogue()) CHECK(find_walkthrough(w.name) == &w);
  for (const char* unknown : {"", "regions", "figure-9", "figure-5 ", "Figure-5", "figure-55", "*"})
    CHECK(find_walkthrough(unknown) == nullptr);
}

TEST_CASE("The name of a folder stands for all walkthroughs in it, a walkthrough's own name for itself") {
  for (const char* folder : {"regions", "regions/", "vehicle-and-threat"}) {
    const std::string start = std::string(folder) + (std::string_view(folder).ends_with('/') ? "" : "/");
    std::vector<const Walkthrough*> expected;
    for (const Walkthrough& w : catalogue())
      if (w.name.starts_with(start)) expected.push_back(&w);
    CHECK(expected.size() > 1);
    CHECK(find_walkthroughs(folder) == expected);
  }
  for (const Walkthrough& w : catalogue()) CHECK(find_walkthroughs(w.name) == std::vector{&w});
  for (const char* unknown : {"", "/", "region", "regions/1", "vehicle", "figure-4-left/"})
    CHECK(find_walkthroughs(unknown).empty());
}

TEST_CASE("The nearest name is the one with the fewest letters to insert, delete or replace") {
  for (const Walkthrough& w : catalogue()) CHECK(nearest_name(w.name) == w.name);
  CHECK(nearest_name("figure-4-lef") == "figure-4-left");
  CHECK(nearest_name("figure-4-rigth") == "figure-4-right");
  CHECK(nearest_name("4-right") == "figure-4-right");
  CHECK(nearest_name("figure-4-right-no-crosing-tests") == "figure-4-right-no-crossing-test");
  CHECK(nearest_name("figure5") == "figure-5");
  CHECK(nearest_name("Figure_5") == "figure-5");
  CHECK(nearest_name("figure-6-left") == "figure-4-left");
  CHECK(nearest_name("cycle-seperated") == "cycle-separated");
  CHECK(nearest_name("regions/2-simplex-r8") == "regions/2-simplex-r3");
  CHECK(nearest_name("figure-4-") == "figure-4-left");  // what begins so goes first
}
