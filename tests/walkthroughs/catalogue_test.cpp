#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

TEST_CASE("The catalogue has the walkthroughs of Figures 4 and 5, in the order of the report") {
  std::vector<std::string> names;
  for (const Walkthrough& w : catalogue()) names.push_back(w.name);
  CHECK(names ==
        std::vector<std::string>{"figure-4-left", "figure-4-right", "figure-4-right-no-crossing-test", "figure-5"});
}

TEST_CASE("Names of walkthroughs are unique, and fit for a folder and a command line") {
  std::vector<std::string> names;
  for (const Walkthrough& w : catalogue()) names.push_back(w.name);
  for (const std::string& name : names) {
    CHECK(std::ranges::count(names, name) == 1);
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
    CHECK_FALSE(name.starts_with('-'));
  }
}

TEST_CASE("Title, source and summary of a walkthrough are one line each") {
  for (const Walkthrough& w : catalogue()) {
    for (const std::string& text : {w.title, w.source, w.summary}) {
      CHECK_FALSE(text.empty());
      CHECK(text.find('\n') == std::string::npos);
    }
    CHECK(w.source.starts_with("ARL-TR-7474, Section 3.1."));
  }
}

TEST_CASE("A walkthrough has one scene, or two to compare, of different names") {
  for (const Walkthrough& w : catalogue()) {
    CHECK(w.scenes.size() == (w.layout == Layout::close_ups ? 2 : 1));
    CHECK(w.scenes.front().name == (w.name.find("right") == std::string::npos ? "left" : "right"));
    if (w.scenes.size() == 2) CHECK(w.scenes.back().name == "right");
  }
}

TEST_CASE("A walkthrough is found by its exact name only") {
  for (const Walkthrough& w : catalogue()) CHECK(find_walkthrough(w.name) == &w);
  for (const char* unknown : {"", "figure-4", "figure-5 ", "Figure-5", "figure-55", "*"})
    CHECK(find_walkthrough(unknown) == nullptr);
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
  CHECK(nearest_name("figure-4") == "figure-4-left");  // what begins so goes first
}
