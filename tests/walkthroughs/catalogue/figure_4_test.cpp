// Figure 4 as Section 3.1.2 tells it. What the captions claim is computed here a second time, from the corners alone.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

const std::vector<Vec2> left_corners = {{3.75, 3.25},  {2, 3.75}, {-0.75, 4}, {-2.5, 3},
                                        {-2.25, 1.25}, {0, -1},   {3.5, -0.5}};
const std::vector<Vec2> right_corners = {{4.25, 4.5},  {0.75, 5}, {-1.5, 4.5}, {-1.25, 3.5},
                                         {-0.25, 2.5}, {3, 0.5},  {4, 3}};

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

std::string letters_found(const Told& told) {
  std::string letters;
  for (const auto& event : all<gjk::SupportFound>(told.trace)) letters += told.hull.name(event.vertex.w);
  return letters;
}

const Vec2 origin = Vec2::Zero();
const Vec2 down(0, -1);

}  // namespace

// -- The two sets -----------------------------------------------------------------------------------------------------

TEST_CASE("Both sets of Figure 4 are heptagons named A to G, counter-clockwise") {
  CHECK(left().hull.corners == left_corners);
  CHECK(right().hull.corners == right_corners);
  CHECK(right_no_test().hull.corners == right_corners);
  for (const auto& corners : {left_corners, right_corners})
    for (std::size_t i = 0; i < 7; ++i)
      CHECK(cross(corners[(i + 1) % 7] - corners[i], corners[(i + 2) % 7] - corners[i]) > 0);
  CHECK(left().hull.name({0, -1, 0}) == "F");
}

TEST_CASE("The objects of Figure 4 are a triangle and a quadrilateral, both convex, in the plane") {
  for (const Told& told : {left(), right(), right_no_test()}) {
    CHECK(told.scene.a.name == "triangle");
    CHECK(told.scene.b.name == "quadrilateral");
    const std::vector<Point> a = vertices_of(told.scene.a), b = vertices_of(told.scene.b);
    CHECK(Told(walkthrough_of(a).scenes[0]).hull.corners.size() == 3);
    CHECK(Told(walkthrough_of(b).scenes[0]).hull.corners.size() == 4);
    CHECK(a.size() + b.size() == 7);
    for (const Object& object : {told.scene.a, told.scene.b})
      for (const Point& p : vertices_of(object)) CHECK(p.z() == 0);
  }
}

TEST_CASE("Every vertex that the search finds is a corner, and the difference of a vertex of each object") {
  for (const Told& told : {left(), right(), right_no_test()}) {
    for (const auto& event : all<gjk::SupportFound>(told.trace)) {
      CHECK(told.hull.name(event.vertex.w).size() == 1);
      CHECK(event.vertex.w == event.vertex.a.point - event.vertex.b.point);
      CHECK(std::ranges::count(vertices_of(told.scene.a), event.vertex.a.point) == 1);
      CHECK(std::ranges::count(vertices_of(told.scene.b), event.vertex.b.point) == 1);
    }
  }
}

TEST_CASE("Each search of Figure 4 finds the farthest corner, and no other is as far while it gets on") {
  for (const Told& told : {left(), right(), right_no_test()}) {
    for (const auto& event : all<gjk::SupportFound>(told.trace)) {
      const Vec2 d = event.direction.head<2>();
      const std::string order = farthest_first(told, d);
      const double farthest = reach(told.corner(order[0]), d);
      CHECK(event.vertex.w.dot(event.direction) == told.corner(order[0]).dot(d));
      CHECK(farthest > reach(told.corner(order[event.is_new ? 1 : 2]), d));
    }
  }
}

TEST_CASE("The left set contains the origin, the right set does not") {
  const auto contains_origin = [](const std::vector<Vec2>& corners) {
    bool inside = true;
    for (std::size_t i = 0; i < 7; ++i) inside = inside && cross(corners[(i + 1) % 7] - corners[i], -corners[i]) > 0;
    return inside;
  };
  CHECK(contains_origin(left_corners));
  CHECK_FALSE(contains_origin(right_corners));
}

// -- Left -------------------------------------------------------------------------------------------------------------

TEST_CASE("Left 1: support(+x) = A") {
  CHECK(left().at<gjk::SupportFound>(1).direction == Point(1, 0, 0));
  CHECK(left().found(1) == "A");
}

TEST_CASE("Left 2: from A toward the origin the search finds E, which lies slightly farther than F") {
  const Told told = left();
  const Vec2 d = told.direction(2);
  CHECK(told.at<gjk::DirectionChosen>(1).expression == "AO");
  CHECK(d == -told.corner('A'));
  CHECK(told.found(2) == "E");
  CHECK(farthest_first(told, d).starts_with("EF"));
  CHECK(reach(told.corner('E'), d) == Approx(0.88).margin(0.005));
  CHECK(reach(told.corner('F'), d) == Approx(0.65).margin(0.005));
}

TEST_CASE("Left 3: from AE the search goes not straight down, and so finds G in place of F") {
  const Told told = left();
  const Vec2 d = told.direction(3), AE = told.corner('E') - told.corner('A');
  CHECK(told.names(told.at<gjk::VertexAdded>(2).simplex) == "AE");
  CHECK(d.dot(AE) == 0);
  CHECK(d.dot(origin - told.corner('A')) > 0);
  CHECK(d.y() < 0);
  CHECK(d.x() > 0);
  CHECK(farthest_first(told, down)[0] == 'F');
  CHECK(told.found(3) == "G");
}

TEST_CASE("Left 4: the origin is not in triangle AEG but beyond EG, and A is dropped") {
  const Told told = left();
  const Vec2 A = told.corner('A'), E = told.corner('E'), G = told.corner('G');
  const auto reduced = told.at<gjk::SimplexReduced>(3);
  const auto regions = all<gjk::RegionTested>(told.trace);
  const auto chosen = std::ranges::find_if(
      regions, [](const auto& r) { return r.iteration == 3 && r.verdict == gjk::Verdict::chosen; });
  CHECK_FALSE(triangle_contains(A, E, G, origin));
  CHECK(beyond(E, G, origin, A));
  REQUIRE(chosen != regions.end());
  CHECK(told.names(reduced.before, chosen->feature) == "EG");
  CHECK(told.names(reduced.before) == "AEG");
  CHECK(told.names(reduced.before, reduced.dropped) == "A");
  CHECK(told.names(reduced.after) == "EG");
}

TEST_CASE("Left 5: from EG the search finds F") {
  const Told told = left();
  const Vec2 d = told.direction(4), EG = told.corner('G') - told.corner('E');
  CHECK(d.dot(EG) == 0);
  CHECK(d.dot(origin - told.corner('E')) > 0);
  CHECK(told.found(4) == "F");
}

TEST_CASE("Left 6: triangle EFG contains the origin, so the objects intersect") {
  const Told told = left();
  CHECK(triangle_contains(told.corner('E'), told.corner('F'), told.corner('G'), origin));
  CHECK(told.names(told.result().simplex) == "EGF");
  CHECK(told.result().status == gjk::Status::intersecting);
  CHECK(told.result().reason == gjk::Reason::simplex_contains_origin);
  CHECK(told.result().iterations == 4);
  CHECK(letters_found(told) == "AEGF");
}

TEST_CASE("Left: the origin was crossed on every move") {
  const Told told = left();
  CHECK(told.at<gjk::CrossingTested>(1).verdict == gjk::Crossing::first_point);
  for (const int move : {2, 3, 4}) {
    const auto crossing = told.at<gjk::CrossingTested>(move);
    const auto found = told.at<gjk::SupportFound>(move);
    CHECK(crossing.verdict == gjk::Crossing::crossed);
    CHECK(crossing.value.value() > 0);
    CHECK(crossing.value.value() == found.vertex.w.dot(found.direction));
  }
}

// -- Right ------------------------------------------------------------------------------------------------------------

TEST_CASE("Right 1: with and without the crossing test the search finds A, then E from A toward the origin") {
  for (const Told& told : {right(), right_no_test()}) {
    CHECK(told.at<gjk::SupportFound>(1).direction == Point(1, 0, 0));
    CHECK(told.found(1) == "A");
    CHECK(told.direction(2) == -told.corner('A'));
    CHECK(told.found(2) == "E");
  }
}

TEST_CASE("Right, with the crossing test: E did not cross the origin, and the search ends there") {
  const Told told = right();
  const auto crossing = told.at<gjk::CrossingTested>(2);
  CHECK(told.scene.options.crossing_test == gjk::CrossingTest::on);
  CHECK(crossing.verdict == gjk::Crossing::not_crossed);
  CHECK(told.corner('E').dot(told.direction(2)) < 0);
  CHECK(crossing.value.value() == told.corner('E').dot(told.direction(2)));
  CHECK(told.result().status == gjk::Status::separated);
  CHECK(told.result().reason == gjk::Reason::origin_not_crossed);
  CHECK(told.result().iterations == 2);
  CHECK(letters_found(told) == "AE");
}

TEST_CASE("Right, without the crossing test: it was applied to no vertex") {
  const Told told = right_no_test();
  CHECK(told.scene.options.crossing_test == gjk::CrossingTest::off);
  for (const auto& crossing : all<gjk::CrossingTested>(told.trace)) {
    CHECK(crossing.verdict == gjk::Crossing::switched_off);
    CHECK_FALSE(crossing.value.has_value());
  }
}

TEST_CASE("Right 2: from AE the search finds F") {
  const Told told = right_no_test();
  CHECK(told.names(told.at<gjk::VertexAdded>(2).simplex) == "AE");
  CHECK(told.direction(3).dot(told.corner('E') - told.corner('A')) == 0);
  CHECK(told.found(3) == "F");
}

TEST_CASE("Right 3: the origin is not in triangle AEF but beyond EF, and A is dropped") {
  const Told told = right_no_test();
  const Vec2 A = told.corner('A'), E = told.corner('E'), F = told.corner('F');
  const auto reduced = told.at<gjk::SimplexReduced>(3);
  CHECK_FALSE(triangle_contains(A, E, F, origin));
  CHECK(beyond(E, F, origin, A));
  CHECK(told.names(reduced.before) == "AEF");
  CHECK(told.names(reduced.before, reduced.dropped) == "A");
  CHECK(told.names(reduced.after) == "EF");
}

TEST_CASE("Right 4: from EF the search finds E again, no new point, and the sets are apart") {
  const Told told = right_no_test();
  const auto found = told.at<gjk::SupportFound>(4);
  CHECK(told.found(4) == "E");
  CHECK_FALSE(found.is_new);
  for (const int earlier : {1, 2, 3}) CHECK(told.at<gjk::SupportFound>(earlier).is_new);
  CHECK(found.vertex.w.dot(found.direction) < 0);
  CHECK(told.result().status == gjk::Status::separated);
  CHECK(told.result().reason == gjk::Reason::no_new_vertex);
  CHECK(told.result().iterations == 4);
  CHECK(letters_found(told) == "AEFE");
}

// -- Remarks ----------------------------------------------------------------------------------------------------------

TEST_CASE("Every remark of the walkthroughs is one that this file proves") {
  using List = std::vector<std::string>;
  const auto remarks = [](const std::string& name) {
    List list;
    for (const Remark& remark : walkthrough(name).remarks) {
      const char* const places[] = {"found", "crossing", "region", "reduced", "direction", "end"};
      list.push_back(places[static_cast<int>(remark.at)] + (" " + std::to_string(remark.iteration)) + ": " +
                     remark.text);
    }
    return list;
  };
  CHECK(remarks("figure-4-left") ==  // "Left 2" and "Left 3"
        List{"found 2: F is not returned, because E lies slightly farther",
             "found 3: straight down would have found F, but the slant finds G"});
  CHECK(remarks("figure-4-right") ==
        List{"end 2: Section 3.1.2 does not use the test yet and goes on to F"});  // "Right 2"
  CHECK(remarks("figure-4-right-no-crossing-test") ==                              // the next two tests
        List{"region 2: it lies beyond E, in R2, which only the crossing test would have noticed",
             "end 4: with the test of Section 3.1.3 it would have ended at E in iteration 2"});
  CHECK(remarks("figure-4") == List{});
  CHECK(remarks("figure-5") == List{});
}

TEST_CASE("Remark: the origin lies in R2 of segment AE, beyond E, and only the crossing test would rule that out") {
  const Told told = right_no_test();
  const Vec2 AE = told.corner('E') - told.corner('A');
  CHECK(AE.dot(origin - told.corner('E')) > 0);
  const Told on_the_left = left();
  CHECK((on_the_left.corner('E') - on_the_left.corner('A')).dot(origin - on_the_left.corner('E')) < 0);

  const auto simplex = told.at<gjk::VertexAdded>(2).simplex;
  const auto regions = all<gjk::RegionTested>(told.trace);
  const auto R2 = std::ranges::find_if(regions, [](const auto& r) { return r.iteration == 2 && r.label == "R2"; });
  REQUIRE(R2 != regions.end());
  CHECK(told.names(simplex, R2->feature) == "E");
  CHECK(R2->verdict == gjk::Verdict::skipped);
  CHECK(R2->reason == "only the crossing test rules this out, and this run does without it");
}

TEST_CASE("Remark: the crossing test ends the search at the first E, where the run without it goes on") {
  CHECK(right().found(right().result().iterations) == "E");
  CHECK(right().result().iterations == 2);
  CHECK(right_no_test().found(2) == "E");
  CHECK(right_no_test().result().iterations > 2);
}
