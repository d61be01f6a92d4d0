// Figures 4 and 5 as Sections 3.1.2 and 3.1.3 tell them. What the captions claim is computed here a second time, from the
// corners alone.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

const std::vector<Vec2> left_corners = {{3.75, 3.25},  {2, 3.75}, {-0.75, 4}, {-2.5, 3},
                                        {-2.25, 1.25}, {0, -1},   {3.5, -0.5}};
const std::vector<Vec2> right_corners = {{4.25, 4.5},  {0.75, 5}, {-1.5, 4.5}, {-1.25, 3.5},
                                         {-0.25, 2.5}, {3, 0.5},  {4, 3}};
const Vec2 origin = Vec2::Zero();

Told left() { return Told("figure-4-left"); }
Told right() { return Told("figure-4-right"); }
Told right_no_test() { return Told("figure-4-right-no-crossing-test"); }

/// Returns: how far `corner` lies past the origin along `d`, in scene units.
double reach(const Vec2& corner, const Vec2& d) { return corner.dot(d) / d.norm(); }

/// Returns: the letters from the farthest along `d` to the least far.
std::string farthest_first(const Told& told, const Vec2& d) {
  std::string letters = "ABCDEFG";
  std::ranges::sort(letters, {}, [&](char letter) { return -reach(told.corner(letter), d); });
  return letters;
}

/// An iteration in letters: the point found, the simplex that it makes, and what is kept of that.
struct Step {
  char found;
  std::string simplex, kept;
};

/// The direction of the next iteration leads from what was kept straight toward the origin.
void check_direction(const Told& told, const std::string& kept, const Vec2& d) {
  const Vec2 from = told.corner(kept[0]);
  if (kept.size() == 1) CHECK(d == -from);
  if (kept.size() == 2) CHECK(d.dot(told.corner(kept[1]) - from) == 0);
  CHECK(d.dot(origin - from) > 0);
}

void check_steps(const Told& told, const std::vector<Step>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const int iteration = static_cast<int>(i) + 1;
    const Step& step = steps[i];
    INFO("iteration " << iteration);
    CHECK(told.found(iteration) == std::string(1, step.found));
    CHECK(farthest_first(told, told.direction(iteration))[0] == step.found);
    if (i == 0)
      CHECK(told.at<gjk::SupportFound>(1).direction == Point(1, 0, 0));
    else
      check_direction(told, steps[i - 1].kept, told.direction(iteration));
    if (step.simplex.empty()) continue;  // ended before
    CHECK(told.names(told.at<gjk::VertexAdded>(iteration).simplex) == step.simplex);
    if (step.kept == step.simplex) continue;
    const auto reduced = told.at<gjk::SimplexReduced>(iteration);  // a triangle, to the edge beyond which the origin is
    CHECK(told.names(reduced.after) == step.kept);
    const std::string dropped = told.names(reduced.before, reduced.dropped);
    REQUIRE(dropped.size() == 1);
    CHECK(beyond(told.corner(step.kept[0]), told.corner(step.kept[1]), origin, told.corner(dropped[0])));
  }
}

void check_end(const Told& told, gjk::Status status, gjk::Reason reason, int iterations) {
  CHECK(told.result().status == status);
  CHECK(told.result().reason == reason);
  CHECK(told.result().iterations == iterations);
}

}  // namespace

// -- The two sets -----------------------------------------------------------------------------------------------------

TEST_CASE(
    "Both sets of Figures 4 and 5 are heptagons named A to G, counter-clockwise, and only the left holds the origin") {
  for (const auto& corners : {left_corners, right_corners}) {
    bool inside = true;
    for (std::size_t i = 0; i < 7; ++i) {
      const Vec2 side = corners[(i + 1) % 7] - corners[i];
      CHECK(cross(side, corners[(i + 2) % 7] - corners[i]) > 0);
      inside = inside && cross(side, -corners[i]) > 0;
    }
    CHECK(inside == (corners == left_corners));
  }
  for (const Told& told : {left(), Told("figure-4", 0), Told("figure-5", 0)}) CHECK(told.hull.corners == left_corners);
  for (const Told& told : {right(), right_no_test(), Told("figure-4", 1), Told("figure-5", 1)})
    CHECK(told.hull.corners == right_corners);
  CHECK(left().hull.name({0, -1, 0}) == "F");
}

TEST_CASE("The objects of Figure 4 are a triangle and a quadrilateral, both convex, in the plane") {
  for (const Told& told : {left(), right(), right_no_test()}) {
    CHECK(told.scene.a.name == "triangle");
    CHECK(told.scene.b.name == "quadrilateral");
    for (const auto& [object, count] : {std::pair(told.scene.a, 3u), {told.scene.b, 4u}}) {
      const std::vector<Point> vertices = vertices_of(object);
      CHECK(vertices.size() == count);
      CHECK(Told(walkthrough_of(vertices).scenes[0]).hull.corners.size() == count);
      for (const Point& p : vertices) CHECK(p.z() == 0);
    }
  }
}

TEST_CASE("The crossing test is on in Figure 5, and in the halves of Figure 4 but the one named after it") {
  const auto is_on = [](const char* name) {
    return walkthrough(name).scenes.back().options.crossing_test == gjk::CrossingTest::on;
  };
  for (const char* name : {"figure-5", "figure-4-left", "figure-4-right"}) CHECK(is_on(name));
  for (const char* name : {"figure-4", "figure-4-right-no-crossing-test"}) CHECK_FALSE(is_on(name));
}

// -- The searches -----------------------------------------------------------------------------------------------------

TEST_CASE("Left: A, then E, which lies slightly farther than F, then G, then F, and triangle EFG contains the origin") {
  const Told told = left();
  check_steps(told, {{'A', "A", "A"}, {'E', "AE", "AE"}, {'G', "AEG", "EG"}, {'F', "EGF", "EGF"}});
  check_end(told, gjk::Status::intersecting, gjk::Reason::simplex_contains_origin, 4);
  CHECK(triangle_contains(told.corner('E'), told.corner('F'), told.corner('G'), origin));
  CHECK_FALSE(triangle_contains(told.corner('A'), told.corner('E'), told.corner('G'), origin));
}

TEST_CASE("Left: the remarks hold on why F is not found at once") {
  const Told told = left();
  CHECK(farthest_first(told, told.direction(2)).starts_with("EF"));
  CHECK(reach(told.corner('E'), told.direction(2)) == Approx(0.88).margin(0.005));
  CHECK(reach(told.corner('F'), told.direction(2)) == Approx(0.65).margin(0.005));
  CHECK(farthest_first(told, {0, -1})[0] == 'F');  // straight down, from which the third direction slants
  CHECK(told.direction(3).y() < 0);
  CHECK(told.direction(3).x() > 0);
}

TEST_CASE("Left: the origin was crossed on every move") {
  const Told told = left();
  CHECK(told.at<gjk::CrossingTested>(1).verdict == gjk::Crossing::first_point);
  for (const int move : {2, 3, 4}) {
    const auto crossing = told.at<gjk::CrossingTested>(move);
    CHECK(crossing.verdict == gjk::Crossing::crossed);
    CHECK(crossing.value.value() == told.corner(told.found(move)[0]).dot(told.direction(move)));
    CHECK(crossing.value.value() > 0);
  }
}

TEST_CASE("Right, with the crossing test: E did not cross the origin, and the search ends there") {
  const Told told = right();
  check_steps(told, {{'A', "A", "A"}, {'E', "", ""}});
  check_end(told, gjk::Status::separated, gjk::Reason::origin_not_crossed, 2);
  const auto crossing = told.at<gjk::CrossingTested>(2);
  CHECK(crossing.verdict == gjk::Crossing::not_crossed);
  CHECK(crossing.value.value() == told.corner('E').dot(told.direction(2)));
  CHECK(crossing.value.value() < 0);
}

TEST_CASE("Right, without it: A, E, F, then E again, no new point, and the sets are apart") {
  const Told told = right_no_test();
  check_steps(told, {{'A', "A", "A"}, {'E', "AE", "AE"}, {'F', "AEF", "EF"}, {'E', "", ""}});
  check_end(told, gjk::Status::separated, gjk::Reason::no_new_vertex, 4);
  for (const int iteration : {1, 2, 3, 4}) {
    CHECK(told.at<gjk::SupportFound>(iteration).is_new == (iteration < 4));
    CHECK(told.at<gjk::CrossingTested>(iteration).verdict == gjk::Crossing::switched_off);
  }
  CHECK(told.corner('E').dot(told.direction(4)) < 0);
}

TEST_CASE("Right: the origin lies beyond E, in R2 of segment AE, which only the crossing test would rule out") {
  const auto is_beyond_E = [](const Told& told) {
    const Vec2 E = told.corner('E');
    return (E - told.corner('A')).dot(origin - E) > 0;
  };
  CHECK(is_beyond_E(right_no_test()));
  CHECK_FALSE(is_beyond_E(left()));
  const auto regions = all<gjk::RegionTested>(right_no_test().trace);
  const auto R2 = std::ranges::find_if(regions, [](const auto& r) { return r.iteration == 2 && r.label == "R2"; });
  REQUIRE(R2 != regions.end());
  CHECK(R2->feature == "A");  // the newest, which is E
  CHECK(R2->verdict == gjk::Verdict::skipped);
  CHECK(R2->reason == "only the crossing test rules this out, and this run does without it");
}

// -- Side by side -----------------------------------------------------------------------------------------------------

TEST_CASE("Figure 4 in step has one frame for each iteration, which both scenes have just finished") {
  const Story story = tell(walkthrough("figure-4"));
  REQUIRE(story.frames.size() == 4);
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const Frame& frame = story.frames[i];
    REQUIRE(frame.moments.size() == 2);
    for (std::size_t s = 0; s < 2; ++s) {
      const auto& events = story.tellings[s].trace.events;
      const std::size_t last = frame.events[s].last;
      CHECK(frame.moments[s].iteration == static_cast<int>(i) + 1);
      CHECK(iteration_of(events.at(last)) == static_cast<int>(i) + 1);
      CHECK((last + 1 == events.size() || iteration_of(events[last + 1]) == static_cast<int>(i) + 2));
      CHECK((frame.focus_of(s) == Focus::end) == (i == 3));
    }
  }
}

TEST_CASE(
    "Figure 5 shows of both sets the same three stages of the move from A to E, which crosses the origin on the left") {
  const Story story = tell(walkthrough("figure-5"));
  const Focus stages[] = {Focus::direction, Focus::support, Focus::crossing};
  REQUIRE(story.frames.size() == std::size(stages));
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const Frame& frame = story.frames[i];
    CHECK(frame.focus == stages[i]);
    REQUIRE(frame.moments.size() == 2);
    for (std::size_t s = 0; s < 2; ++s) {
      const Moment& now = frame.moments[s];
      const LabelledHull& hull = story.tellings[s].hull;
      CHECK(now.simplex.size() == 1);
      CHECK(hull.name(now.simplex.point(gjk::Role::A)) == "A");
      CHECK(now.direction->value == -now.simplex.point(gjk::Role::A));
      CHECK((now.found ? hull.name(now.found->w) : "") == (i == 0 ? "" : "E"));
      CHECK((now.crossing && now.crossing->value) == (i == 2));
      if (i != 2) continue;
      CHECK((hull.corners[4].dot(now.direction->value.head<2>()) > 0) == (s == 0));
      CHECK(now.crossing->verdict == (s == 0 ? gjk::Crossing::crossed : gjk::Crossing::not_crossed));
      CHECK(frame.facts.at(s).mark == (s == 0 ? Fact::Mark::yes : Fact::Mark::no));
    }
  }
}
