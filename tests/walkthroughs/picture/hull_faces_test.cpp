// Hulls held against what is known of a body, and against each plane through three points.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "walkthroughs/picture/body.hpp"

namespace hull_faces_test {

using namespace walkthroughs;
using namespace walkthroughs::picture;

namespace {

using Faces = std::vector<render::Face>;
using Key = std::array<double, 3>;

Points grid(int count) {
  Points points;
  for (int x = 0; x < count; ++x)
    for (int y = 0; y < count; ++y)
      for (int z = 0; z < count; ++z) points.emplace_back(x, y, z);
  return points;
}

Points prism(int sides) {
  Points points;
  for (int i = 0; i < sides; ++i)
    for (const double z : {-1.0, 1.0}) {
      const double angle = 2 * std::numbers::pi * i / sides;
      points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  return points;
}

Points in_ball(int count, std::uint64_t seed) {
  kit::Dice dice(seed);
  Points points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0), z = dice.between(-1.0, 1.0);
    if (const Point p(x, y, z); p.norm() <= 1) points.push_back(p);
  }
  return points;
}

Points on_sphere(int count, std::uint64_t seed) {
  Points points = in_ball(count, seed);
  for (Point& p : points) p.normalize();
  return points;
}

/// Returns: turned, which rounds, and moved.
Points askew(Points points, double angle) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point(1, -2, 3).normalized()).toRotationMatrix();
  for (Point& p : points) p = turn * p + Point(5, 6, 7);
  return points;
}

Points differences(const Points& a, const Points& b) {
  Points points;
  for (const Point& p : a)
    for (const Point& q : b) points.push_back(p - q);
  return points;
}

Points scaled(Points points, double by) {
  for (Point& p : points) p *= by;
  return points;
}

Key key(const Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<Key> keys(const Points& points) {
  std::vector<Key> list;
  for (const Point& p : points) list.push_back(key(p));
  return list;
}

/// How many faces have how many corners.
std::map<std::size_t, int> sizes(const Points& points) {
  std::map<std::size_t, int> found;
  for (const render::Face& face : hull_faces(points)) ++found[face.corners.size()];
  return found;
}
using Sizes = std::map<std::size_t, int>;

/// Each edge belongs to two faces, one each way around; and the faces are those of one body (Euler).
void check_is_closed(const Faces& faces) {
  std::set<std::pair<Key, Key>> edges;
  std::set<Key> corners;
  std::size_t count = 0;
  for (const render::Face& face : faces)
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const Point &from = face.corners[i], &to = face.corners[(i + 1) % face.corners.size()];
      edges.emplace(key(from), key(to));
      ++count;
      corners.insert(key(from));
    }
  CHECK(edges.size() == count);
  CHECK(std::ranges::all_of(edges, [&](const auto& edge) { return edges.contains({edge.second, edge.first}); }));
  CHECK(corners.size() + faces.size() == edges.size() / 2 + 2);
}

/// No point is above a face, and each face is flat and convex, as far as rounding lets tell.
/// Requires: lengths whose products are numbers.
void check_is_hull(const Points& points) {
  const Faces faces = hull_faces(points);
  check_is_closed(faces);
  double size = 0;
  for (const Point& p : points) size = std::max(size, p.norm());
  for (const render::Face& face : faces) {
    const Point outward = face.outward().normalized();
    const std::size_t n = face.corners.size();
    const auto is_above = [&](const Point& p) { return outward.dot(p - face.corners[0]) > 1e-13 * size; };
    CHECK(std::ranges::none_of(points, is_above));
    for (std::size_t i = 0; i < n; ++i) {
      const Point &p = face.corners[i], &q = face.corners[(i + 1) % n], &r = face.corners[(i + 2) % n];
      CHECK(outward.dot((q - p).cross(r - q)) > 0);
      CHECK(std::abs(outward.dot(q - p)) <= 1e-13 * size);
    }
  }
}

/// Returns: the triangles of points in general position, each from its first corner on: all with every other point below.
std::set<std::vector<Key>> by_trying_all(const Points& points) {
  std::set<std::vector<Key>> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = i + 1; k < points.size(); ++k) {
        const Point &a = points[i], &b = points[j], &c = points[k], normal = (b - a).cross(c - a);
        const auto is_below = [&](const Point& p) { return &p == &a || &p == &b || &p == &c || normal.dot(p - a) < 0; };
        if (j != k && std::ranges::all_of(points, is_below)) found.insert(keys({a, b, c}));
      }
  return found;
}

/// Returns: of each corner of each face which point it is.
std::vector<std::vector<std::size_t>> indices(const Faces& faces, const Points& points) {
  std::vector<std::vector<std::size_t>> list;
  for (const render::Face& face : faces) {
    list.emplace_back();
    for (const Point& corner : face.corners)
      list.back().push_back(static_cast<std::size_t>(std::ranges::find(points, corner) - points.begin()));
  }
  return list;
}

}  // namespace

TEST_CASE("Faces of known bodies are whole, whatever lies on or in them") {
  CHECK(sizes(grid(2)) == Sizes{{4, 6}});
  CHECK(sizes(grid(5)) == Sizes{{4, 6}});
  CHECK(sizes(askew(grid(5), 0.7)) == Sizes{{4, 6}});
  CHECK(sizes({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}}) == Sizes{{3, 8}});
  CHECK(sizes(prism(100)) == Sizes{{4, 100}, {100, 2}});
  CHECK(sizes(askew(prism(100), 0.7)) == Sizes{{4, 100}, {100, 2}});
  CHECK(sizes(differences(grid(3), grid(4))) == Sizes{{4, 6}});
  for (const Points& points : {grid(5), askew(grid(5), 0.7), prism(100), askew(prism(100), 0.7)}) check_is_hull(points);
}

TEST_CASE("Of random points the faces are the triangles that no other point is above") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Points points = seed % 2 == 0 ? in_ball(30, seed) : on_sphere(20, seed);
    std::set<std::vector<Key>> found;
    for (const render::Face& face : hull_faces(points)) found.insert(keys(face.corners));
    CHECK(found == by_trying_all(points));
  }
}

TEST_CASE("A thin face is one, also where it is turned") {
  for (int i = 0; i < 100; ++i) {
    Points points = grid(4);
    for (Point& p : points) p = Point(p.x() + 0.5 * p.y(), 1e-4 * p.y(), 1e-4 * p.z() + 0.3 * p.x());
    CHECK(sizes(askew(points, 0.01 * i)) == Sizes{{4, 6}});
  }
}

TEST_CASE("Many points have a hull that is closed, and none is outside") {
  check_is_hull(in_ball(2000, 1));
  check_is_hull(on_sphere(500, 2));
  CHECK(hull_faces(on_sphere(500, 2)).size() == 996);
}

TEST_CASE("Rounded differences of polytopes have the faces of their sum") {
  // Two boxes askew: six faces each, and one more, both ways, for each two edges.
  for (int i = 1; i <= 100; ++i) {
    const Points points = differences(grid(2), askew(grid(2), 0.01 * i));
    CHECK(sizes(points) == Sizes{{4, 30}});
    check_is_hull(points);
    CHECK(sizes(differences(askew(grid(2), 0.7), askew(grid(3), 0.7))) == Sizes{{4, 6}});
    CHECK(sizes(differences(askew(grid(3), 0.01 * i), askew(grid(3), 0.01 * i))) == Sizes{{4, 6}});
  }
  check_is_hull(differences(prism(30), askew(prism(20), 0.7)));
}

TEST_CASE("What is flat but for rounding has no faces, nor has what is no number") {
  Points line, plane;
  for (const Point& p : grid(4)) {
    line.push_back(Point(1, 2, 3) * p.x());
    plane.emplace_back(p.x(), p.y(), p.x() + p.y());
  }
  for (const Points& points : {Points{}, Points(3, Point(1, 2, 3)), Points(9, Point(1, 2, 3)), Points(9, Point::Zero()),
                               line, plane, askew(line, 0.7), askew(plane, 0.7), askew(plane, 1.1),
                               scaled(askew(plane, 0.7), 1e150), scaled(askew(plane, 0.7), 1e-150)})
    CHECK(hull_faces(points).empty());
  Points damaged = grid(2);
  damaged[5].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(hull_faces(damaged).empty());
  damaged[5].y() = std::numeric_limits<double>::infinity();
  CHECK(hull_faces(damaged).empty());
}

TEST_CASE("What is nearly flat is whole or flat") {
  kit::Dice dice(3);
  for (int i = 0; i <= 340; ++i)
    for (const double as_thick : {1.0, std::pow(10, -i / 20.0)})
      for (Points points : {in_ball(50, 4), grid(3)}) {
        for (Point& p : points) p = Point(p.x(), p.y() * as_thick, p.z() * std::pow(10, -i / 20.0));
        for (const Points& some : {points, askew(points, dice.between(0.0, 6.0))})
          if (const Faces faces = hull_faces(some); !faces.empty()) {
            CHECK(faces.size() >= 4);
            check_is_closed(faces);
          }
      }
}

TEST_CASE("Points that come more than once, their order, and their scale change no face") {
  const Points points = askew(grid(3), 0.7);
  const Faces faces = hull_faces(points);
  Points twice = points;
  twice.insert(twice.end(), points.begin(), points.end());
  CHECK(hull_faces(twice).size() == 6);
  Points backwards(points.rbegin(), points.rend());
  CHECK(hull_faces(backwards).size() == 6);
  for (const double scale : {0x1p-500, 0x1p+500}) {
    const Faces other = hull_faces(scaled(points, scale));
    REQUIRE(other.size() == faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) CHECK(other[i].corners == scaled(faces[i].corners, scale));
  }
  CHECK(sizes(scaled(grid(3), 1e-150)) == Sizes{{4, 6}});
  CHECK(sizes(scaled(grid(3), 1e150)) == Sizes{{4, 6}});
  CHECK(sizes(scaled(grid(3), 5e307)) == Sizes{{4, 6}});
}

TEST_CASE("Of points on a coarse grid, few or many, faces are whole, and come by their first points") {
  kit::Dice dice(5);
  for (int i = 0; i < 500; ++i) {
    Points points;
    for (int n = dice.between(4, 40); n > 0; --n) {
      const int x = dice.between(-2, 2), y = dice.between(-2, 2), z = dice.between(-2, 2);
      if (const Point p(x, y, z); std::ranges::find(points, p) == points.end()) points.push_back(p);
    }
    const Faces faces = hull_faces(points);
    if (faces.empty()) continue;  // they may be flat
    check_is_hull(points);
    const std::vector<std::vector<std::size_t>> found = indices(faces, points);
    CHECK(std::ranges::is_sorted(found));
    for (const auto& corners : found) CHECK(std::ranges::min_element(corners) == corners.begin());
  }
  CHECK(indices(hull_faces(grid(2)), grid(2)) ==
        std::vector<std::vector<std::size_t>>{
            {0, 1, 3, 2}, {0, 2, 6, 4}, {0, 4, 5, 1}, {1, 5, 7, 3}, {2, 3, 7, 6}, {4, 6, 7, 5}});
}

}  // namespace hull_faces_test
