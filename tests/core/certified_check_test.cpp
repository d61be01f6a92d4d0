/// Certificates that prove what they say hold; all others do not.
#include "core/certified/check.hpp"

#include <limits>

#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace certified_check_test {

using V = Vec3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan = std::nan(""), above_1 = std::nextafter(1.0, 2.0), below_1 = std::nextafter(1.0, 0.0);

IndexPairs pairs(std::initializer_list<IndexPair> list) {
  IndexPairs all;
  for (const IndexPair& pair : list) all.add(pair);
  return all;
}

/// The points with these numbers, each minus the first of the other set.
IndexPairs of(std::initializer_list<int> indices) {
  IndexPairs all;
  for (const int i : indices) all.add({i, 0});
  return all;
}

const PointSet<double> origin({V::Zero()});

// -- A direction ------------------------------------------------------------------------------------------------------

const PointSet<double> low({V(0, 0, 0), V(5, 0, 0), V(0, 0, 1)}), high({V(9, 9, 3), V(0, 0, 2), V(-7, 0, 2)});

TEST_CASE("A direction separates two sets where every a·d < b·d", "[certificate]") {
  REQUIRE(holds(SeparatingDirection{V(0, 0, 1)}, low, high));
  REQUIRE(holds(SeparatingDirection{V(0, 0, 5e-324)}, low, high));
  REQUIRE(holds(SeparatingDirection{V(0.01, 0, 1e308)}, low, high));
  REQUIRE(holds(SeparatingDirection{V(0, 0, -1)}, high, low));
}

TEST_CASE("A direction that is turned over, askew, zero or no number does not", "[certificate]") {
  for (const V& d : {V(0, 0, -1), V(1, 0, 0), V(0, 1, 0), V(0, 0, 0), V(0, 0, infinity), V(0, 0, nan), V(nan, 0, 1),
                     V(0, -infinity, 1)}) {
    INFO("d = " << d.transpose());
    REQUIRE_FALSE(holds(SeparatingDirection{d}, low, high));
  }
  REQUIRE_FALSE(holds(SeparatingDirection{V(0, 0, 1)}, high, low));
}

TEST_CASE("A direction along which the sets touch does not, and one in which they are an ulp apart does",
          "[certificate]") {
  for (const V& d : {V(0, 0, 1), V(0, 0, 1e300), V(0, 0, 5e-324)}) {
    const PointSet<double> just_above({V(0, 0, above_1)}), touching({V(0, 0, 1), V(0, 0, 2)});
    REQUIRE(holds(SeparatingDirection{d}, low, just_above));
    REQUIRE_FALSE(holds(SeparatingDirection{d}, low, touching));
  }
}

TEST_CASE("All points of both sets are looked at, wherever they stand in the list", "[certificate]") {
  std::vector<V> below{V(0, 0, -1), V(0, 0, -2), V(0, 0, -3)}, above{V(0, 0, 1), V(0, 0, 2), V(0, 0, 3)};
  const SeparatingDirection up{V(0, 0, 1)};
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<V> reaching_up = below, reaching_down = above;
    reaching_up[i].z() = 1;
    reaching_down[i].z() = -1;
    REQUIRE(holds(up, PointSet<double>(below), PointSet<double>(above)));
    REQUIRE_FALSE(holds(up, PointSet<double>(reaching_up), PointSet<double>(above)));
    REQUIRE_FALSE(holds(up, PointSet<double>(below), PointSet<double>(reaching_down)));
  }
}

// -- A feature, and a simplex -----------------------------------------------------------------------------------------

/// Of a set of points and the origin alone.
struct Case {
  std::vector<V> points;
  IndexPairs of;
  bool holds;
};
template <class Certified>
void require_as_said(const std::vector<Case>& cases) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO("case " << i);
    REQUIRE(holds(Certified{cases[i].of}, PointSet<double>(cases[i].points), origin) == cases[i].holds);
  }
}

TEST_CASE("One, two or three points separate where all others lie beyond the nearest point of their line or plane",
          "[certificate]") {
  const std::vector<V> points{V(1, 1, 1), V(-2, 1, 1), V(1, -2, 1), V(3, 3, 1), V(0, 0, 9)};
  const auto and_at = [](double z) { return std::vector{V(1, 1, 1), V(-2, 1, 1), V(1, -2, 1), V(7, 7, z)}; };
  const std::vector<V> on_a_line{V(1, 0, 1), V(-1, 0, 1), V(1, 0, 1), V(3, 0, 1)};
  require_as_said<SeparatingFeature>({
      {points, of({0, 1, 2}), true},
      {points, of({2, 1, 0}), true},
      {{V(-1, 2, 2), V(1, 2, 2), V(0, 5, 5)}, of({0, 1}), true},
      {{V(-1, 2, 2), V(0, 2, 2), V(0, 5, 5)}, of({1}), true},
      {{V(1, 1, 1), V(2, 1, 1), V(1, 2, 1)}, of({0, 1, 2}), true},  // z = 1, though outside of their hull
      {and_at(1e-300), of({0, 1, 2}), true},                        // a point beside the plane through the origin
      {and_at(0.0), of({0, 1, 2}), false},
      {and_at(-1e-300), of({0, 1, 2}), false},
      {{V(0, 0, 0)}, of({0}), false},  // holding the origin
      {{V(-1, 2, 3), V(1, -2, -3)}, of({0, 1}), false},
      {{V(1, 1, 0), V(-2, 1, 0), V(1, -2, 0)}, of({0, 1, 2}), false},
      {on_a_line, of({0, 1}), true},
      {on_a_line, of({0, 0}), false},  // repeated or dependent
      {on_a_line, of({0, 2}), false},
      {on_a_line, of({0, 1, 1}), false},
      {on_a_line, of({0, 1, 2}), false},
      {on_a_line, of({0, 1, 3}), false},
      {points, of({}), false},
      {{V(1, 1, 1), V(-2, 1, 1), V(1, -2, 1), V(0, 0, 2)}, of({0, 1, 2, 3}), false},
  });
  const PointSet<double> a({V(0, 0, 0), V(4, 0, 0)}), b({V(0, 1, 0), V(3, 0, 1), V(3, 0, -1)});
  REQUIRE(holds(SeparatingFeature{pairs({{0, 0}, {1, 0}})}, a, PointSet<double>({b.points()[0]})));
  REQUIRE_FALSE(holds(SeparatingFeature{pairs({{1, 1}, {1, 2}})}, a, b));
}

TEST_CASE("One to four points are common where weights of at least 0 add them up to the origin", "[certificate]") {
  const std::vector<V> corners{V(-1, -1, -1), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)};
  const std::vector<V> dependent{V(1, 0, 0), V(-1, 0, 0), V(1, 0, 0), V(3, 0, 0), V(0, 1, 0)};
  const auto with = [](double x) { return std::vector{V(x, 1, 0), V(-1, -1, 0), V(0, 0, 1), V(3, -2, 0)}; };
  std::vector<Case> cases{
      {corners, of({0, 1, 2, 3}), true},
      {corners, of({2, 0, 3, 1}), true},
      {{V(1, 1, 0), V(-2, 1, 0), V(1, -2, 0)}, of({0, 1, 2}), true},
      {{V(1, 2, -3), V(-2, -4, 6)}, of({1, 0}), true},
      {{V(0, 0, 0)}, of({0}), true},
      {{V(0, 0, 0), V(1, 0, 0), V(0, 1, 0)}, of({0, 1, 2}), true},  // two weights are 0
      {{V(5e-324, 0, 0), V(1, 0, 0)}, of({0, 1}), false},
      {{V(1, 1, 0), V(-above_1, -1, 0)}, of({0, 1}), false},
      {with(below_1), of({0, 1, 2, 3}), true},
      {with(1), of({0, 1, 2, 3}), true},
      {with(above_1), of({0, 1, 2, 3}), false},
      {{V(1, 0, 0), V(2, 0, 0)}, of({0, 1}), false},
      {dependent, of({0, 1}), true},
      {dependent, of({0, 1, 1}), false},
      {dependent, of({0, 1, 2}), false},
      {dependent, of({0, 1, 3}), false},
      {dependent, of({0, 1, 3, 4}), false},
      {{V(0, 0, 0)}, of({0, 0}), false},
      {{V(0, 0, 0)}, of({}), false},
  };
  for (const double speck : {5e-324, -5e-324}) {  // an ulp beside the origin, in the plane or off it
    cases.push_back({{V(0, 0, speck)}, of({0}), false});
    cases.push_back({{V(1, speck, 0), V(-1, 0, 0)}, of({0, 1}), false});
    cases.push_back({{V(1, 1, speck), V(-2, 1, 0), V(1, -2, 0)}, of({0, 1, 2}), false});
  }
  for (std::size_t i = 0; i < 4; ++i) {  // a negative weight, whichever it is
    cases.push_back({corners, of({0, 1, 2, 3}), false});
    cases.back().points[i] *= -1;
  }
  require_as_said<CommonSimplex>(cases);
}

// -- All of them ------------------------------------------------------------------------------------------------------

TEST_CASE("A certificate with an index that is none does not hold", "[certificate]") {
  const PointSet<double> a({V(0, 0, 0), V(1, 0, 0)}), b({V(0, 0, 0), V(1, 0, 0), V(2, 0, 0)});
  for (const auto& [pair, is_one] :
       {std::pair(IndexPair{0, 0}, true), std::pair(IndexPair{1, 1}, true), std::pair(IndexPair{-1, 0}, false),
        std::pair(IndexPair{0, -1}, false), std::pair(IndexPair{2, 2}, false), std::pair(IndexPair{1, 3}, false),
        std::pair(IndexPair{std::numeric_limits<int>::min(), 0}, false),
        std::pair(IndexPair{0, std::numeric_limits<int>::max()}, false)}) {
    INFO("pair " << pair.a << ", " << pair.b);
    REQUIRE(holds(CommonSimplex{pairs({pair})}, a, b) == is_one);
    REQUIRE_FALSE(holds(SeparatingFeature{pairs({pair})}, a, b));
  }
}

TEST_CASE("The number after the last is no index, whatever the memory there holds", "[certificate]") {
  std::vector<V> points{V(1, 0, 0), V(0, 0, 0)};
  points.pop_back();
  const PointSet<double> a(std::move(points));
  REQUIRE_FALSE(holds(CommonSimplex{of({1})}, a, origin));
  REQUIRE_FALSE(holds(CommonSimplex{pairs({{0, 1}})}, origin, a));
}

TEST_CASE("Certificates of floats are multiplied out as those of doubles", "[certificate]") {
  using F = Vec3<float>;
  const PointSet<float> a({F(1, 0, 0), F(-1, 0, 0)}), touching({F(0, 0, 0)}), apart({F(0, 1e-45f, 0)});
  REQUIRE(holds(CommonSimplex{of({0, 1})}, a, touching));
  REQUIRE_FALSE(holds(CommonSimplex{of({0, 1})}, a, apart));
  REQUIRE(holds(SeparatingFeature{of({0, 1})}, a, apart));
  REQUIRE(holds(SeparatingDirection{V(0, 1, 0)}, a, apart));
  REQUIRE_FALSE(holds(SeparatingDirection{V(0, 1, 0)}, a, touching));
}

}  // namespace certified_check_test
}  // namespace gjk::test
