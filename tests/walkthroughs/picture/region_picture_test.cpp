// The regions as pictures draw them: they tile the picture, and a point lies in the region of its nearest feature.

#include "walkthroughs/picture/region_picture.hpp"

#include <random>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using Polygon = std::vector<Vec2>;

namespace {

constexpr double half_side = 10;
const Polygon clip = {
    {-half_side, -half_side}, {half_side, -half_side}, {half_side, half_side}, {-half_side, half_side}};

class Random {
 public:
  double operator()(double limit) { return std::uniform_real_distribution<double>(-limit, limit)(engine_); }
  Vec2 point(double limit) {
    const double x = (*this)(limit);
    return {x, (*this)(limit)};
  }

 private:
  std::mt19937 engine_{2015};
};

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return std::abs(twice) / 2;
}

/// Returns: whether `p` lies in a convex polygon whose corners go around either way.
bool contains(const Polygon& polygon, const Vec2& p) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double side = cross(polygon[(i + 1) % polygon.size()] - polygon[i], p - polygon[i]);
    left = left || side > 0;
    right = right || side < 0;
  }
  return polygon.size() > 2 && !(left && right);
}

/// Returns: the numbers of all regions that hold `p`, from 1.
std::vector<int> numbers_at(const std::vector<Polygon>& regions, const Vec2& p) {
  std::vector<int> found;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (contains(regions[i], p)) found.push_back(static_cast<int>(i) + 1);
  return found;
}

/// Returns: where on the segment from `P` to `Q` its nearest point to `p` is: 0 at P, 1 at Q.
double place_of_nearest(const Vec2& P, const Vec2& Q, const Vec2& p) {
  return std::clamp((p - P).dot(Q - P) / (Q - P).squaredNorm(), 0.0, 1.0);
}

/// Returns: the number of the region of Fig. 7, told from the feature of ABC that is nearest to `p`.
int number_by_distance(const Vec2& A, const Vec2& B, const Vec2& C, const Vec2& p) {
  if (triangle_contains(A, B, C, p)) return 1;
  struct Side {
    Vec2 from, to;
    int at_from, between, at_to;
  };
  int number = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Side& side : {Side{A, B, 2, 3, 4}, Side{B, C, 4, 5, 6}, Side{C, A, 6, 7, 2}}) {
    const double t = place_of_nearest(side.from, side.to, p);
    const double distance = (side.from + t * (side.to - side.from) - p).norm();
    if (distance >= least) continue;
    least = distance;
    number = t == 0 ? side.at_from : t == 1 ? side.at_to : side.between;
  }
  return number;
}

}  // namespace

TEST_CASE("The regions of a triangle tile the picture and a point lies in that of its nearest feature") {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const Vec2 A = random.point(5), B = random.point(5), C = random.point(5);
    if (std::abs(cross(B - A, C - A)) < 0.5) continue;
    const std::vector<Polygon> regions = regions_of_triangle(A, B, C, clip);
    REQUIRE(regions.size() == 7);
    double sum = 0;
    for (const Polygon& region : regions) sum += area(region);
    CHECK(std::abs(sum - area(clip)) < 1e-9 * area(clip));
    for (int i = 0; i < 50; ++i) {
      const Vec2 p = random.point(half_side);
      CHECK(numbers_at(regions, p) == std::vector<int>{number_by_distance(A, B, C, p)});
    }
  }
}

TEST_CASE("The regions of a segment tile the picture and are numbered as in Fig. 6") {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const Vec2 A = random.point(5), B = random.point(5);
    if ((B - A).norm() < 0.1) continue;
    const std::vector<Polygon> regions = regions_of_segment(A, B, clip);
    REQUIRE(regions.size() == 4);
    double sum = 0;
    for (const Polygon& region : regions) sum += area(region);
    CHECK(std::abs(sum - area(clip)) < 1e-9 * area(clip));
    for (int i = 0; i < 50; ++i) {
      const Vec2 p = random.point(half_side);
      const double t = place_of_nearest(B, A, p);  // B was there first
      const int number = t == 0 ? 1 : t == 1 ? 2 : cross(A - B, p - B) > 0 ? 3 : 4;
      CHECK(numbers_at(regions, p) == std::vector<int>{number});
    }
  }
}
