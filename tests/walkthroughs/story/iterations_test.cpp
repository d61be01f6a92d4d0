// The table of a search: a row for each iteration, with what its events say.
#include "walkthroughs/story/iterations.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

namespace iterations_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

TEST_CASE("Each iteration of every search is one row, numbered as its events are", "[iterations]") {
  for (const Walkthrough& walkthrough : whole_catalogue()) {
    INFO(walkthrough.name);
    const Story story = tell(walkthrough);
    for (std::size_t scene = 0; scene < story.tellings.size(); ++scene) {
      const std::vector<IterationTold> rows = iterations_told(story, scene);
      REQUIRE_FALSE(rows.empty());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].number == static_cast<int>(i) + 1);
        CHECK_FALSE(rows[i].next.empty());
        CHECK_FALSE((rows[i].found.empty() && rows[i].decided.empty()));
      }
    }
  }
}

TEST_CASE("A row has direction, support point and w·d, the region and its number, the simplex, the next direction",
          "[iterations]") {
  const Story story = tell(walkthrough("figure-4-left"));
  const std::vector<IterationTold> rows = iterations_told(story, 0);
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].found[0] == "d = (1, 0)");
  CHECK(rows[0].simplex == "[A]");
  CHECK(rows[0].next == "AO = (−3.75, −3.25)");
  CHECK(rows[1].found.size() == 3);
  CHECK(rows.back().simplex.size() == std::string("[E, F, G]").size());
  CHECK(rows.back().next == "intersecting after 4 iterations");
}

}  // namespace iterations_test
