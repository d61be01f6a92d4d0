/// What counts as zero, and what that changes: sets that touch askew, whose products
/// are rounded away from zero, are found touching.
#include "core/zero_test.hpp"

#include <map>
#include <set>
#include <sstream>

#include "tests/core/rules_support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace zero_test_test {

using Relative = Intended<RelativeZeroTest>;
using V3 = Vec3<double>;

/// Two cubes of edge 2, their centers `apart`, turned askew and moved far from where the origin of coordinates is, with
/// everything rounded on the way: number `i` of many.
template <class S>
std::pair<PointSet<S>, PointSet<S>> cubes_askew(int i, const Vec3<S>& apart) {
  const Eigen::Matrix<S, 3, 3> turn =
      Eigen::AngleAxis<S>(S(0.1) + S(i), Vec3<S>(1, -2, 3).normalized()).toRotationMatrix();
  const Vec3<S> center(30, -50, 70), other_center = turn * apart + center;
  std::vector<Vec3<S>> a, b;
  for (const Point& p : cube) {
    a.push_back(turn * vec<S>(p) + center);
    b.push_back(turn * vec<S>(p) + other_center);
  }
  return {PointSet<S>(a), PointSet<S>(b)};
}

/// Returns: what a product of these factors counts as.
template <class Test, class Product, class First, class... Factors>
Product snapped(const Product& product, const First& first, const Factors&... factors) {
  return (Test::size(first) * ... * Test::size(factors)).snap(product);
}

template <class S, class Rules>
int found_together(const Vec3<S>& apart, const Options<S>& options = {}) {
  int together = 0;
  for (int i = 0; i < 200; ++i) {
    const auto [a, b] = cubes_askew<S>(i, apart);
    together += asked<S, Rules>(a, b, options).status == Status::intersecting;
  }
  return together;
}

TEMPLATE_TEST_CASE(
    "Cubes that share a face, an edge or a corner askew: the relative zero test finds them touching, and apart "
    "where they clearly are",
    "[zero]", float, double) {
  using V = Vec3<TestType>;
  // Twenty times 16ε (|a| + |b|), the cubes being 2 wide.
  const TestType gap = 50000 * std::numeric_limits<TestType>::epsilon();
  for (const auto& apart : {V(2, 0, 0), V(2, 2, 0), V(2, 2, 2)}) {
    INFO("centers " << apart.transpose() << " apart");
    REQUIRE(found_together<TestType, AsIntended>(apart) < 200);
    REQUIRE(found_together<TestType, Relative>(apart) == 200);
    REQUIRE(found_together<TestType, Relative>(apart, without_crossing_test<TestType>()) == 200);
    REQUIRE(found_together<TestType, Relative>(apart * (1 + gap)) == 0);
  }
}

TEST_CASE(
    "Exact numbers have no rounding to forgive, and small integers are never within rounding of zero unless they are "
    "zero",
    "[zero]") {
  Dice dice(42);
  for (int i = 0; i < 1000; ++i) {
    const PairOfHulls t = random_pair(dice);
    INFO("pair " << i);
    const auto a = point_set<double>(t.a), b = point_set<double>(t.b);
    REQUIRE((asked<double, Relative>(a, b) == asked<double>(a, b)));
    if (i % 4 > 0) continue;
    const auto exact_a = point_set<Rational>(t.a), exact_b = point_set<Rational>(t.b);
    REQUIRE((asked<Rational, Relative>(exact_a, exact_b) == asked<Rational>(exact_a, exact_b)));
  }
}

TEMPLATE_TEST_CASE("A product counts as zero below 16ε times the lengths of its factors, and not from there on",
                   "[zero]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  const S tolerance = 16 * std::numeric_limits<S>::epsilon() * 3 * 5;
  const V three(1, -1, 1), five(0, 0, -5);
  const S below = std::nextafter(tolerance, S(0));
  REQUIRE(snapped<RelativeZeroTest>(below, three, five) == 0);
  REQUIRE(snapped<RelativeZeroTest>(-below, three, five) == 0);
  REQUIRE(snapped<RelativeZeroTest>(tolerance, three, five) == tolerance);
  REQUIRE(snapped<RelativeZeroTest>(-tolerance, three, five) == -tolerance);
  REQUIRE(snapped<RelativeZeroTest>(V(0, -below, 0), three, five) == V(0, 0, 0));
  REQUIRE(snapped<RelativeZeroTest>(V(0, -tolerance, 0), three, five) == V(0, -tolerance, 0));
  REQUIRE(snapped<ExactZeroTest>(below, three, five) == below);
}

TEST_CASE("The length of a vertex is that of the points it was subtracted from", "[zero]") {
  using V = Vec3<double>;
  const Vertex<double> far_out{{V(0, 3e6, 0)}, {V(0, 3e6, 1e-10)}, V(0, 0, -1e-10)};
  const Vertex<double> near_by{{V(0, 0, 0)}, {V(0, 0, 1e-10)}, V(0, 0, -1e-10)};
  REQUIRE(snapped<RelativeZeroTest>(far_out.w, far_out) == V(0, 0, 0));
  REQUIRE(snapped<RelativeZeroTest>(near_by.w, near_by) == near_by.w);
}

TEST_CASE("What overflowed or is not a number does not count as zero", "[zero]") {
  using V = Vec3<double>;
  const V huge(1e300, 0, 0);
  const double infinite = std::numeric_limits<double>::infinity();
  REQUIRE(snapped<RelativeZeroTest>(infinite, huge, huge) == infinite);
  REQUIRE(snapped<RelativeZeroTest>(-infinite, huge, huge) == -infinite);
  REQUIRE(snapped<RelativeZeroTest>(V(infinite, 0, 0), huge, huge) == V(infinite, 0, 0));
  REQUIRE(std::isnan(snapped<RelativeZeroTest>(std::nan(""), huge, huge)));
  REQUIRE(snapped<RelativeZeroTest>(1e305, V(1e160, 0, 0), V(1e160, 0, 0)) == 0);  // though 1e160² overflows
  REQUIRE(snapped<RelativeZeroTest>(1e306, V(1e160, 0, 0), V(1e160, 0, 0)) == 1e306);
}

/// Runs the rules for one simplex, the last point being A.
template <class Rules>
std::vector<RegionTested<double>> regions_told(const std::vector<Vec3<double>>& oldest_first) {
  auto simplex = simplex_of(oldest_first);
  return events_of_kind<RegionTested<double>>(step<Rules>(simplex).events);
}

TEST_CASE("A product that counts as zero is told as it was computed, with the verdict and relation of a zero",
          "[zero]") {
  using V = Vec3<double>;
  const double speck = 0x1p-52;
  const auto in_the_plane = regions_told<Relative>({V(-1, -1, speck), V(1, -1, speck), V(0, 1, speck)}).back();
  REQUIRE(to_string(in_the_plane.feature) == "ABC");
  REQUIRE(in_the_plane.relation == Relation::zero);
  REQUIRE(std::abs(std::get<double>(in_the_plane.value)) == 4 * speck);
  const auto on_the_segment = regions_told<Relative>({V(-1, 0, speck), V(1, 0, speck)}).back();
  REQUIRE(on_the_segment.relation == Relation::zero);
  REQUIRE(std::get<V>(on_the_segment.value) == V(0, 0, -4 * speck));
  const auto at_the_point = regions_told<Relative>({V(speck, 0, 0)}).back();  // whose length is its own: 1, not 1/ε
  REQUIRE(at_the_point.relation == Relation::not_zero);
  REQUIRE(regions_told<AsIntended>({V(-1, -1, speck), V(1, -1, speck), V(0, 1, speck)}).back().relation !=
          Relation::zero);
}

/// Keeps the lengths of the factors of every product that is compared with zero, which counts as it is.
struct LoggingZeroTest {
  struct Size {
    std::multiset<double> lengths;

    friend Size operator*(Size u, const Size& v) {
      u.lengths.insert(v.lengths.begin(), v.lengths.end());
      return u;
    }
    template <class Product>
    const Product& snap(const Product& product) const {
      if (log.empty() || log.back() != lengths) log.push_back(lengths);
      return product;
    }
  };
  static Size size(const Vec3<double>& v) { return {{v.lpNorm<1>()}}; }
  static Size size(const Vertex<double>& v) { return {{v.a.point.lpNorm<1>() + v.b.point.lpNorm<1>()}}; }

  static inline std::vector<std::multiset<double>> log;
};

/// Returns: "AB AB AC AO" for "ABn·AO" made as "AB×ABCn": the letters of all that was multiplied.
std::vector<std::string> factors_of(const std::string& expression, const std::string& formula) {
  static const std::map<std::string, std::string> eq_14{{"ABCn", "AB×AC"}, {"ACDn", "AC×AD"}, {"ADBn", "AD×AB"}};
  std::vector<std::string> factors;
  std::string all = formula.empty() ? expression : formula + "·AO";
  for (const std::string sign : {"×", "·"})
    for (auto at = all.find(sign); at != std::string::npos; at = all.find(sign)) all.replace(at, sign.size(), " ");
  std::istringstream words(all);
  for (std::string word; words >> word;) {
    if (!eq_14.contains(word)) {
      factors.push_back(word);
      continue;
    }
    for (const std::string& each : factors_of(eq_14.at(word), "")) factors.push_back(each);
  }
  return factors;
}

TEST_CASE("Every product is compared with the lengths of the factors that its formula names, and of no others",
          "[zero]") {
  Dice dice(43);
  std::set<std::string> seen;
  for (int i = 0; i < 3000; ++i) {
    Simplex<double> simplex;
    for (int n = 0; n <= i % 4; ++n) {
      const V3 a = vec<double>(dice.point(999)), b = vec<double>(dice.point(999));
      simplex.add({{a}, {b}, a - b});
    }
    const auto length = [&](const std::string& word) {
      const Vertex<double>& A = simplex[simplex.size() - 1];
      if (word == "AO") return LoggingZeroTest::size(A);
      return LoggingZeroTest::size(V3(simplex[simplex.size() - 1 - (word[1] - 'A')].w - A.w));
    };
    Simplex<double> kept = simplex;
    Trace<double> trace;
    LoggingZeroTest::log.clear();
    process<Intended<LoggingZeroTest>>(kept, CrossingTest::on, trace);
    std::vector<std::multiset<double>> expected;
    for (const auto& region : events_of_kind<RegionTested<double>>(trace.events)) {
      if (region.expression.empty()) continue;
      LoggingZeroTest::Size size;
      for (const std::string& word : factors_of(to_string(region.expression), to_string(region.formula))) size = size * length(word);
      expected.push_back(size.lengths);
      seen.insert(std::to_string(region.simplex_size) + to_string(region.face) + to_string(region.expression));
    }
    INFO("simplex " << i << " of " << simplex.size());
    REQUIRE(LoggingZeroTest::log == expected);
  }
  REQUIRE(seen.size() == 1 + 1 + 3 + 3 + 6);  // Algorithms 2, 3 and 4, the faces and their edges
}

TEST_CASE("w·d is compared with the lengths of both points of the vertex and of the direction", "[zero]") {
  LoggingZeroTest::log.clear();
  const Vertex<double> vertex{{V3(1, -2, 4)}, {V3(8, 16, -32)}, V3(-7, -18, 36)};
  REQUIRE_FALSE(detail::reach<LoggingZeroTest>(vertex, V3(64, -128, 256)).is_zero());
  REQUIRE(LoggingZeroTest::log == std::vector{std::multiset<double>{7 + 56, 448}});
}

}  // namespace zero_test_test
}  // namespace gjk::test
