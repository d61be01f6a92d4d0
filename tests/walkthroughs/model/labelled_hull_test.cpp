#include "walkthroughs/model/labelled_hull.hpp"

#include <numbers>
#include <set>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

namespace labelled_hull_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

using Corners = std::vector<Vec2>;

Corners hull_of(const std::vector<Point>& points) { return difference_hull(walkthrough_of(points).scenes[0]).corners; }

std::vector<Point> circle(int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.emplace_back(100 * std::cos(angle), 100 * std::sin(angle), 0);
  }
  return points;
}

}  // namespace

TEST_CASE("A hull is counter-clockwise from the corner farthest along +x, whatever the order of the points") {
  std::vector<Point> points = {{0, 0, 0}, {3, 1, 0}, {2, 3, 0}, {-1, 2, 0}, {1, 1, 0}};
  std::ranges::sort(points, {}, [](const Point& p) { return std::pair(p.x(), p.y()); });
  const auto less = [](const Point& p, const Point& q) { return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y()); };
  do {
    REQUIRE(hull_of(points) == Corners{{3, 1}, {2, 3}, {-1, 2}, {0, 0}});
  } while (std::ranges::next_permutation(points, less).found);
}

TEST_CASE("Of two corners equally far along +x the upper is A; points on an edge, or given twice, are none") {
  CHECK(hull_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) == Corners{{1, 1}, {0, 1}, {0, 0}, {1, 0}});
  CHECK(hull_of({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {3, 3, 0}, {2, 6, 0}, {1, 3, 0}}) == Corners{{4, 0}, {2, 6}, {0, 0}});
  CHECK(hull_of({{0, 0, 0}, {4, 0, 0}, {4, 0, 0}, {2, 6, 0}, {0, 0, 0}}) == Corners{{4, 0}, {2, 6}, {0, 0}});
  CHECK(hull_of({{1, 1, 0}, {3, 3, 0}, {2, 2, 0}}) == Corners{{3, 3}, {1, 1}});
  CHECK(hull_of({{2, 5, 0}, {2, -1, 0}, {2, 0, 0}}) == Corners{{2, 5}, {2, -1}});
  CHECK(hull_of({{1, 2, 0}, {1, 2, 0}, {1, 2, 0}}) == Corners{{1, 2}});
}

TEST_CASE("No difference of two vertices lies outside the hull, and every corner is one") {
  std::set<Dimension> seen;
  for (const Walkthrough& w : whole_catalogue()) {
    for (const Scene& scene : w.scenes) {
      const Corners corners = difference_hull(scene).corners;
      if (!corners.empty()) seen.insert(scene.dimension);
      std::vector<Vec2> differences;
      for (const Point& a : vertices_of(scene.a))
        for (const Point& b : vertices_of(scene.b)) differences.push_back((a - b).head<2>());
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const auto times = std::ranges::count(differences, p);
        CHECK((scene.dimension == Dimension::plane ? times == 1 : times >= 1));  // in space others may lie below
        for (const Vec2& w_point : differences) CHECK(cross(q - p, w_point - p) >= 0);
      }
    }
  }
  CHECK(seen == std::set{Dimension::plane, Dimension::space});
}

TEST_CASE("More corners than letters have names of their own") {
  const Corners corners = hull_of(circle(60));
  REQUIRE(corners.size() == 60);
  const LabelledHull hull{corners};
  std::vector<std::string> names;
  for (const Vec2& corner : corners) names.push_back(hull.name({corner.x(), corner.y(), 0}));
  CHECK(names.front() == "A");
  CHECK(names[25] == "Z");
  CHECK(names[26] == "A1");
  std::ranges::sort(names);
  CHECK(std::ranges::adjacent_find(names) == names.end());
}

}  // namespace labelled_hull_test
