#include "walkthroughs/picture/near_origin.hpp"

#include <cmath>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace near_origin_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

/// Whether two points agree but for their last digits, coordinate by coordinate.
bool agree(const Point& p, const Point& q) { return ((p - q).array().abs() <= 1e-14 * q.stableNorm()).all(); }

}  // namespace

TEST_CASE("The foot of the origin on a line has all its digits, however near the line runs") {
  for (int e = 0; e <= 300; e += 10) {
    const double gap = std::pow(10, -e);
    INFO(e);
    CHECK(agree(foot_on_line({-3, gap, 0}, {2, gap, 0}), {0, gap, 0}));
    CHECK(agree(nearest_of_segment({gap, gap, 0}, {3, 2, 0}), {gap, gap, 0}));
    CHECK(agree(foot_on_line({gap, 0, 1}, {gap, 0, -2}), {gap, 0, 0}));
    CHECK(agree(foot_on_plane({3, 7, gap}, {0, 0, 5}), {0, 0, gap}));
    const auto [foot, is_inside] = foot_in_triangle({-1, -1, gap}, {2, -1, gap}, {0, 3, gap});
    CHECK(is_inside);
    CHECK(agree(foot, {0, 0, gap}));
  }
  // (1 + ε)(1 − ε) − 1 = −ε², of which nothing is left where each product is rounded
  const double ulp = 0x1p-52, length = std::sqrt(2.0);
  CHECK(foot_on_line({1 + ulp, 1, 0}, {-1, -(1 - ulp), 0}).norm() > 0);
  CHECK(foot_on_line({1 + ulp, 1, 0}, {-1, ulp - 1, 0}).norm() < 2 * ulp * ulp / length);
}

TEST_CASE("The foot on a plane or line that is far away, or on one of tiny points, is the same") {
  CHECK(agree(foot_on_line({1e-200, 0, 0}, {0, 1e-200, 0}), {5e-201, 5e-201, 0}));
  CHECK(agree(foot_on_plane({2e200, 0, 0}, {1e-150, 0, 0}), {2e200, 0, 0}));
  CHECK(foot_on_line({1, 2, 3}, {1, 2, 3}) == Point(1, 2, 3));
  CHECK_FALSE(foot_in_triangle({1, 1, 1}, {2, 1, 1}, {1, 2, 1}).is_inside);
}

TEST_CASE("Of a segment what is near the origin keeps its ends, and what is cut off is cut on its line") {
  const auto [from, to] = part_near_origin({-1, 1e-200, 0}, {1e-200, 1e-200, 0}, 1e-197);
  CHECK(agree(from, {-1e-197, 1e-200, 0}));
  CHECK(to == Point(1e-200, 1e-200, 0));
  CHECK(part_near_origin({1, 1, 0}, {1, 2, 0}, 1e-9).first == Point(1, 1, 0));  // nothing of it is
}

}  // namespace near_origin_test
