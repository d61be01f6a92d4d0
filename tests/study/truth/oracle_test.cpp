#include "tests/study/truth/oracle.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "tests/kit/catch.hpp"
#include "tests/study/pairs/hulls.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/linear_program.hpp"
#include "tests/study/truth/oracle_cgal.hpp"
#include "walkthroughs/judge/how_far.hpp"
#include "walkthroughs/pairs/graded.hpp"

namespace study {
namespace oracle_test {

constexpr Truth separated = Truth::separated, intersecting = Truth::intersecting;
constexpr double ulp = 0x1p-52;  // of numbers from 1 to 2

// -- What proves the answer ----------------------------------------------------------------------------------------------

Points box_at(double x) {
  Points corners;
  for (unsigned i = 0; i < 8; ++i) corners.emplace_back(x + (i & 1 ? 1 : 0), i & 2 ? 1 : 0, i & 4 ? 1 : 0);
  return corners;
}

TEST_CASE("Oracle: a judgement tells what proves it", "[oracle]") {
  const Points triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(judge({triangle, triangle}).proof == Proof::predicates);
  CHECK(judge({box_at(0), box_at(3)}).proof == Proof::certificate);
  CHECK(judge({Ball{{0, 0, 0}, 1}, Ball{{1, 0, 0}, 1}}).proof == Proof::formulas);
}

// -- Cases by hand ----------------------------------------------------------------------------------------------------

struct Case {
  std::string name;
  Points a, b;
  Truth truth;
};

const Points flat_triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const Points tetrahedron{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
const Points cube{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"one point, twice", {{1, 2, 3}}, {{1, 2, 3}}, intersecting},
      {"two points", {{1, 2, 3}}, {{1, 2, 4}}, separated},
      {"two points one ulp apart", {{1, 1, 1}}, {{1, 1, 1 + ulp}}, separated},
      {"a point on a segment", {{0, 0, 0}, {2, 4, 6}}, {{1, 2, 3}}, intersecting},
      {"a point on the line of a segment, beyond its end", {{0, 0, 0}, {2, 4, 6}}, {{3, 6, 9}}, separated},
      {"a point one ulp off a segment", {{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1 + ulp}}, separated},
      {"crossing segments", {{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 3, 0}}, intersecting},
      {"skew segments", {{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 1}, {0, 3, 1}}, separated},
      {"segments on one line, overlapping", {{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1}, {3, 3, 3}}, intersecting},
      {"segments on one line, end to end", {{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {3, 3, 3}}, intersecting},
      {"segments on one line, apart", {{0, 0, 0}, {1, 1, 1}}, {{2, 2, 2}, {3, 3, 3}}, separated},
      {"triangles that share a corner", flat_triangle, {{0, 0, 0}, {-1, 0, 1}, {0, -1, 1}}, intersecting},
      {"a corner on an edge", flat_triangle, {{2, 2, 0}, {3, 3, 1}, {3, 3, -1}}, intersecting},
      {"a corner inside a face", flat_triangle, {{1, 1, 0}, {1, 1, 1}, {2, 2, 1}}, intersecting},
      {"a corner one ulp above a face", flat_triangle, {{1, 1, ulp}, {1, 1, 1}, {2, 2, 1}}, separated},
      {"a corner one ulp below a face", flat_triangle, {{1, 1, -ulp}, {1, 1, 1}, {2, 2, 1}}, intersecting},
      {"a corner 10^-300 above a face", flat_triangle, {{1, 1, 1e-300}, {1, 1, 1}, {2, 2, 1}}, separated},
      {"a triangle through a triangle", flat_triangle, {{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}, intersecting},
      {"a triangle past a triangle", flat_triangle, {{3, 3, -1}, {3, 3, 1}, {9, 9, 1}}, separated},
      {"crossing edges of triangles", flat_triangle, {{1, -1, 1}, {1, 1, -1}, {1, -2, -2}}, intersecting},
      {"coplanar, one inside the other", flat_triangle, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, intersecting},
      {"coplanar, crossing without a corner inside", flat_triangle, {{1, -1, 0}, {1, 9, 0}, {2, -1, 0}}, intersecting},
      {"coplanar, an edge along an edge", flat_triangle, {{1, 0, 0}, {3, 0, 0}, {2, -1, 0}}, intersecting},
      {"coplanar, apart", flat_triangle, {{3, 3, 0}, {4, 3, 0}, {3, 4, 0}}, separated},
      {"coplanar, apart by one ulp",
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
       {{1 + ulp, 0, 0}, {2, 0, 0}, {2, 1, 0}},
       separated},
      {"parallel planes one ulp apart",
       {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
       {{0, 0, 1 + ulp}, {1, 0, 1 + ulp}, {0, 1, 1 + ulp}},
       separated},
      {"a collapsed triangle across a triangle", flat_triangle, {{1, 1, -1}, {1, 1, 0.5}, {1, 1, 2}}, intersecting},
      {"a collapsed triangle beside a triangle", flat_triangle, {{3, 3, -1}, {3, 3, 0.5}, {3, 3, 2}}, separated},
      {"a triangle of one point on a triangle", flat_triangle, {{2, 2, 0}, {2, 2, 0}, {2, 2, 0}}, intersecting},
      {"a triangle of one point beside one", flat_triangle, {{2, 2, 1}, {2, 2, 1}, {2, 2, 1}}, separated},
      {"a tetrahedron and a triangle inside it", tetrahedron, {{1, 1, 1}, {0.5, 1, 1}, {1, 0.5, 1}}, intersecting},
      {"a tetrahedron and a triangle on its slanted face",
       tetrahedron,
       {{2, 1, 1}, {1, 2, 1}, {1, 1, 2}},
       intersecting},
      {"a tetrahedron and a triangle just off that face",
       tetrahedron,
       {{2, 1, 1 + ulp}, {1, 2, 1 + ulp}, {1, 1, 2 + 2 * ulp}},
       separated},
      {"a tetrahedron in a tetrahedron",
       tetrahedron,
       {{0.5, 0.5, 0.5}, {1, 0.5, 0.5}, {0.5, 1, 0.5}, {0.5, 0.5, 1}},
       intersecting},
      {"tetrahedra that share a corner", tetrahedron, {{4, 0, 0}, {5, 0, 0}, {5, 1, 0}, {5, 0, 1}}, intersecting},
      {"tetrahedra whose edges cross", tetrahedron, {{1, -1, 1}, {1, 1, -1}, {1, -2, -2}, {2, -2, -2}}, intersecting},
      {"tetrahedra with a face in common", tetrahedron, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}}, intersecting},
      {"tetrahedra face to face, apart", tetrahedron, {{0, 0, -1}, {4, 0, -1}, {0, 4, -1}, {1, 1, -2}}, separated},
      {"a flat tetrahedron through a tetrahedron",
       tetrahedron,
       {{1, 1, 1}, {9, 1, 1}, {1, 9, 1}, {9, 9, 1}},
       intersecting},
      {"a flat tetrahedron above a tetrahedron",
       tetrahedron,
       {{-9, -9, 5}, {9, -9, 5}, {-9, 9, 5}, {9, 9, 5}},
       separated},
      {"a flat tetrahedron on a corner", tetrahedron, {{-9, -9, 4}, {9, -9, 4}, {-9, 9, 4}, {9, 9, 4}}, intersecting},
      {"cubes with a corner in common", cube, plus({2, 2, 2}, cube), intersecting},
      {"cubes with an edge in common", cube, plus({2, 2, 0}, cube), intersecting},
      {"cubes with a face in common", cube, plus({2, 0, 0}, cube), intersecting},
      {"cubes, the same", cube, cube, intersecting},
      {"cubes one ulp apart",
       cube,
       {{2 + 2 * ulp, 0, 0}, {3, 0, 0}, {2 + 2 * ulp, 2, 0}, {3, 2, 0}, {3, 0, 2}},
       separated},
      {"a point inside a cube", cube, {{1, 1, 1}}, intersecting},
      {"a segment whose ends are listed more than once, and a point of it",
       {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {2, 2, 2}, {2, 2, 2}},
       {{1, 1, 1}, {1, 1, 1}},
       intersecting},
      {"a point one ulp outside a cube", cube, {{1, 1, 2 + 2 * ulp}}, separated},
  };
  return all;
}

void require_truth(const Points& a, const Points& b, Truth expected) {
  REQUIRE(truth({a, b}) == expected);
  REQUIRE(truth({b, a}) == expected);
  REQUIRE(truth_by_linear_program(a, b) == expected);
  REQUIRE(truth_by_linear_program(b, a) == expected);
}

TEST_CASE("Oracle: cases by hand", "[oracle]") {
  for (const Case& c : cases()) {
    INFO(c.name);
    require_truth(c.a, c.b, c.truth);
  }
}

TEST_CASE("Oracle: the same in other units, from 2^-332 to 2^332", "[oracle]") {
  for (const Case& c : cases()) {
    if (c.name.find("10^-300") != std::string::npos) continue;  // which these units do not reach
    for (const double unit : {0x1p-332, 0x1p-40, 0x1p40, 0x1p332}) {
      INFO(c.name << ", times " << unit);
      require_truth(times(unit, c.a), times(unit, c.b), c.truth);
    }
  }
}

TEST_CASE("Oracle: the same in every mirror and order of the axes", "[oracle]") {
  const auto changed = [](Points points) {
    for (Vec& p : points) p = Vec(-p[1], p[2], -p[0]);
    return points;
  };
  for (const Case& c : cases()) {
    INFO(c.name);
    require_truth(changed(c.a), changed(c.b), c.truth);
  }
}

TEST_CASE("Oracle: the same with points in the other order, and with repeated ones", "[oracle]") {
  for (const Case& c : cases()) {
    INFO(c.name);
    const Points reversed(c.a.rbegin(), c.a.rend());
    require_truth(reversed, c.b, c.truth);
    Points twice = c.b;
    twice.insert(twice.begin(), c.b.begin(), c.b.end());
    require_truth(c.a, twice, c.truth);
  }
}

TEST_CASE("Oracle: CGAL judges triangles and tetrahedra, and none that is flattened", "[oracle]") {
  REQUIRE(truth_by_cgal(flat_triangle, tetrahedron) == intersecting);
  REQUIRE_FALSE(truth_by_cgal(flat_triangle, {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).has_value());
  REQUIRE_FALSE(truth_by_cgal(tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).has_value());
  REQUIRE_FALSE(truth_by_cgal(cube, tetrahedron).has_value());
}

// -- One way against another ------------------------------------------------------------------------------------------

bool is_certified_hit(const Points& a, const Points& b) {
  const Certificate found = certificate(a, b);
  REQUIRE(std::visit([&](const auto& proof) { return holds(proof, a, b); }, found));
  return std::holds_alternative<CommonPoint>(found);
}

TEST_CASE("Oracle: predicates and certificates agree on every family of points", "[oracle]") {
  int judged_by_predicates = 0, pairs = 0;
  for (const Family& family : families())
    for (std::uint64_t index = 0; index < 60; ++index) {
      const Pair pair = family.make(2, index);
      if (!std::holds_alternative<Points>(pair.a)) continue;
      INFO(family.name << " " << index);
      const Points &a = points(pair.a), &b = points(pair.b);
      const Truth certified = is_certified_hit(a, b) ? intersecting : separated;
      const auto by_predicates = truth_by_cgal(a, b);
      if (by_predicates) REQUIRE(*by_predicates == certified);
      REQUIRE(truth(pair) == certified);
      judged_by_predicates += by_predicates ? 1 : 0;
      ++pairs;
    }
  REQUIRE(judged_by_predicates > 1500);
  REQUIRE(pairs > judged_by_predicates + 400);
}

/// These prove what the judge holds programs against, by a search of ours; CGAL's solver knows nothing of it.
TEST_CASE(
    "Oracle: the judge's truth, and what it says only touches, are CGAL's on fresh pairs of every family of points, "
    "graded ones, too",
    "[oracle][unsanitized]") {
  constexpr std::uint64_t seed = 47, of_each = 512;
  int pairs = 0, meeting = 0, touching = 0;
  for (const auto* const list : {&families(), &walkthroughs::pairs::graded_families()})
    for (const Family& family : *list)
      for (std::uint64_t index = 0; index < std::min(of_each, family.size.value_or(of_each)); ++index) {
        const auto pair = walkthroughs::pairs::points_of(family.make(seed, index));
        if (!pair) break;
        INFO(family.name << " " << index << " of seed " << seed);
        const bool meet = truth({pair->a, pair->b}) == intersecting;
        REQUIRE((walkthroughs::judge::truth_of(*pair) == gjk::Status::intersecting) == meet);
        const bool touch = meet && hulls_only_touch(pair->a, pair->b);
        if (meet) REQUIRE(walkthroughs::judge::only_touch(*pair, false) == touch);
        ++pairs;
        meeting += meet;
        touching += touch;
      }
  WARN(pairs << " pairs of seed " << seed << ", of which " << meeting << " meet and " << touching
             << " of these only touch");
  REQUIRE(meeting > pairs / 4);
  REQUIRE(meeting < pairs * 3 / 4);
  REQUIRE(touching > 100);
}

Points whole_points(Dice& dice, int reach) {
  Points points(4);
  for (Vec& p : points)
    for (double& coordinate : p) coordinate = static_cast<double>(dice.whole(-reach, reach));
  return points;
}

bool is_flat(const Points& t) { return (t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0]) == 0; }

/// Closed tetrahedra are apart exactly where a face normal of either, or a vector perpendicular to an edge of each, separates
/// them.
///
/// Requires: neither is flat; whole coordinates below 10^4, so that nothing rounds.
bool separating_axes_find_none(const Points& a, const Points& b) {
  std::vector<Vec> edges;
  for (const Points* t : {&a, &b})
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) edges.push_back((*t)[i] - (*t)[j]);
  const auto are_ordered_along = [](const Vec& axis, const Points& less, const Points& more) {
    const auto reach = [&](const Vec& p) { return p.dot(axis); };
    return std::ranges::max(less, {}, reach).dot(axis) < std::ranges::min(more, {}, reach).dot(axis);
  };
  for (const Vec& e : edges)
    for (const Vec& f : edges)
      if (are_ordered_along(e.cross(f), a, b)) return false;  // the other order is that of f×e
  return true;
}

TEST_CASE("Oracle: as the separating axes say, on tetrahedra of whole numbers", "[oracle][unsanitized]") {
  int hits = 0, pairs = 0;
  for (const int reach : {2, 5, 1000})
    for (std::uint64_t index = 0; index < 1000; ++index) {
      Dice dice(1, "whole tetrahedra", index);
      const Points a = whole_points(dice, reach);
      Points b = whole_points(dice, reach);
      for (Vec& p : b) p += Vec(reach / 2, reach / 2, 0);
      if (is_flat(a) || is_flat(b)) continue;
      INFO("reach " << reach << ", index " << index);
      const bool meet = separating_axes_find_none(a, b);
      require_truth(a, b, meet ? intersecting : separated);
      hits += meet ? 1 : 0;
      ++pairs;
    }
  INFO(hits << " of " << pairs << " meet");
  REQUIRE((hits > pairs / 4 && hits < pairs * 3 / 4));
}

TEST_CASE("Oracle: boxes square to the axes meet exactly where all their intervals do", "[oracle]") {
  int hits = 0;
  for (std::uint64_t index = 0; index < 500; ++index) {
    Dice dice(1, "intervals", index);
    Points a, b;
    bool meet = true;
    std::array<std::array<double, 4>, 3> ends;
    for (auto& [a0, a1, b0, b1] : ends) {
      a0 = dice.whole(0, 4), a1 = a0 + dice.whole(0, 3), b0 = dice.whole(0, 4), b1 = b0 + dice.whole(0, 3);
      meet = meet && a0 <= b1 && b0 <= a1;
    }
    for (unsigned i = 0; i < 8; ++i) {
      const std::size_t x = i & 1, y = i >> 1 & 1, z = i >> 2;
      a.emplace_back(ends[0][x], ends[1][y], ends[2][z]);
      b.emplace_back(ends[0][2 + x], ends[1][2 + y], ends[2][2 + z]);
    }
    INFO(index);
    require_truth(a, b, meet ? intersecting : separated);
    hits += meet ? 1 : 0;
  }
  REQUIRE((hits > 100 && hits < 400));
}

}  // namespace oracle_test
}  // namespace study
