#include "walkthroughs/story/progress.hpp"

#include <limits>

#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/story/stories.hpp"

namespace progress_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Fraction;
using gjk::test::ExactVec;

namespace {

std::vector<Progress> progress_in(const std::string& name, std::size_t scene = 0) {
  return progress_of(tell(walkthrough(name)).tellings.at(scene));
}

/// Of a search that has found these vertices, and tells no more.
std::vector<Progress> progress_of_simplex(const std::vector<std::pair<Point, Point>>& vertices) {
  Simplex simplex;
  for (const auto& [a, b] : vertices) simplex.add({a, b, a - b});
  const Scene scene;
  return progress_of({scene, {{gjk::VertexAdded<double>{1, simplex}}}, {}, {}});
}
Progress only_progress(const std::vector<std::pair<Point, Point>>& vertices) {
  return progress_of_simplex(vertices).at(0);
}

/// The least square of all that are nearest on the line, plane or space of some vertices, and between them.
Fraction least_square(const std::vector<std::pair<Point, Point>>& vertices) {
  std::optional<Fraction> least;
  for (std::uint32_t chosen = 1; chosen < 1u << vertices.size(); ++chosen) {
    gjk::test::ExactVecs points;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (chosen & 1u << i) points.push_back(gjk::test::exact<double>(vertices[i].first - vertices[i].second));
    if (points.size() > 1 && gjk::test::gram_determinant(points) == 0) continue;
    if (std::ranges::any_of(gjk::test::coordinates_of_origin(points), [](const auto& t) { return t < 0; })) continue;
    const ExactVec way = gjk::test::toward_origin(points);
    const Fraction square(way.dot(way));
    if (!least || square < *least) least = square;
  }
  return least.value();
}

ExactVector vector_of(Fraction x, Fraction y, Fraction z = 0) { return {std::move(x), std::move(y), std::move(z)}; }

}  // namespace

TEST_CASE("Figure 4, left, comes nearer in each iteration, until the origin is in the triangle") {
  const std::vector<Progress> found = progress_in("figure-4-left");
  REQUIRE(found.size() == 4);
  CHECK(found[0].nearest == vector_of({15, 4}, {13, 4}));
  CHECK(found[1].nearest == vector_of({-3, 5}, {9, 5}));
  CHECK(found[1].on_a == vector_of({-23, 80}, {111, 80}));
  CHECK(found[1].on_b == vector_of({5, 16}, {-33, 80}));
  CHECK(found[2].nearest.dot(found[2].nearest) == Fraction(169, 578));
  CHECK(found[3].distance == 0);
  for (int i = 0; i < 4; ++i) CHECK(found[static_cast<std::size_t>(i)].iteration == i + 1);
}

TEST_CASE("Where the origin is not crossed the simplex stays, and its distance") {
  const std::vector<Progress> found = progress_in("figure-4-right");
  REQUIRE(found.size() == 2);
  CHECK(found[0].nearest == vector_of({17, 4}, {9, 2}));
  CHECK(found[1].nearest == found[0].nearest);
  CHECK(found[1].iteration == 2);
  CHECK(progress_told(found, 2, Dimension::plane) ==
        "After iteration 2 the kept simplex is 6.18971 from the origin. Nearest there: (2.5, 2) of a, (−1.75, −2.5) of b.");
}

TEST_CASE("An iteration is known once nothing changes its simplex any more") {
  const Story story = tell(walkthrough("figure-4-left"));
  const auto& events = story.tellings[0].trace.events;
  const std::vector<Progress> found = progress_of(story.tellings[0]);
  CHECK(known_at(found, 0) == 0);
  CHECK(progress_told(found, 0, Dimension::plane) == "There is no simplex so far.");
  for (const Progress& each : found) {
    CHECK(iteration_of(events[each.event]) == each.iteration);
    CHECK(known_at(found, each.event - 1) == static_cast<std::size_t>(each.iteration) - 1);
    CHECK(known_at(found, each.event) == static_cast<std::size_t>(each.iteration));
  }
  CHECK(known_at(found, events.size() - 1) == found.size());
}

TEST_CASE("The nearest point is that of all sub-simplices, and the difference of its witness points") {
  kit::Dice dice(7);
  int inside = 0, repeated = 0;
  for (int i = 0; i < 400; ++i) {
    const double size = i % 4 == 0 ? 1e-60 : i % 4 == 1 ? 1e60 : 1;
    const bool in_plane = dice.coin();
    const auto point = [&]() -> Point {
      return Point(dice.between(-3, 3), dice.between(-3, 3), in_plane ? 0 : dice.between(-3, 3)) * size;
    };
    std::vector<std::pair<Point, Point>> vertices;
    for (int k = dice.between(1, 4); k-- > 0;) vertices.emplace_back(point(), point());
    const Progress found = only_progress(vertices);
    const Fraction square = least_square(vertices);
    CHECK(found.nearest.dot(found.nearest) == square);
    if (size == 1) CHECK(found.on_a - found.on_b == found.nearest);  // whole numbers: a − b is not rounded
    CHECK(std::isfinite(found.distance));
    CHECK((found.distance == 0) == (square == 0));
    inside += square == 0;
    repeated += vertices.size() > 1 && vertices[0].first - vertices[0].second == vertices[1].first - vertices[1].second;
  }
  CHECK(inside > 40);
  CHECK(repeated > 0);
}

TEST_CASE("Vertices that are one point, or as large or small as a scene may have them, have a distance") {
  const std::pair<Point, Point> one{{3, 4, 0}, {0, 0, 0}};
  CHECK(only_progress({one, one, one, one}).distance == 5);
  CHECK(only_progress({{{1e150, 0, 0}, {-1e150, 0, 0}}, {{0, 1e-150, 0}, {0, 0, 0}}}).distance == 1e-150);
  CHECK(only_progress({{{3e-320, 0, 0}, {0, 0, 0}}}).distance == 3e-320);
  CHECK(only_progress({{{3e150, 4e150, 0}, {0, 0, 0}}}).distance == 5e150);
  CHECK(progress_of_simplex({{{std::numeric_limits<double>::infinity(), 0, 0}, {0, 0, 0}}}).empty());
}

TEST_CASE("A search that goes round in a circle is where it was before, and no nearer") {
  int circles = 0;
  for (const Story& story : whole_searches()) {
    const auto cycle_start = all<gjk::Finished>(story.tellings[0].trace).at(0).result.cycle_start;
    if (!cycle_start) continue;
    ++circles;
    INFO(story.walkthrough.name);
    const std::vector<Progress> found = progress_of(story.tellings[0]);
    const auto before = std::ranges::find(found, *cycle_start - 1, &Progress::iteration);
    REQUIRE(before != found.end());
    CHECK(before + 1 != found.end());
    CHECK(found.back().nearest == before->nearest);
  }
  CHECK(circles > 1);
}

TEST_CASE("Every search of the catalogue has finite distances, in sentences of at most 25 words", "[unsanitized]") {
  for (const Walkthrough& w : whole_catalogue()) {
    INFO(w.name);
    const Story story = tell(w);
    for (const Telling& telling : story.tellings) {
      const std::vector<Progress> found = progress_of(telling);
      CHECK(found.empty() == all<gjk::VertexAdded>(telling.trace).empty());
      for (std::size_t known = 1; known <= found.size(); ++known) {
        CHECK(std::isfinite(found[known - 1].distance));
        CHECK((known == 1 || found[known - 2].iteration < found[known - 1].iteration));
        const std::string told = progress_told(found, known, telling.scene.dimension);
        const auto second = told.begin() + static_cast<std::ptrdiff_t>(told.find(" Nearest"));
        CHECK(std::count(told.begin(), second, ' ') < 25);
        CHECK(std::count(second, told.end(), ' ') < 26);
      }
    }
  }
}

}  // namespace progress_test
