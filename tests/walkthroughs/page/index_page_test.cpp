#include "walkthroughs/page/index_page.hpp"

#include "tests/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

IndexEntry entry_named(const std::string& name) {
  IndexEntry entry;
  entry.name = name;
  entry.page = {1280, 720};
  entry.part = {{40, 72}, {1240, 520}};
  return entry;
}

bool stand_in_order(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    at = text.find(part, at);
    if (at == std::string::npos) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("The index groups walkthroughs as the report goes, each group once, and leaves out empty ones") {
  const std::string page =
      index_html({entry_named("mine"), entry_named("failures/x"), entry_named("regions/2-simplex-r3"),
                  entry_named("figure-1"), entry_named("mistakes/x"), entry_named("cycle-x"), entry_named("figure-2")});
  CHECK(stand_in_order(page, {"Figures of the report", "figure-1/", "figure-2/", "a triangle", "regions/2-simplex-r3/",
                              "Where it goes wrong", "failures/x/", "cycle-x/", "Mistakes", "mistakes/x/",
                              "Scenes of your own", "mine/"}));
  CHECK(page.find("Where it goes wrong") == page.rfind("Where it goes wrong"));
  CHECK(page.find("In space") == std::string::npos);
}

TEST_CASE("Every walkthrough of the catalogue belongs to a group of the report") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    CHECK(index_html({entry_named(w.name)}).find("Scenes of your own") == std::string::npos);
  }
}

TEST_CASE(
    "An entry of the index says answer, section and number of steps, and shows the last decision about a region") {
  const Story left = tell(walkthrough("figure-4-left"));
  const IndexEntry entry = index_entry(left);
  CHECK(entry.answer == "intersecting");
  CHECK(entry.section == left.walkthrough.source);
  CHECK(entry.steps == left.frames.size());
  CHECK(left.frames[entry.picture].focus == Focus::region);
  CHECK(index_entry(tell(walkthrough("figure-4"))).answer == "intersecting, separated");
  const Story mistaken = tell(walkthrough("mistakes/m9-abn-inward"));
  CHECK(mistaken.frames[index_entry(mistaken).picture].focus == Focus::parting);
  CHECK(index_entry(tell(walkthrough("figure-1"))).answer.empty());
}

TEST_CASE("Titles of others are text in the index") {
  IndexEntry entry = entry_named("x");
  entry.title = "<img src=x onerror=alert(1)>";
  CHECK(index_html({entry}).find("<img src=x ") == std::string::npos);
}
