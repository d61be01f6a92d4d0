/// The numbered properties of gjk.hpp, each over all runs of a large random set.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/core/oracle.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace properties_test {

struct ExactRun {
  PairOfHulls hulls;
  CrossingTest crossing_test;
  Run<Rational> run;
};

constexpr std::uint64_t seed = 7474;

/// Exact numbers, so that every sign below is the true one. Half of the runs do without the crossing test.
const std::vector<ExactRun>& exact_runs() {
  static const std::vector<ExactRun> runs = [] {
    std::vector<ExactRun> made;
    Dice dice(seed);
    for (int i = 0; i < 3000; ++i) {
      const PairOfHulls hulls = random_pair(dice);
      for (const CrossingTest test : {CrossingTest::on, CrossingTest::off}) {
        Options<Rational> options;
        options.crossing_test = test;
        made.push_back(
            {hulls, test, observed<Rational>(point_set<Rational>(hulls.a), point_set<Rational>(hulls.b), options)});
      }
    }
    return made;
  }();
  return runs;
}

// -- P1 ---------------------------------------------------------------------------------------------------------------

/// Runs that are likely to come upon a zero direction: they throw where one reaches a support function.
template <class S>
void require_directions_only(const AnyShape<S>& a, const AnyShape<S>& b) {
  for (const CrossingTest test : {CrossingTest::on, CrossingTest::off})
    for (const Point& first : Points{{1, 0, 0}, {0, 0, 0}, {1, -2, 3}}) {
      Options<S> options;
      options.first_direction = vec<S>(first);
      options.crossing_test = test;
      const int before = a.times_asked();
      REQUIRE_NOTHROW(asked<S>(a, b, options));
      REQUIRE(a.times_asked() - before <= options.iteration_limit);
      REQUIRE(a.times_asked() == b.times_asked());
    }
}

const std::vector<Points> degenerate_hulls{
    {{0, 0, 0}},
    {{1, -2, 3}},
    {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
    {{-1, 0, 0}, {1, 0, 0}},
    {{-2, 4, -6}, {-1, 2, -3}, {1, -2, 3}},
    {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
    {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
    {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
    {{-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1}, {1, -1, 1}, {1, 1, -1}, {1, 1, 1}}};

TEST_CASE("P1. The support function is never given the zero vector", "[properties]") {
  SECTION("degenerate pairs, from 1e-200 to 1e200: identical, single points, on a line, in a plane, touching") {
    for (const double scale : {1e-200, 1e-100, 1e-50, 1e-3, 1.0, 1e3, 1e50, 1e100, 1e200})
      for (const Points& a : degenerate_hulls)
        for (const Points& b : degenerate_hulls) require_directions_only<double>(scaled(a, scale), scaled(b, scale));
  }
  SECTION("degenerate pairs in exact numbers") {
    for (const Points& a : degenerate_hulls)
      for (const Points& b : degenerate_hulls)
        require_directions_only<Rational>(point_set<Rational>(a), point_set<Rational>(b));
  }
  SECTION("spheres: the same, with one center, touching, far apart; tiny and huge") {
    for (const double scale : {1e-200, 1e-100, 1.0, 1e100, 1e200})
      for (const double distance : {0.0, 1.0, 2.0, 3.0, 10.0}) {
        const Sphere<double> a(Vec3<double>(0, 0, 0), scale), b(Vec3<double>(0, distance * scale, 0), scale);
        require_directions_only<double>(a, b);
        require_directions_only<double>(a, scaled({{0, 1, 0}}, scale));
      }
  }
}

// -- P2 to P5 ---------------------------------------------------------------------------------------------------------

TEST_CASE(
    "P2. Every vertex of the simplex lies on the hull of the Minkowski difference: no point of the difference lies "
    "farther in the direction in which it was found",
    "[properties][unsanitized][full]") {
  for (const ExactRun& run : exact_runs()) {
    std::vector<Vec3<Rational>> found;
    for (const auto& event : run.run.events) {
      if (const auto* support = std::get_if<SupportFound<Rational>>(&event)) {
        found.push_back(support->vertex.w);
        const Rational reach = support->vertex.w.dot(support->direction);
        for (const Point& p : run.hulls.a)
          for (const Point& q : run.hulls.b)
            if ((vec<Rational>(p) - vec<Rational>(q)).dot(support->direction) > reach) FAIL("a farther point exists");
      }
      if (const auto* added = std::get_if<VertexAdded<Rational>>(&event))
        for (const auto& w : places(added->simplex)) REQUIRE(std::find(found.begin(), found.end(), w) != found.end());
    }
  }
}

TEST_CASE(
    "P3. A is the vertex added last. The others stay in the order in which they were added, except where Algorithm 4 "
    "moves below a triangle and where Algorithm 5 keeps a face",
    "[properties][unsanitized]") {
  std::set<std::string> in_order, reordered;
  for (const ExactRun& run : exact_runs()) {
    const SupportFound<Rational>* last = nullptr;
    for (const auto& event : run.run.events) {
      if (const auto* support = std::get_if<SupportFound<Rational>>(&event)) last = support;
      if (const auto* added = std::get_if<VertexAdded<Rational>>(&event))
        REQUIRE((added->simplex[Role::A] == last->vertex));
      if (const auto* reduced = std::get_if<SimplexReduced<Rational>>(&event)) {
        const std::string kept = to_string(reduced->kept);
        const bool oldest_first = std::is_sorted(kept.rbegin(), kept.rend());
        (oldest_first ? in_order : reordered).insert(std::to_string(reduced->before.size()) + ":" + kept);
      }
    }
  }
  REQUIRE(in_order == std::set<std::string>{"3:BA", "3:CA", "4:BA", "4:CA", "4:DA", "4:CBA", "4:DCA"});
  REQUIRE(reordered == std::set<std::string>{"3:CAB", "4:BDA"});
}

TEST_CASE("P4. Normals point away from the simplex: no vertex of the triangle or tetrahedron lies on their side of A",
          "[properties][unsanitized]") {
  int normals = 0;
  for (const ExactRun& run : exact_runs()) {
    Simplex<Rational> simplex;
    for (const auto& event : run.run.events) {
      if (const auto* added = std::get_if<VertexAdded<Rational>>(&event)) simplex = added->simplex;
      const auto* region = std::get_if<RegionTested<Rational>>(&event);
      if (!region || !region->normal) continue;
      ++normals;
      // An edge normal of Algorithm 5 belongs to its face; the fourth vertex may lie on either side.
      const Roles vertices = !region->face.empty() ? region->face : beside({}, simplex.size());
      for (const Role role : vertices) {
        const ExactVec AX = simplex.point(role) - simplex.point(Role::A);
        REQUIRE(region->normal->dot(AX) <= 0);
      }
    }
  }
  REQUIRE(normals > 5000);
}

TEST_CASE("P5. Of four vertices, A lies in the direction of BC×BD", "[properties][unsanitized]") {
  int tetrahedra = 0, flat = 0;
  for (const ExactRun& run : exact_runs())
    for (const auto& added : events_of_kind<VertexAdded<Rational>>(run.run.events)) {
      const auto& s = added.simplex;
      if (s.size() < 4) continue;
      ++tetrahedra;
      const Rational side = orientation(s.point(Role::A), s.point(Role::B), s.point(Role::C), s.point(Role::D));
      REQUIRE(side >= 0);
      if (side == 0) ++flat;
      // Only a search that goes on though it has not crossed the origin can add a vertex in the plane of BCD.
      if (run.crossing_test == CrossingTest::on) REQUIRE(side > 0);
    }
  INFO(flat << " of " << tetrahedra << " tetrahedra are flat");
  REQUIRE(tetrahedra > 1000);
  REQUIRE(flat < tetrahedra / 20);
}

}  // namespace properties_test
}  // namespace gjk::test
