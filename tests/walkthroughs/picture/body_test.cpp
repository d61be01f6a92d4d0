// Outlines and flat parts of objects, held against formulas and against support functions.

#include "walkthroughs/picture/body.hpp"

#include <numbers>

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/polygons.hpp"
#include "tests/walkthroughs/shapes.hpp"

namespace body_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

constexpr double pi = std::numbers::pi;

Cylinder can() { return {{0.5, 0, 0}, {1, 2, 2}, 0.6, 2}; }
Points segment() { return {{-1, 0, 0}, {2, 0, 0}}; }

Points around(int count, double z_of_base) {
  Points rim;
  for (int i = 0; i < count; ++i)
    rim.emplace_back(std::cos(2 * pi * i / count), std::sin(2 * pi * i / count), z_of_base);
  return rim;
}

Points cone(int count) {
  Points points = around(count, 0);
  points.emplace_back(0, 0, 2);
  return points;
}

Points on_ball(int count, std::uint64_t seed = 1) {
  kit::Dice dice(seed);
  Points points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0), z = dice.between(-1.0, 1.0);
    if (const Point p(x, y, z); p.norm() <= 1) points.push_back(p.normalized());
  }
  return points;
}

Pose askew() { return {Eigen::AngleAxisd(0.7, Point(1, -2, 3).normalized()).toRotationMatrix(), Point(5, 6, 7)}; }

Lens from_above_the_side() { return {render::Camera(35, 25)}; }

std::vector<Vec2> outline_of(const AnyShape& shape, const Lens& lens, const Pose& pose = {}) {
  const Object object{"object", shape, pose};
  return outline(object, body_of(object, lens.camera ? Dimension::space : Dimension::plane), lens);
}

double reach(const std::vector<Vec2>& polygon, const Vec2& d) {
  double most = polygon.at(0).dot(d);
  for (const Vec2& p : polygon) most = std::max(most, p.dot(d));
  return most;
}

std::size_t flats_of(const AnyShape& shape, const Pose& pose = {}) {
  return body_of({"object", shape, pose}, Dimension::space).flats.size();
}

/// The outline reaches as far as the support function of the object says, in each direction of the picture.
void check_is_outline(const AnyShape& shape, const Lens& lens, const Pose& pose) {
  const std::vector<Vec2> found = outline_of(shape, lens, pose);
  const Object object{"object", shape, pose};
  const AskedObject<double> asked(object);
  for (int i = 0; i < 101; ++i) {
    const double angle = 2 * pi * i / 101;
    const Point d = lens.direction(angle);
    const Vec2 in_picture(std::cos(angle), std::sin(angle));
    CHECK(reach(found, in_picture) == Approx(asked.support(d).point.dot(d)).margin(4e-3));
  }
  CHECK(area(found) >= 0);
}

}  // namespace

TEST_CASE("Every outline reaches as far as the support function of its object, flat and through a camera") {
  const AnyShape flat_shapes[] = {triangle(), ball(1), Sum{{triangle(), ball(0.5)}}, Sum{{ball(0.2), segment()}},
                                  Sum{{Sum{{triangle(), segment()}}, Ball{{1, 2, 0}, 0.5}}}};
  for (const AnyShape& shape : flat_shapes)
    check_is_outline(shape, Lens{}, {Eigen::AngleAxisd(0.4, Point::UnitZ()).toRotationMatrix(), Point(1, -2, 0)});
  const AnyShape shapes[] = {box(1, 2, 3),
                             ball(1),
                             can(),
                             Sum{{segment(), ball(0.5)}},
                             Sum{{box(1, 2, 0.5), ball(0.5)}},
                             Sum{{can(), ball(0.5)}},
                             Sum{{box(1, 1, 1), can()}},
                             Sum{{can(), Cylinder{{0, 0, 1}, {0, 1, 0}, 1, 1}}},
                             Sum{{box(1, 1, 1), Points{{0, 0, 0}, {1, 1, 1}}}},
                             Sum{{Sum{{triangle(), segment()}}, Sum{{can(), ball(1)}}}}};
  for (const AnyShape& shape : shapes) check_is_outline(shape, from_above_the_side(), askew());
}

TEST_CASE("Sums of point sets are polytopes with the faces of their sum") {
  const Body body = body_of({"prism", Sum{{box(1, 1, 1), Points{{0, 0, 0}, {1, 1, 1}}}}, {}}, Dimension::space);
  CHECK(body.vertices.size() == 14);  // a cube drawn out along its diagonal: a rhombic dodecahedron
  CHECK(body.faces.size() == 12);
  CHECK(body.flats.empty());
  const Body flat = body_of({"pentagon", Sum{{triangle(), segment()}}, {}}, Dimension::plane);
  CHECK(flat.vertices.size() == 4);
}

TEST_CASE("What is flat in space has two sides, and a line has none") {
  const std::vector<render::Face> sides = body_of({"triangle", triangle(), askew()}, Dimension::space).faces;
  REQUIRE(sides.size() == 2);
  CHECK((sides[0].outward() + sides[1].outward()).norm() < 1e-9);
  CHECK(sides[0].outward().norm() > 1);
  CHECK(body_of({"segment", segment(), askew()}, Dimension::space).faces.empty());
  CHECK(body_of({"triangle", triangle(), {}}, Dimension::plane).faces.empty());
}

TEST_CASE("What of a round object is flat: caps, the faces of a rounded box, nothing of a capsule") {
  const auto flats = [](const AnyShape& shape) { return flats_of(shape, askew()); };
  CHECK(flats(ball(1)) == 0);
  CHECK(flats(can()) == 2);
  CHECK(flats(Sum{{segment(), ball(1)}}) == 0);
  CHECK(flats(Sum{{triangle(), ball(1)}}) == 2);
  CHECK(flats(Sum{{box(1, 2, 3), ball(1)}}) == 6);
  CHECK(flats(Sum{{can(), ball(1)}}) == 2);
  CHECK(flats(Sum{{box(1, 1, 1), Cylinder{{0, 0, 0}, {0, 0, 1}, 1, 1}}}) == 6);
  CHECK(flats(Sum{{box(1, 1, 1), can()}}) == 6 + 2 + 6);  // an axis askew makes a flat part with each edge, both ways
}

TEST_CASE("Which parts are flat depends neither on where an object lies nor on the order of its points") {
  CHECK(flats_of(Sum{{Points{{1, 2, 3}, {5, 2, 3}, {1, 5, 4}}, ball(1)}}) == 2);
  kit::Dice dice(7474);
  for (int i = 0; i < 100; ++i) {
    Points points(6);
    for (Point& p : points)
      for (double& x : p) x = dice.between(-4, 4);
    const std::size_t expected = flats_of(Sum{{points, can()}});
    std::ranges::reverse(points);
    CAPTURE(i);
    CHECK(flats_of(Sum{{points, can()}}) == expected);
  }
}

TEST_CASE("Each flat part lies where its object ends, and its rim in one plane") {
  const AnyShape shape = Sum{{Sum{{box(1, 1, 1), can()}}, ball(0.3)}};
  const Object object{"object", shape, askew()};
  const AskedObject<double> asked(object);
  for (const Flat& flat : body_of(object, Dimension::space).flats) {
    const double reach = asked.support(flat.outward).point.dot(flat.outward);
    for (const Point& p : flat.rim) CHECK(p.dot(flat.outward) == Approx(reach).margin(1e-9));
  }
}

TEST_CASE("A sum of point sets with too many corners has no faces and still its outline") {
  const AnyShape shape = Sum{{on_ball(300, 1), on_ball(300, 2)}};
  CHECK(body_of({"object", shape, {}}, Dimension::space).vertices.empty());
  check_is_outline(shape, from_above_the_side(), {});
}

TEST_CASE("A body with more corners than a picture can show is drawn as its outline, and only then") {
  for (const Points& many : {on_ball(1500), on_ball(20'000), cone(1200), cone(50'000)}) {
    const Object object{"many", many, {}};
    const Body body = body_of(object, Dimension::space);
    CHECK(body.only_outline);
    CHECK(body.faces.empty());
    const std::vector<Vec2> found = outline(object, body, from_above_the_side());
    CHECK(found.size() < 800);
    CHECK(area(found) > 1);
  }
  const Body few = body_of({"few", on_ball(900), {}}, Dimension::space);
  CHECK_FALSE(few.only_outline);
  CHECK(few.faces.size() == 2 * 900 - 4);
  CHECK(body_of({"cone", cone(900), {}}, Dimension::space).faces.size() == 901);
  Points inside = box(1, 1, 1);  // of many points eight are corners
  for (const Point& p : on_ball(5000)) inside.push_back(p / 2);
  CHECK(body_of({"box", inside, {}}, Dimension::space).faces.size() == 6);
}

TEST_CASE("What sticks out between the directions that are looked along is part of the hull") {
  Points points = box(1, 1, 1);
  for (const Point& p : on_ball(1500)) points.push_back(p / 2);
  points.emplace_back(0.3, 0.2, 1.0005);  // above a face, farthest only in directions very near its normal
  const Body body = body_of({"roof", points, {}}, Dimension::space);
  CHECK(body.vertices.size() == 9);
  CHECK(body.faces.size() == 9);
}

TEST_CASE("An outline in the plane has no more corners than are seen, and stays where it was") {
  const std::vector<Vec2> found = outline_of(around(100'000, 0), Lens{});
  CHECK(found.size() < 800);
  CHECK(area(found) == Approx(pi).epsilon(1e-4));
  CHECK(outline_of(around(300, 0), Lens{}).size() == 300);
}

}  // namespace body_test
