#include "walkthroughs/page/index_page.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

PageJson groups_of(const std::vector<std::string>& names) {
  std::vector<PageJson> entries;
  for (const std::string& name : names) entries.push_back({{"name", name}});
  return in_groups(entries);
}

}  // namespace

TEST_CASE("The index groups walkthroughs as the report goes, each group once, and leaves out empty ones") {
  std::string found;
  for (const PageJson& group : groups_of({"mine", "failures/x", "regions/2-simplex-r3", "figure-2", "mistakes/x",
                                          "cycle-x", "figure-1", "complete/x"})) {
    found += group["title"].get<std::string>() + ":";
    for (const PageJson& entry : group["entries"]) found += " " + entry["name"].get<std::string>();
    found += "\n";
  }
  CHECK(found ==
        "Figures of the report: figure-2 figure-1\n"
        "Regions of a 2-simplex, a triangle: regions/2-simplex-r3\n"
        "Where it goes wrong: cycle-x failures/x\n"
        "The remedy: rules that end: complete/x\n"
        "Mistakes: mistakes/x\n"
        "Scenes of your own: mine\n");
}

TEST_CASE("Every walkthrough of the catalogue belongs to a group of the report") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    CHECK(groups_of({w.name})[0]["title"] != "Scenes of your own");
  }
}

TEST_CASE("Titles of others are text in the pages over all") {
  const PageJson entry = {{"name", "x"}, {"title", "</script><img src=x onerror=alert(1)>"}};
  for (const char* name : {"index.html", "compare.html"}) {
    const std::string page = page_over({entry}, name);
    CHECK(page.find("<img src=x") == std::string::npos);
    CHECK(page.find("\\u003c/script>\\u003cimg src=x") != std::string::npos);
  }
}
