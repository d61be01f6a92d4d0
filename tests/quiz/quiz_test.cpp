#include "tests/quiz/quiz.hpp"

#include <map>

#include "tests/kit/catch.hpp"
#include "walkthroughs/story/decision.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;

TEST_CASE("quiz: each kind of decision is asked about as often, and one seed asks the same again") {
  const std::vector<quiz::Question> all = quiz::questions(30, 7), again = quiz::questions(30, 7);
  std::map<std::string, int> kinds;
  for (const quiz::Question& question : all) ++kinds[question.kind];
  CHECK(kinds.size() == 19);
  for (const auto& [kind, count] : kinds) CHECK(count == 2);
  REQUIRE(all.size() == again.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].text + all[i].answer == again[i].text + again[i].answer);
    CHECK(all[i].frame == again[i].frame);
  }
  CHECK(quiz::questions(19, 8)[0].walkthrough.scenes[0].a.name == "a");
}

TEST_CASE("quiz: a picture of space in which something is asked has the plane picture of it, and tells no answer") {
  for (const quiz::Question& question : quiz::questions(38, 3)) {
    const Story story = tell(question.walkthrough);
    const Frame& frame = story.frames[question.frame];
    INFO(question.kind << ": " << frame.caption);
    const bool in_space = question.walkthrough.scenes[0].dimension == Dimension::space;
    const std::vector<DecisionView> views = decision_views(frame.moments[0], frame.focus);
    CHECK((!in_space || !views.empty()));
    if (frame.focus == Focus::added) CHECK(frame.moments[0].regions.empty());
    if (question.answer == "R1 above") CHECK(views[0].height > 0);
    if (question.answer == "R1 below") CHECK(views[0].height < 0);
    if (question.answer == "inside")
      for (const DecisionView& view : views) CHECK((view.height <= 0 || view.face == "BCD"));
  }
}

TEST_CASE("quiz: the legend has a word for each answer") {
  const std::string legend = quiz::legend();
  for (const quiz::Question& question : quiz::questions(57, 1))
    CHECK(legend.find(question.answer) != std::string::npos);
}
