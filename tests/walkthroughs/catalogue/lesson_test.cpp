// The lesson: that no screen is done before somebody does something, and each can be done.
#include "walkthroughs/catalogue/lesson.hpp"

#include <functional>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace lesson_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;
using Doing = Screen::Doing;
using Change = std::function<void(Scene&)>;

Change moved(double x, double y) {
  return [=](Scene& scene) {
    for (Point& corner : std::get<Points>(scene.b.form)) corner += Point(x, y, 0);
  };
}

bool is_done_by(const Screen& screen, const Change& change) {
  Walkthrough changed = *find_walkthrough(screen.walkthrough);
  change(changed.scenes[0]);
  changed.remarks = {};
  return screen.is_done(tell(changed));
}

Screen screen_called(std::string_view title) { return *std::ranges::find(screens(), title, &Screen::title); }

TEST_CASE("The lesson has twelve screens, each of a walkthrough that is there") {
  CHECK(screens().size() == 12);
  for (const Screen& screen : screens()) {
    INFO(screen.title);
    REQUIRE(find_walkthrough(screen.walkthrough));
    CHECK(find_walkthrough(screen.walkthrough)->layout == Layout::search);
    CHECK((screen.is_done != nullptr) == (screen.doing == Doing::change));
  }
}

TEST_CASE("No screen is done before somebody does something, and each begins with what it asks about") {
  for (const Screen& screen : screens()) {
    INFO(screen.title);
    const Walkthrough& w = *find_walkthrough(screen.walkthrough);
    const Story story = tell(w);
    const std::size_t frame = first_frame(screen, story);
    CHECK(story.frames[frame].focus == screen.focus);
    if (screen.is_done) CHECK_FALSE(screen.is_done(story));
    if (screen.doing == Doing::answer) {
      const auto questions = page::in_frames(page::questions_of(story), story);
      CHECK(std::ranges::count(questions, frame + 1, &page::Question::frame) == 1);
    }
    if (screen.doing == Doing::draw) CHECK(story.frames[frame + 1].focus == Focus::direction);
  }
}

TEST_CASE("What is to be done by a change can be done, and something else does not do it") {
  struct Row {
    const char* title;
    Change does, does_not;
  };
  const Row rows[] = {
      {"The difference of two objects", moved(-6.5, 0), moved(-5.5, 0)},
      {"The origin in it", moved(1.5, 2), moved(-1, 0)},
      {"Support points",
       [](Scene& s) {
         s.options.first_direction = {0, 1, 0};
       },
       [](Scene& s) {
         s.options.first_direction = {-1, 0, 0};
       }},
      {"Two points", moved(0.5, 0), moved(0, 0)},
      {"The crossing test", moved(10, 0), moved(0.25, 0)},
      {"Touching", moved(2.5, -2.5), moved(0.5, 0)},
      {"A search that goes round", [](Scene& s) { s.rules = RuleSet::complete; },
       [](Scene& s) { s.rules = RuleSet::as_printed; }},
      {"Rounding, and certified answers", [](Scene& s) { s.certified = true; }, [](Scene&) {}},
      {"Now your own", [](Scene& s) { s = find_walkthrough("vehicle-and-threat/counter-munition-hit")->scenes[0]; },
       moved(10, 0)}};
  CHECK(std::size(rows) == static_cast<std::size_t>(std::ranges::count(screens(), Doing::change, &Screen::doing)));
  for (const auto& [title, does, does_not] : rows) {
    INFO(title);
    CHECK(is_done_by(screen_called(title), does));
    CHECK_FALSE(is_done_by(screen_called(title), does_not));
  }
}

}  // namespace lesson_test
