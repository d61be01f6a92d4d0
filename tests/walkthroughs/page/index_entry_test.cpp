#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/page/page.hpp"

namespace index_entry_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

const PagePictures pictures{.url = [](std::size_t, int) { return "x.png"; },
                            .page = {1000, 500},
                            .part = {{250, 100}, {750, 500}},
                            .is_dark = true};

PageJson entry_for(const std::string& name) { return index_entry(tell(walkthrough(name)), pictures); }

PageJson groups_of(const std::vector<std::string>& names) {
  std::vector<PageJson> entries;
  for (const std::string& name : names) entries.push_back({{"name", name}});
  return in_groups(entries);
}

}  // namespace

TEST_CASE(
    "An entry of the index says answer, section and number of steps, and shows the last decision about a region") {
  const Story left = tell(walkthrough("figure-4-left"));
  const PageJson entry = index_entry(left, pictures);
  CHECK(entry["answers"] == PageJson{"intersecting"});
  CHECK(entry["section"] == left.walkthrough.source);
  CHECK(entry["steps"] == left.frames.size());
  CHECK(left.frames.at(entry["picture"]).focus == Focus::region);
  CHECK(entry["is_dark"] == true);
  CHECK(entry_for("figure-4")["answers"] == PageJson{"intersecting", "separated"});
  const Story mistaken = tell(walkthrough("mistakes/m9-abn-inward"));
  CHECK(mistaken.frames.at(index_entry(mistaken, pictures)["picture"]).focus == Focus::parting);
  CHECK(entry_for("figure-1")["answers"].empty());
}

TEST_CASE("The picture of a region's walkthrough is of the decision for that region") {
  for (const auto& [name, label] : std::vector<std::pair<std::string, std::string>>{
           {"2-simplex-r3", "R3"}, {"2-simplex-r7", "R7"}, {"2-simplex-r1-below", "R1"}}) {
    INFO(name);
    const Story story = tell(walkthrough("regions/" + name));
    const Frame& frame = story.frames.at(index_entry(story, pictures)["picture"]);
    const auto& regions = frame.moments[0].regions;
    REQUIRE(!regions.empty());
    CHECK(regions.back().verdict == gjk::Verdict::chosen);
    CHECK(to_string(label_of(regions.back())) == label);
    CHECK(frame.moments[0].processed.size() == 3);
  }
}

TEST_CASE("A part of a picture fills the place of the whole") {
  CHECK(entry_for("figure-1")["cut"] == PageJson{{"width", 200.0}, {"left", -50.0}, {"top", -25.0}, {"aspect", 1.25}});
}

TEST_CASE("Searches have an end of each iteration, diagrams have none") {
  CHECK(entry_for("figure-1")["iteration_ends"].empty());
  CHECK(entry_for("figure-6")["iteration_ends"].empty());
  const Story left = tell(walkthrough("figure-4-left"));
  const PageJson ends = index_entry(left, pictures)["iteration_ends"];
  REQUIRE_FALSE(ends.empty());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto end = ends[i].get<std::size_t>();
    CHECK(left.frames[end].moments[0].iteration == static_cast<int>(i) + 1);
    if (end + 1 < left.frames.size()) CHECK(left.frames[end + 1].moments[0].iteration == static_cast<int>(i) + 2);
  }
}

TEST_CASE("What a page says of itself is read as it was written, whatever its texts are") {
  PageJson entry = entry_for("figure-4-right");
  entry["title"] = "</script><b>é\n\"},\n\"story\":";
  const std::string script = story_script(entry, {{"x", "</script>"}});
  CHECK(script.find("</script>") == std::string::npos);
  CHECK(entry_in(script) == entry);
  CHECK(entry_in("<!doctype html><script>\n" + script + "</script>") == entry);
}

TEST_CASE("A page that somebody else has written, or that is damaged, says nothing of itself") {
  const std::string script = story_script(entry_for("figure-4-right"), {});
  for (std::size_t length = 0; length < script.find("},\n\"story\""); ++length)
    REQUIRE_FALSE(entry_in(script.substr(0, length)));
  for (const auto& [sound, odd] :
       std::vector<std::pair<std::string, std::string>>{{"\"steps\":", "\"steps\":-"},
                                                        {"\"steps\":", "\"steps\":0.5e"},
                                                        {"\"picture\":", "\"picture\":1e30,\"\":"},
                                                        {"\"cut\":{", "\"cut\":7,\"\":{"},
                                                        {"\"title\":", "\"titel\":"},
                                                        {"\"name\":", "\"name\":7,\"\":"}}) {
    INFO(odd);
    std::string other = script;
    REQUIRE(other.find(sound) != std::string::npos);
    CHECK_FALSE(entry_in(other.replace(other.find(sound), sound.size(), odd)));
  }
}

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
  for (const Walkthrough& w : whole_catalogue()) {
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

}  // namespace index_entry_test
