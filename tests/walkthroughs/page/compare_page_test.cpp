#include "walkthroughs/page/compare_page.hpp"

#include <nlohmann/json.hpp>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

TEST_CASE("Searches can be compared, diagrams cannot, and each iteration has its last frame") {
  std::vector<IndexEntry> entries;
  for (const char* name : {"figure-1", "figure-4-left", "figure-6", "figure-4"})
    entries.push_back(index_entry(tell(walkthrough(name)), {}));
  const std::vector<IndexEntry> searches = comparable(entries);
  REQUIRE(searches.size() == 2);
  CHECK(searches[0].name == "figure-4-left");
  CHECK(searches[1].name == "figure-4");
  const Story left = tell(walkthrough("figure-4-left"));
  for (std::size_t i = 0; i < searches[0].iteration_ends.size(); ++i) {
    const std::size_t end = searches[0].iteration_ends[i];
    CHECK(left.frames[end].moments[0].iteration == static_cast<int>(i) + 1);
    if (end + 1 < left.frames.size()) CHECK(left.frames[end + 1].moments[0].iteration == static_cast<int>(i) + 2);
  }
}

TEST_CASE("The page that compares names each search once on either side, and titles of others are text in it") {
  std::vector<IndexEntry> entries{index_entry(tell(walkthrough("figure-4-left")), {}),
                                  index_entry(tell(walkthrough("figure-4-right")), {})};
  entries[0].title = "</option><script>alert(1)</script>";
  const std::string page = compare_html(entries);
  CHECK(page.find("</option><script>") == std::string::npos);
  CHECK(page.find("&lt;/option&gt;&lt;script&gt;") != page.rfind("&lt;/option&gt;&lt;script&gt;"));
  const std::string begin = "id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  const auto data = nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
  REQUIRE(data.size() == 2);
  CHECK(data[1]["name"] == "figure-4-right");
  CHECK(page.find("<optgroup label=\"Figures of the report\">") != std::string::npos);
  CHECK(data[1]["last"].size() == 2);
}
