// Frames in words.

#include "walkthroughs/story/alternative_text.hpp"

#include <nlohmann/json.hpp>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/words.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using Json = nlohmann::json;

TEST_CASE("Alternative text says what the panels show and what was decided") {
  const Story story = tell(walkthrough("figure-4-left"));
  CHECK(alternative_text(story, 4) ==
        "The move to E crossed the origin, so the search goes on.\n"
        "The difference of a triangle and a quadrilateral has the corners A (3.75, 3.25), B (2, 3.75), C (−0.75, 4), "
        "D (−2.5, 3), E (−2.25, 1.25), F (0, −1), G (3.5, −0.5). The simplex, oldest first, is [A]. The search "
        "direction d is (−3.75, −3.25). The support points are a (−1.25, 1.25) and b (1, 0); a minus b is E (−2.25, "
        "1.25).\n"
        "True: E·d = 4.375 > 0: the origin was crossed.");
}

TEST_CASE("Pictures are told in few words where scene and simplex stand beside them") {
  CHECK(picture_in_words(tell(walkthrough("figure-4-left")), 4) ==
        std::vector<std::string>{"The difference has the corners A (3.75, 3.25), B (2, 3.75), C (−0.75, 4), D (−2.5, "
                                 "3), E (−2.25, 1.25), F (0, −1), G (3.5, −0.5).",
                                 "The simplex is A (3.75, 3.25).", "d is (−3.75, −3.25).",
                                 "a is (−1.25, 1.25), b (1, 0); a minus b is E (−2.25, 1.25)."});
  const std::vector<std::string> in_space = picture_in_words(tell(walkthrough("regions/3-simplex-face-abc")), 0);
  CHECK(in_space.at(0) == "There is no simplex yet.");
  CHECK(in_space.at(1).starts_with("d is ("));
}

TEST_CASE("Alternative text has no markup and describes each scene of a comparison", "[unsanitized]") {
  for (const Walkthrough& w : catalogue()) {
    const Story story = tell(w);
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      const std::string text = alternative_text(story, i);
      INFO(text);
      CHECK(text.find('_') == std::string::npos);
      CHECK(text.ends_with('.'));
      for (const Scene& scene : w.scenes)
        CHECK((text.find("Of the two, " + scene.name + ": ") != std::string::npos) == (w.scenes.size() == 2));
    }
  }
}

TEST_CASE("Captions as JSON tell file, caption, facts, description and events of each frame") {
  const Story story = tell(walkthrough("figure-5"));
  const Json document = Json::parse(captions_json({{"out/000.png", story, 0}, {"out/002.png", story, 2}}));
  CHECK(document.at("schema") == "gjkstep-captions");
  CHECK(document.at("version") == 1);
  REQUIRE(document.at("frames").size() == 2);
  const Json& frame = document["frames"][1];
  CHECK(frame.at("file") == "out/002.png");
  CHECK(frame.at("walkthrough") == "figure-5");
  CHECK(frame.at("caption") == plain(story.frames[2].caption));
  CHECK(frame.at("facts").size() == story.frames[2].facts.size());
  CHECK(frame.at("alternative_text") == alternative_text(story, 2));
  for (const std::string scene : {"left", "right"}) {
    const auto& events = frame.at("events").at(scene);
    CHECK(events.at(0) == events.at(1));  // the crossing test alone
  }
}
