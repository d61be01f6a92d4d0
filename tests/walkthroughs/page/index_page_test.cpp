#include "walkthroughs/page/index_page.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

IndexEntry entry_named(const std::string& name) {
  IndexEntry entry;
  entry.name = name;
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
  for (const char* once : {"<h2>Where it goes wrong</h2>", "<option>Where it goes wrong</option>"})
    CHECK((page.find(once) != std::string::npos && page.find(once) == page.rfind(once)));
  CHECK(page.find("In space") == std::string::npos);
}

TEST_CASE("Every walkthrough of the catalogue belongs to a group of the report") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    CHECK(index_html({entry_named(w.name)}).find("Scenes of your own") == std::string::npos);
  }
}

TEST_CASE("Titles of others are text in the index") {
  IndexEntry entry = entry_named("x");
  entry.title = "<img src=x onerror=alert(1)>";
  entry.sentence = "<b onclick=alert(1)>R_1";
  entry.cut = "\"><img src=x ";
  const std::string page = index_html({entry});
  CHECK(page.find("<img src=x ") == std::string::npos);
  CHECK(page.find("&lt;b onclick=alert(1)&gt;R<sub>1</sub>") != std::string::npos);
}

TEST_CASE("In the dark a card's picture is turned over where it was drawn on a light ground") {
  IndexEntry light = entry_named("light"), dark = entry_named("dark");
  dark.is_dark = true;
  CHECK(stand_in_order(index_html({light, dark}), {"card light-pictures", "light/", "card dark-pictures", "dark/"}));
}

TEST_CASE("The rules that end where the report's do not stand in the index as the remedy, not where it goes wrong") {
  IndexEntry entry;
  entry.name = "complete/x";
  const std::string page = index_html({entry}, "");
  CHECK(page.find("The remedy: rules that end") != std::string::npos);
  CHECK(page.find("Where it goes wrong") == std::string::npos);
}
