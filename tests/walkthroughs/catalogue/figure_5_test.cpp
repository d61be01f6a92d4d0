// Figure 5: the move from A to E in both sets, with and without crossing the origin (Section 3.1.3).

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

Told left() { return Told("figure-5", 0); }
Told right() { return Told("figure-5", 1); }

std::vector<std::string> texts(const Frame& frame) {
  std::vector<std::string> list;
  for (const Fact& fact : frame.facts) list.push_back(fact.text);
  return list;
}

std::vector<Fact::Mark> marks(const Frame& frame) {
  std::vector<Fact::Mark> list;
  for (const Fact& fact : frame.facts) list.push_back(fact.mark);
  return list;
}

}  // namespace

TEST_CASE("Figure 5 looks at the two sets of Figure 4, with the crossing test on") {
  CHECK(left().hull.corners == Told("figure-4-left").hull.corners);
  CHECK(right().hull.corners == Told("figure-4-right").hull.corners);
  for (const Scene& scene : walkthrough("figure-5").scenes) CHECK(scene.options.crossing_test == gjk::CrossingTest::on);
}

TEST_CASE("In both sets of Figure 5 the move goes from A to E") {
  for (const Told& told : {left(), right()}) {
    CHECK(told.found(1) == "A");
    CHECK(told.direction(2) == -told.corner('A'));
    CHECK(told.found(2) == "E");
  }
}

TEST_CASE("In Figure 5 E lies across the origin on the left and not on the right") {
  CHECK(left().corner('E').dot(left().direction(2)) > 0);
  CHECK(right().corner('E').dot(right().direction(2)) < 0);
  CHECK(left().at<gjk::CrossingTested>(2).verdict == gjk::Crossing::crossed);
  CHECK(right().at<gjk::CrossingTested>(2).verdict == gjk::Crossing::not_crossed);
}

TEST_CASE("Figure 5 has three frames: the direction, the support point, the crossing test") {
  const Story story = tell(walkthrough("figure-5"));
  REQUIRE(story.frames.size() == 3);
  CHECK(story.frames.at(0).focus == Focus::direction);
  CHECK(story.frames.at(1).focus == Focus::support);
  CHECK(story.frames.at(2).focus == Focus::crossing);
  CHECK(story.frames.at(0).caption == "In both sets the search goes from A along d, toward the origin.");
  CHECK(story.frames.at(1).caption == "In both sets the farthest point along d is E.");
  CHECK(story.frames.at(2).caption ==
        "On the left the move to E passes the origin; on the right it stops short of it, so the origin is not in the "
        "difference.");
}

TEST_CASE("The facts of Figure 5 say for each set what was found") {
  using Mark = Fact::Mark;
  const Story story = tell(walkthrough("figure-5"));
  CHECK(texts(story.frames.at(0)) ==
        std::vector<std::string>{"left: d = AO = (−3.75, −3.25)", "right: d = AO = (−4.25, −4.5)"});
  CHECK(texts(story.frames.at(1)) ==
        std::vector<std::string>{"left: d = (−3.75, −3.25); E·d = 4.375, then F·d = 3.25",
                                 "left: E = a − b = (−1.25, 1.25) − (1, 0) = (−2.25, 1.25)",
                                 "right: d = (−4.25, −4.5); E·d = −10.1875, then D·d = −10.4375",
                                 "right: E = a − b = (−1, 2.5) − (−0.75, 0) = (−0.25, 2.5)"});
  CHECK(texts(story.frames.at(2)) ==
        std::vector<std::string>{"left: E·d = 4.375 > 0: the origin was crossed",
                                 "right: E·d = −10.1875 < 0: the origin was not crossed (Eq. 9)"});
  CHECK(marks(story.frames.at(2)) == std::vector{Mark::yes, Mark::no});
}

TEST_CASE("Each frame of Figure 5 shows both sets at the same stage of the same move") {
  const Story story = tell(walkthrough("figure-5"));
  for (const Frame& frame : story.frames) {
    REQUIRE(frame.moments.size() == 2);
    for (std::size_t s = 0; s < 2; ++s) {
      const Moment& now = frame.moments[s];
      CHECK(story.tellings[s].hull.name(now.simplex.point(gjk::Role::A)) == "A");
      CHECK(now.simplex.size() == 1);
      CHECK(now.direction->value == -now.simplex.point(gjk::Role::A));
      CHECK(now.found.has_value() == (frame.focus != Focus::direction));
      CHECK((now.crossing && now.crossing->value) == (frame.focus == Focus::crossing));
      if (now.found) CHECK(story.tellings[s].hull.name(now.found->w) == "E");
    }
  }
}
