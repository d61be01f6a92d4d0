#include <algorithm>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/figure_1_sets.hpp"
#include "walkthroughs/catalogue/figure_2_pins.hpp"
#include "walkthroughs/catalogue/figure_3_objects.hpp"
#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/picture/outlines.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

double distance_to_segment(const Vec2& from, const Vec2& to, const Vec2& p) {
  const double at = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
  return (p - from - (to - from) * at).norm();
}

double distance_to_outline(const std::vector<Vec2>& polygon, const Vec2& p) {
  double least = (p - polygon[0]).norm();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, distance_to_segment(polygon[i], polygon[(i + 1) % polygon.size()], p));
  return least;
}

std::vector<Vec2> figure_3_differences() {
  std::vector<Vec2> differences;
  const PointSet C = figure_3_C(), D = figure_3_D();
  for (const Point& c : C.points())
    for (const Point& d : D.points()) differences.push_back((c - d).head<2>());
  return differences;
}

}  // namespace

// -- Figure 1 ---------------------------------------------------------------------------------------------------------

TEST_CASE("Figure 1: no chord of the solid disk leaves it, and one of the shortest long ones comes closest to that") {
  const ChordSearch search = decide_convexity(solid_disk());
  CHECK(search.tried == 289u * 288 / 2);
  CHECK(search.leaving == 0);
  CHECK(search.chord.outside.empty());
  CHECK_FALSE(search.witness);
  CHECK(search.chord.from.norm() == Approx(1));
  CHECK(search.chord.to.norm() == Approx(1));
  CHECK(search.chord.length() == Approx(1));  // 8 of 48 points farther around: a sixth of a turn
}

TEST_CASE("Figure 1: every chord of the circle leaves it and the one shown is a diameter, outside all along") {
  const ChordSearch search = decide_convexity(circle());
  CHECK(search.tried == 48u * 47 / 2);
  CHECK(search.leaving == search.tried);
  CHECK(search.chord.length() == Approx(2));
  REQUIRE(search.chord.outside.size() == 1);
  CHECK(search.chord.outside[0].from == Approx(0).margin(1e-6));
  CHECK(search.chord.outside[0].to == Approx(1).margin(1e-6));
  CHECK_FALSE(circle().contains(*search.witness));
}

TEST_CASE("Figure 1: the chord of the crescent starts and ends in it and crosses the gap, the witness on it") {
  const PlanarSet set = crescent();
  const ChordSearch search = decide_convexity(set);
  const Chord& chord = search.chord;
  CHECK(search.leaving > 0);
  CHECK(search.leaving < search.tried);
  CHECK(set.contains(chord.from));
  CHECK(set.contains(chord.to));
  REQUIRE(chord.outside.size() == 1);
  const auto [from, to] = chord.outside[0];
  CHECK((to - from) * chord.length() > 0.99 * 2 * Bite{}.radius);
  CHECK((to - from) * chord.length() <= 2 * Bite{}.radius + 1e-9);
  for (const double end : {from, to}) CHECK((chord.at(end) - Bite{}.center).norm() == Approx(Bite{}.radius));
  REQUIRE(search.witness);
  CHECK(set.excess(*search.witness) > 0.1);
  CHECK(distance_to_segment(chord.from, chord.to, *search.witness) == Approx(0).margin(1e-12));
}

TEST_CASE("A chord with two parts outside has both") {
  const PlanarSet ring{"ring of two gaps", [](const Vec2& p) {
                         const double x = p.x();
                         return (x > 0.2 && x < 0.3) || (x > 0.5 && x < 0.9) ? 1.0 : -1.0;
                       }};
  const ChordSearch search = deciding_chord(ring, {{0, 0}, {1, 0}}, 0);
  REQUIRE(search.chord.outside.size() == 2);
  CHECK(search.chord.outside[0].from == Approx(0.2));
  CHECK(search.chord.outside[0].to == Approx(0.3));
  CHECK(search.chord.outside[1].from == Approx(0.5));
  CHECK(search.chord.outside[1].to == Approx(0.9));
  CHECK(search.witness->x() == Approx(0.7));
}

// -- Figure 2 ---------------------------------------------------------------------------------------------------------

TEST_CASE("Figure 2: the hull contains all pins, and its corners are pins") {
  const std::vector<Vec2> pins = figure_2_pins(), hull = convex_hull(pins);
  CHECK(hull.size() < pins.size());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &p = hull[i], &q = hull[(i + 1) % hull.size()];
    CHECK(std::ranges::find(pins, p) != pins.end());
    for (const Vec2& pin : pins) CHECK((pin == p || pin == q || cross(q - p, pin - p) > 0));
  }
}

TEST_CASE("Figure 2: the stretched band keeps its distance from the hull and touches no pin") {
  const std::vector<Vec2> hull = convex_hull(figure_2_pins()), band = offset_outward(hull, 1.3);
  for (const Vec2& p : band) CHECK(distance_to_outline(hull, p) == Approx(1.3));
  CHECK(area(band) > area(hull));
  for (const Vec2& pin : figure_2_pins()) CHECK(distance_to_outline(band, pin) > 1.29);
}

TEST_CASE("A band around a polygon turns left all the way around, once") {
  const std::vector<Vec2> band = offset_outward({{0, 0}, {4, 0}, {0, 3}}, 0.5);
  double turned = 0;
  for (std::size_t i = 0; i < band.size(); ++i) {
    const Vec2 u = band[(i + 1) % band.size()] - band[i], v = band[(i + 2) % band.size()] - band[(i + 1) % band.size()];
    CHECK(cross(u, v) >= -1e-12);
    turned += std::atan2(cross(u, v), u.dot(v));
  }
  CHECK(turned == Approx(2 * std::numbers::pi));
}

// -- Figure 3 ---------------------------------------------------------------------------------------------------------

TEST_CASE(
    "Figure 3: two points of C are farthest along +x and two of D along -x, and x = -2 is that of the difference") {
  const auto on = [](const PointSet& set, double x) {
    return std::ranges::count_if(set.points(), [=](const Point& p) { return p.x() == x && p.z() == 0; });
  };
  const PointSet C = figure_3_C(), D = figure_3_D();
  CHECK(C.support({1, 0, 0}).point.x() == -1);
  CHECK(on(C, -1) == 2);
  CHECK(D.support({-1, 0, 0}).point.x() == 1);
  CHECK(on(D, 1) == 2);
  CHECK(gjk::MinkowskiDifference<double, PointSet, PointSet>(C, D).vertex({1, 0, 0}).w.x() == -2);
  for (const Vec2& w : figure_3_differences()) CHECK(w.x() <= -2);
}

TEST_CASE("Figure 3: the outline found by support functions is the hull of all differences") {
  const PointSet C = figure_3_C(), D = figure_3_D();
  std::vector<Vec2> outline = outline_by_support(gjk::MinkowskiDifference<double, PointSet, PointSet>(C, D), 360);
  const std::vector<Vec2> hull = convex_hull(figure_3_differences());
  const auto first = std::ranges::find(outline, hull.front());
  REQUIRE(first != outline.end());
  std::rotate(outline.begin(), first, outline.end());
  CHECK(outline == hull);
}

TEST_CASE("An outline is found whatever corner the first question finds") {
  for (int turn = 0; turn < 8; ++turn) {
    std::vector<Point> corners;
    for (int i = 0; i < 4; ++i) {
      const double angle = std::numbers::pi * (turn / 16.0 + i / 2.0) + 0.1;
      corners.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    CHECK(outline_by_support(gjk::PointSet<double>(corners), 360).size() == 4);
  }
}
