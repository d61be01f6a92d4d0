#include "walkthroughs/page/index_entry.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

const PagePictures pictures{.url = [](std::size_t, int) { return "x.png"; },
                            .page = {1280, 720},
                            .part = {{40, 72}, {1240, 520}},
                            .is_dark = true};

IndexEntry entry_for(const std::string& name) { return index_entry(tell(walkthrough(name)), pictures); }

}  // namespace

TEST_CASE(
    "An entry of the index says answer, section and number of steps, and shows the last decision about a region") {
  const Story left = tell(walkthrough("figure-4-left"));
  const IndexEntry entry = index_entry(left, pictures);
  CHECK(entry.answer == "intersecting");
  CHECK(entry.section == left.walkthrough.source);
  CHECK(entry.steps == left.frames.size());
  CHECK(left.frames[entry.picture].focus == Focus::region);
  CHECK(entry_for("figure-4").answer == "intersecting, separated");
  const Story mistaken = tell(walkthrough("mistakes/m9-abn-inward"));
  CHECK(mistaken.frames[index_entry(mistaken, pictures).picture].focus == Focus::parting);
  CHECK(entry_for("figure-1").answer.empty());
}

TEST_CASE("The picture of a region's walkthrough is of the decision for that region") {
  for (const auto& [name, label] : std::vector<std::pair<std::string, std::string>>{
           {"2-simplex-r3", "R3"}, {"2-simplex-r7", "R7"}, {"2-simplex-r1-below", "R1"}}) {
    INFO(name);
    const Story story = tell(walkthrough("regions/" + name));
    const Frame& frame = story.frames[index_entry(story, pictures).picture];
    const auto& regions = frame.moments[0].regions;
    REQUIRE(!regions.empty());
    CHECK(regions.back().verdict == gjk::Verdict::chosen);
    CHECK(to_string(label_of(regions.back())) == label);
    CHECK(frame.moments[0].processed.size() == 3);
  }
}

TEST_CASE("What a page says of itself is read as it was written, whatever its texts are") {
  IndexEntry entry = entry_for("figure-4-right");
  entry.title = "</script><b>é\n\"";
  entry.sentence = "an underscore \\_ and a sub_1";
  const std::string page = "<!doctype html>" + entry_element(entry) + "<script>more</script>";
  const std::optional<IndexEntry> read = entry_of(page);
  REQUIRE(read);
  CHECK(entry_json(*read) == entry_json(entry));
  CHECK(page.find("</script><b>") == std::string::npos);
  CHECK(read->title == entry.title);
  CHECK(read->sentence == entry.sentence);
  CHECK(read->iteration_ends == entry.iteration_ends);
  CHECK(!read->iteration_ends.empty());
  CHECK(read->cut == cut_out(pictures.page, pictures.part));
  CHECK(read->is_dark);
}

TEST_CASE("A page that somebody else has written, or that is damaged, says nothing of itself") {
  const std::string page = entry_element(entry_for("figure-4-right"));
  for (std::size_t length = 0; length < page.size() - std::string("}</script>\n").size(); ++length)
    REQUIRE_FALSE(entry_of(page.substr(0, length)));
  for (const auto& [sound, odd] :
       std::vector<std::pair<std::string, std::string>>{{"\"steps\":", "\"steps\":-"},
                                                        {"\"steps\":", "\"steps\":0.5e"},
                                                        {"\"picture\":", "\"picture\":1e30,\"\":"},
                                                        {"\"iteration_ends\":[", "\"iteration_ends\":[[],"},
                                                        {"\"title\":", "\"titel\":"},
                                                        {"\"name\":", "\"name\":7,\"\":"}}) {
    INFO(odd);
    std::string other = page;
    REQUIRE(other.find(sound) != std::string::npos);
    CHECK_FALSE(entry_of(other.replace(other.find(sound), sound.size(), odd)));
  }
}
