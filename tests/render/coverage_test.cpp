#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/triangles.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"

namespace coverage_test {

using namespace render;

namespace {

const Box bounds{{-5, -5}, {45, 45}};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The integral of the coverage: each cell is a fan of triangles over which it is linear.
double integral(std::span<const Vec2> corners) {
  double sum = 0;
  for (const CoverageCell& cell : coverage_cells(corners, bounds)) {
    for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
      const double area = cross(cell[i].position - cell[0].position, cell[i + 1].position - cell[0].position) / 2;
      sum += std::abs(area) * (cell[0].coverage + cell[i].coverage + cell[i + 1].coverage) / 3;
    }
  }
  return sum;
}

/// The coverage at `p`, and how many triangles hold `p`: one, unless it lies on a border.
struct Probe {
  double coverage = 0;
  int triangles = 0;
};

Probe probe(std::span<const Vec2> corners, const Vec2& p) {
  Probe result;
  for (const CoverageCell& cell : coverage_cells(corners, bounds)) {
    for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
      const Vec2 a = cell[i].position - cell[0].position, b = cell[i + 1].position - cell[0].position;
      const Vec2 at = p - cell[0].position;
      const double area = cross(a, b);
      if (area == 0) continue;
      const double s = cross(at, b) / area, t = cross(a, at) / area;
      if (s < -1e-9 || t < -1e-9 || s + t > 1 + 1e-9) continue;
      ++result.triangles;
      result.coverage = (1 - s - t) * cell[0].coverage + s * cell[i].coverage + t * cell[i + 1].coverage;
    }
  }
  return result;
}

double area_of(std::span<const Vec2> corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], corners[(i + 1) % corners.size()]) / 2;
  return std::abs(area);
}

}  // namespace

TEST_CASE("coverage of a large polygon: whole inside, half on the edge, none outside, in either sense") {
  std::vector<Vec2> square = {{10, 10}, {30, 10}, {30, 30}, {10, 30}};
  for (int sense = 0; sense < 2; ++sense) {
    REQUIRE(probe(square, {20.1, 20.3}).coverage == Approx(1));
    REQUIRE(probe(square, {20.1, 10}).coverage == Approx(0.5));
    REQUIRE(probe(square, {29.75, 20.3}).coverage == Approx(0.75));
    REQUIRE(probe(square, {20.1, 9.4}).coverage == 0);
    std::reverse(square.begin(), square.end());
  }
}

TEST_CASE("the integral of the coverage is the area: random triangles") {
  kit::Dice dice(7);
  const auto any_point = [&] { return Vec2(dice.between(0.0, 40.0), dice.between(0.0, 40.0)); };
  for (int i = 0; i < 500; ++i) {
    const std::array triangle = {any_point(), any_point(), any_point()};
    double perimeter = 0;
    for (std::size_t k = 0; k < 3; ++k) perimeter += (triangle[k] - triangle[(k + 1) % 3]).norm();
    INFO("triangle " << i << " of seed 7");
    REQUIRE(integral(triangle) == Approx(area_of(triangle)).epsilon(0.02).margin(0.5 + 0.01 * perimeter));
  }
}

TEST_CASE("needles and strips thinner than a pixel fade in proportion to their width") {
  for (const double width : {0.01, 0.1, 0.3, 0.7}) {
    const std::array strip = {Vec2(5, 20), Vec2(35, 20), Vec2(35, 20 + width), Vec2(5, 20 + width)};
    REQUIRE(probe(strip, {20.1, 20 + width / 2}).coverage == Approx(width));
    REQUIRE(integral(strip) == Approx(30 * width).epsilon(0.05));
    const std::array needle = {Vec2(5, 20), Vec2(35, 20), Vec2(5, 20 + width)};
    REQUIRE(integral(needle) == Approx(15 * width).epsilon(0.15));
  }
}

TEST_CASE("the cells tile the polygon: no cracks and no overlaps") {
  std::vector<Vec2> polygon;
  for (int i = 0; i < 11; ++i) polygon.push_back(Vec2(20, 20) + 14 * Vec2(std::cos(i * 0.571), std::sin(i * 0.571)));
  kit::Dice dice(11);
  for (int i = 0; i < 2000; ++i) {
    const double a = dice.between(0.0, 6.283), r = dice.between(0.0, 13.0);
    REQUIRE(probe(polygon, Vec2(20, 20) + r * Vec2(std::cos(a), std::sin(a))).triangles == 1);
  }
}

TEST_CASE("a polygon without area has no cells") {
  REQUIRE(coverage_cells(std::array{Vec2(1, 1), Vec2(5, 5), Vec2(9, 9)}, bounds).empty());
  REQUIRE(coverage_cells(std::array{Vec2(1, 1), Vec2(1, 1), Vec2(1, 1)}, bounds).empty());
  REQUIRE(coverage_cells({}, bounds).empty());
}

TEST_CASE("a polygon with more corners than pixels is covered as it is, by few cells") {
  constexpr int count = 3000;
  std::vector<Vec2> disc;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    disc.emplace_back(20 + 15 * std::cos(angle), 20 + 15 * std::sin(angle));
  }
  REQUIRE(integral(disc) == Approx(area_of(disc)).epsilon(2e-3));
  REQUIRE(coverage_cells(disc, bounds).size() < 200);
}

}  // namespace coverage_test
