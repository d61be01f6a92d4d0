#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "core/gjk.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/pairs/hulls.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/linear_program.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace families_test {

constexpr std::uint64_t seed = 1;

bool begins_with(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }
bool ends_with(const std::string& text, const std::string& with) {
  return text.size() >= with.size() && text.compare(text.size() - with.size(), with.size(), with) == 0;
}

/// The first pairs of a family, at most `count`.
std::vector<Pair> pairs_of(const Family& family, std::uint64_t count) {
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < std::min(count, family.size.value_or(count)); ++i)
    pairs.push_back(family.make(seed, i));
  return pairs;
}

std::vector<Pair> pairs_of(const std::string& name, std::uint64_t count) { return pairs_of(family_named(name), count); }

std::size_t hits(const std::vector<Pair>& pairs) {
  return static_cast<std::size_t>(
      std::ranges::count_if(pairs, [](const Pair& p) { return truth(p) == Truth::intersecting; }));
}

/// All numbers of a pair in order, to compare pairs by.
std::vector<double> numbers(const Pair& pair) {
  std::vector<double> all;
  const auto add = [&](const Vec& v) { all.insert(all.end(), v.begin(), v.end()); };
  for (const Body* body : {&pair.a, &pair.b}) {
    if (const auto* hull = std::get_if<Points>(body)) std::ranges::for_each(*hull, add);
    if (const auto* ball = std::get_if<Ball>(body)) add(ball->center), all.push_back(ball->radius);
    if (const auto* can = std::get_if<Can>(body)) {
      add(can->center), add(can->axis);
      all.insert(all.end(), {can->radius, can->height});
    }
  }
  return all;
}

double rounded_to_float(double x) { return static_cast<double>(static_cast<float>(x)); }

bool fits_in_float(const Pair& pair) {
  return std::ranges::all_of(numbers(pair), [](double x) { return rounded_to_float(x) == x; });
}

Pair in_floats(Pair pair) {
  for (Body* body : {&pair.a, &pair.b})
    for (Vec& p : std::get<Points>(*body))
      for (double& coordinate : p) coordinate = rounded_to_float(coordinate);
  return pair;
}

double diameter(const Points& points) {
  double longest = 0;
  for (const Vec& p : points)
    for (const Vec& q : points) longest = std::max(longest, (p - q).norm());
  return longest;
}

// -- All families -----------------------------------------------------------------------------------------------------

TEST_CASE("Families: no two have the same name, and each says in one line what it is", "[families]") {
  std::set<std::string> names;
  for (const Family& family : families()) {
    INFO(family.name);
    REQUIRE(names.insert(family.name).second);
    REQUIRE_FALSE(family.what.empty());
    REQUIRE(family.what.find('\n') == std::string::npos);
    REQUIRE(&family_named(family.name) == &family);
  }
}

TEST_CASE("Families: of an unknown one the error names the nearest", "[families]") {
  REQUIRE_THROWS_WITH(family_named("tetrahedron"), "there is no family 'tetrahedron'; did you mean 'tetrahedra'?");
}

TEST_CASE("Families: the same pair for the same seed and index, in any order", "[families]") {
  for (const Family& family : families()) {
    INFO(family.name);
    const auto third = numbers(family.make(7, 3));
    family.make(7, 4);
    REQUIRE(numbers(family.make(7, 3)) == third);
  }
}

TEST_CASE("Families: other pairs for other indexes, and for other seeds unless all are listed", "[families]") {
  for (const Family& family : families()) {
    INFO(family.name);
    REQUIRE(numbers(family.make(7, 3)) != numbers(family.make(7, 4)));
    REQUIRE((numbers(family.make(7, 3)) == numbers(family.make(8, 3))) == family.size.has_value());
  }
}

TEST_CASE("Families: every number is finite, every radius and height positive", "[families]") {
  for (const Family& family : families())
    for (const Pair& pair : pairs_of(family, 100)) {
      INFO(family.name);
      REQUIRE(std::ranges::all_of(numbers(pair), [](double x) { return std::isfinite(x); }));
      for (const Body* body : {&pair.a, &pair.b}) {
        if (const auto* hull = std::get_if<Points>(body)) REQUIRE_FALSE(hull->empty());
        if (const auto* ball = std::get_if<Ball>(body)) REQUIRE(ball->radius > 0);
        if (const auto* can = std::get_if<Can>(body)) REQUIRE((can->radius > 0 && can->height > 0));
      }
    }
}

/// Families whose nature is another: 28 % of the triangles meet, all that touch, and what small grids have.
double expected_share(const std::string& name) {
  if (begins_with(name, "touching-")) return 1;
  static const std::map<std::string, double> shares{
      {"triangles", 0.28}, {"grid-segments", 0.2}, {"grid-triangles", 0.76}, {"grid-triangles-flat", 0.85}};
  const auto found = shares.find(name);
  return found != shares.end() ? found->second : 0.5;
}

TEST_CASE("Families: about half of the pairs meet, or the share that is in the family's nature",
          "[families][unsanitized]") {
  for (const Family& family : families()) {
    const auto pairs = pairs_of(family, 400);
    const double share = static_cast<double>(hits(pairs)) / static_cast<double>(pairs.size());
    const double expected = expected_share(family.name);
    INFO(family.name << ": " << share);
    REQUIRE(std::abs(share - expected) <= (expected == 0.5 ? 0.2 : expected == 1 ? 0 : 0.08));
  }
}

// -- Touching ---------------------------------------------------------------------------------------------------------

/// Where all signed orders of (1, 0, 0) or (1, 2, 2) can lead.
std::vector<Vec> normals(const Vec& of) {
  std::vector<Vec> all;
  for (const Vec& p : {Vec(of[0], of[1], of[2]), Vec(of[1], of[0], of[2]), Vec(of[1], of[2], of[0])})
    for (unsigned signs = 0; signs < 8; ++signs)
      all.emplace_back(signs & 1 ? -p[0] : p[0], signs & 2 ? -p[1] : p[1], signs & 4 ? -p[2] : p[2]);
  return all;
}

/// Whole numbers: nothing is rounded.
bool plane_is_between(const Vec& normal, const Pair& pair) {
  double a_most = -HUGE_VAL, b_least = HUGE_VAL;
  for (const Vec& p : points(pair.a)) a_most = std::max(a_most, normal.dot(p));
  for (const Vec& p : points(pair.b)) b_least = std::min(b_least, normal.dot(p));
  return a_most == b_least;
}

std::size_t in_plane(const Vec& normal, const Points& points, double height) {
  return static_cast<std::size_t>(std::ranges::count_if(points, [&](const Vec& p) { return normal.dot(p) == height; }));
}

struct Touching {
  std::size_t a, b;  // corners in the plane between them
  Pair apart;        // A moved off B by the least step
};

Touching examined(const Pair& pair, const std::vector<Vec>& normals) {
  const auto found = std::ranges::find_if(normals, [&](const Vec& n) { return plane_is_between(n, pair); });
  REQUIRE(found != normals.end());
  double height = -HUGE_VAL;
  for (const Vec& p : points(pair.a)) height = std::max(height, found->dot(p));
  return {in_plane(*found, points(pair.a), height),
          in_plane(*found, points(pair.b), height),
          {plus(-0x1p-28 * *found, points(pair.a)), pair.b}};
}

void require_touching(const std::string& name, const std::set<std::set<std::size_t>>& contacts) {
  const bool askew = ends_with(name, "-askew");
  std::set<std::set<std::size_t>> seen;
  for (const Pair& pair : pairs_of(name, 200)) {
    REQUIRE(fits_in_float(pair));
    REQUIRE(truth(pair) == Truth::intersecting);
    const Touching touching = examined(pair, normals(askew ? Vec(1, 2, 2) : Vec(1, 0, 0)));
    REQUIRE(truth(touching.apart) == Truth::separated);
    seen.insert({touching.a, touching.b});
  }
  REQUIRE(seen == contacts);
}

TEST_CASE("Families: touching at a vertex: it is on a vertex, an edge or a face, and the least step parts them",
          "[families]") {
  for (const std::string name : {"touching-vertex", "touching-vertex-askew"}) {
    INFO(name);
    require_touching(name, {{1}, {1, 2}, {1, 3}});
  }
}

TEST_CASE("Families: touching at an edge: it is on an edge or a face, and the least step parts them", "[families]") {
  for (const std::string name : {"touching-edge", "touching-edge-askew"}) {
    INFO(name);
    require_touching(name, {{2}, {2, 3}});
  }
}

TEST_CASE("Families: touching at a face: it is on a face, and the least step parts them", "[families]") {
  for (const std::string name : {"touching-face", "touching-face-askew"}) {
    INFO(name);
    require_touching(name, {{3}});
  }
}

TEST_CASE("Families: one ulp off touching, in single precision all touch", "[families]") {
  for (const std::string name : {"one-ulp", "one-ulp-askew"}) {
    INFO(name);
    const auto pairs = pairs_of(name, 200);
    REQUIRE((hits(pairs) > 60 && hits(pairs) < 140));
    for (const Pair& pair : pairs) {
      REQUIRE_FALSE(fits_in_float(pair));
      REQUIRE(truth(in_floats(pair)) == Truth::intersecting);
    }
  }
}

TEST_CASE("Families: one ulp of single precision off touching, single precision holds it", "[families]") {
  for (const std::string name : {"one-float-ulp", "one-float-ulp-askew"}) {
    INFO(name);
    const auto pairs = pairs_of(name, 200);
    REQUIRE((hits(pairs) > 60 && hits(pairs) < 140));
    REQUIRE(std::ranges::all_of(pairs, fits_in_float));
  }
}

/// Moved along any axis by `step`, does the answer change?
bool is_within(double step, const Pair& pair) {
  for (const Vec& normal : normals({1, 0, 0}))
    if (truth({plus(step * normal, points(pair.a)), pair.b}) != truth(pair)) return true;
  return false;
}

TEST_CASE("Families: a rounded vertex on a face is within a few ulps of touching", "[families]") {
  for (const Pair& pair : pairs_of("rounded-vertex-on-face", 100)) REQUIRE(is_within(1e-14, pair));
}

/// How far the first edge of A is from that of B: convex along A's, so that its least value is found by thirds.
double edge_distance(const Points& a, const Points& b) {
  const Vec edge = b[1] - b[0];
  const auto distance_at = [&](double t) {
    const Vec from_b = a[0] + t * (a[1] - a[0]) - b[0];
    return (from_b - std::clamp(from_b.dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge).norm();
  };
  double first = 0, last = 1;
  for (int i = 0; i < 80; ++i) {
    const double third = (last - first) / 3;
    if (distance_at(first + third) < distance_at(last - third))
      last -= third;
    else
      first += third;
  }
  return distance_at(first);
}

TEST_CASE("Families: near-parallel edges are at most 2e-3 apart or deep, at most 2e-2 radians askew", "[families]") {
  for (const Pair& pair : pairs_of("near-parallel-edges", 100)) {
    const Points &a = points(pair.a), &b = points(pair.b);
    REQUIRE((a[1] - a[0]).normalized().cross((b[1] - b[0]).normalized()).norm() < 2e-2);
    if (truth(pair) == Truth::separated)
      REQUIRE(edge_distance(a, b) < 2e-3);
    else
      REQUIRE(is_within(4e-3, pair));
  }
}

// -- Flat, thin, small, far -------------------------------------------------------------------------------------------

Rational orientation(const Vec& p, const Vec& q, const Vec& r, const Vec& s) {
  const auto edge = [&](const Vec& to) {
    return RationalVec{Rational(to[0]) - Rational(p[0]), Rational(to[1]) - Rational(p[1]),
                       Rational(to[2]) - Rational(p[2])};
  };
  const RationalVec u = edge(q), v = edge(r), w = edge(s);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

TEST_CASE("Families: coplanar triangles are in one plane exactly, square to an axis or askew", "[families]") {
  for (const std::string name : {"coplanar-axis", "coplanar-tilted"})
    for (const Pair& pair : pairs_of(name, 100)) {
      INFO(name);
      const Points &a = points(pair.a), &b = points(pair.b);
      bool square = false;
      for (const Eigen::Index k : {0, 1, 2})
        square = square || std::ranges::all_of(a, [&](const Vec& p) { return p[k] == a[0][k]; });
      REQUIRE(square == (name == "coplanar-axis"));
      for (const Vec& p : b) REQUIRE(orientation(a[0], a[1], a[2], p) == 0);
    }
}

TEST_CASE("Families: what is flattened to z·1e-6 is so flat, and flattening changed no answer", "[families]") {
  for (const auto& [name, thickness] :
       std::map<std::string, double>{{"flat-1e-3", 1e-3}, {"flat-1e-6", 1e-6}, {"flat-1e-9", 1e-9}}) {
    INFO(name);
    double thickest = 0;
    for (const Pair& pair : pairs_of(name, 100))
      for (const Body* body : {&pair.a, &pair.b})
        for (const Vec& p : points(*body)) thickest = std::max(thickest, p[2]);
    REQUIRE(thickest <= thickness);
    REQUIRE(thickest > 0.9 * thickness);
  }
}

TEST_CASE("Families: turned flat ones lie along no axis", "[families]") {
  for (const Pair& pair : pairs_of("flat-1e-9-turned", 100))
    for (const Eigen::Index k : {0, 1, 2}) REQUIRE(std::abs(points(pair.a)[0][k] - points(pair.a)[1][k]) > 1e-7);
}

TEST_CASE("Families: needles are about a million times as long as thick", "[families]") {
  for (const Pair& pair : pairs_of("needles-1e6", 100)) {
    const Points& a = points(pair.a);
    const double length = diameter(a);
    REQUIRE(length > 0.01);
    REQUIRE((a[1] - a[0]).cross(a[2] - a[0]).norm() < 4e-6 * 2);
  }
}

TEST_CASE("Families: sizes differ as said, the small one now first, now second", "[families]") {
  for (const auto& [name, ratio] : std::map<std::string, double>{{"sizes-1e3", 1e3}, {"sizes-1e6", 1e6}}) {
    int first_is_small = 0;
    for (const Pair& pair : pairs_of(name, 100)) {
      const double a = diameter(points(pair.a)), b = diameter(points(pair.b));
      REQUIRE((std::max(a, b) / std::min(a, b) > ratio / 10 && std::max(a, b) / std::min(a, b) < ratio * 10));
      first_is_small += a < b ? 1 : 0;
    }
    REQUIRE((first_is_small > 25 && first_is_small < 75));
  }
}

TEST_CASE("Families: far from the origin as said", "[families]") {
  for (const auto& [name, far] :
       std::map<std::string, double>{{"offset-1e4", 1e4}, {"offset-1e8", 1e8}, {"offset-1e12", 1e12}})
    for (const Pair& pair : pairs_of(name, 50)) {
      INFO(name);
      REQUIRE(std::abs(points(pair.a)[0].norm() / far - 1) < 1e-3);
      REQUIRE(diameter(points(pair.a)) < 2);
    }
}

TEST_CASE("Families: scales are as said, and by a power of two, so that nothing but the range changes", "[families]") {
  for (const auto& [name, unit] : std::map<std::string, double>{
           {"scale-1e-100", 1e-100}, {"scale-1e-10", 1e-10}, {"scale-1e50", 1e50}, {"scale-1e100", 1e100}}) {
    double largest = 0;
    for (const Pair& pair : pairs_of(name, 100))
      for (const double x : numbers(pair)) {
        const double step = std::exp2(std::round(std::log2(unit)) - 53);  // the dice's steps, in this unit
        REQUIRE(std::remainder(x, step) == 0);
        largest = std::max(largest, x);
      }
    INFO(name << " " << largest);
    REQUIRE((largest > unit / 2 && largest < unit * 2));
  }
}

// -- Lists ------------------------------------------------------------------------------------------------------------

TEST_CASE("Families: where all pairs are listed, none is listed twice", "[families]") {
  for (const Family& family : families()) {
    if (!family.size || *family.size > 50000) continue;
    INFO(family.name);
    std::set<std::vector<double>> seen;
    for (const Pair& pair : pairs_of(family, *family.size)) seen.insert(numbers(pair));
    REQUIRE(seen.size() == *family.size);
  }
}

TEST_CASE("Families: the grids have as many pairs as their names say", "[families]") {
  REQUIRE(family_named("grid-segments").size == 27u * 27 * 27 * 27);
  REQUIRE(family_named("grid-triangles").size == 8u * 8 * 8 * 8 * 8 * 8);
  REQUIRE(family_named("grid-triangles-flat").size == 9u * 9 * 9 * 9 * 9 * 9);
  REQUIRE(family_named("grid-tetrahedra").size == 70u * 548);
}

TEST_CASE("Families: the first two cycles are the known ones, one apart, one meeting", "[families]") {
  const auto pairs = pairs_of("cycles", 2);
  REQUIRE(points(pairs[0].a) == Points{{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}});
  REQUIRE(points(pairs[1].b) == Points{{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}});
  REQUIRE(truth(pairs[0]) == Truth::separated);
  REQUIRE(truth(pairs[1]) == Truth::intersecting);
}

TEST_CASE("Families: on every one of the cycles GJK goes round", "[families]") {
  gjk::Options<double> options;
  options.iteration_limit = 200;
  for (const Pair& pair : pairs_of("cycles", 48)) {
    const auto result =
        gjk::collision(gjk::PointSet<double>(points(pair.a)), gjk::PointSet<double>(points(pair.b)), options);
    REQUIRE(result.reason == gjk::Reason::cycle);
  }
}

/// The points of A - B in the order in which GJK can meet them.
std::vector<double> difference_of(const Pair& pair) {
  std::vector<double> numbers;
  for (const Vec& a : points(pair.a))
    for (const Vec& b : points(pair.b))
      for (const double x : Vec(a - b)) numbers.push_back(x);
  return numbers;
}

TEST_CASE("Families: of the pairs that cycle no two have the same difference in the same order", "[families]") {
  for (const char* const name : {"cycles", "cycles-turned"}) {
    INFO(name);
    const Family& family = family_named(name);
    std::set<std::vector<double>> different;
    for (const Pair& pair : pairs_of(family, *family.size)) different.insert(difference_of(pair));
    REQUIRE(different.size() == *family.size);
  }
}

TEST_CASE("Families: the turned cycles are different sets and their reflections are among them", "[families]") {
  const auto set_of = [](const Pair& pair, double sign) {
    std::multiset<std::array<double, 3>> points_of_it;
    for (const Vec& a : points(pair.a))
      for (const Vec& b : points(pair.b)) {
        const Vec w = sign * (a - b);
        points_of_it.insert({w.x(), w.y(), w.z()});
      }
    return points_of_it;
  };
  const auto pairs = pairs_of("cycles-turned", 96);
  std::set<std::multiset<std::array<double, 3>>> different;
  for (const Pair& pair : pairs) different.insert(set_of(pair, 1));
  REQUIRE(different.size() == 96);
  for (const Pair& pair : pairs) REQUIRE(different.contains(set_of(pair, -1)));
}

TEST_CASE("Families: duplicates repeat a point in nearly every list, and some lists are one point only", "[families]") {
  int repeating = 0, single = 0;
  for (const Pair& pair : pairs_of("duplicates", 200)) {
    const Points& a = points(pair.a);
    std::set<double> different;
    for (const Vec& p : a) different.insert(p[0]);
    repeating += different.size() < a.size() ? 1 : 0;
    single += different.size() == 1 && a.size() > 1 ? 1 : 0;
  }
  REQUIRE(repeating > 150);
  REQUIRE(single > 10);
}

}  // namespace families_test
}  // namespace study
