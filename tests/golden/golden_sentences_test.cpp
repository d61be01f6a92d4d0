// What is said of all frames of all walkthroughs, and of searches at random: each sentence once, sentences.txt.

#include "tests/golden/random_searches.hpp"
#include "tests/golden/sentences.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/alternative_text.hpp"

namespace golden_sentences_test {

using namespace golden;
using walkthroughs::picture::StagedStory;

namespace {

void add(Sentences& said, const std::string& name, const StagedStory& story) {
  said.add_all(story.walkthrough.title + "\n" + story.walkthrough.summary, name);
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    said.add_all(walkthroughs::story::alternative_text(story, i), name + " " + std::to_string(i));
  for (const std::string& each : story.left_out()) said.add_all(each, name);
}

}  // namespace

TEST_CASE("sentences of all walkthroughs are the accepted ones") {
  Sentences said;
  for (const walkthroughs::model::Walkthrough& w : walkthroughs::catalogue::whole_catalogue())
    add(said, w.name, StagedStory(walkthroughs::story::tell(w)));
  for (const RandomSearch& each : random_searches())
    add(said, each.name, StagedStory(tell(each.walkthrough, each.detail)));
  check_text("sentences.txt", said.text("   | "), "sentences");
}

}  // namespace golden_sentences_test
