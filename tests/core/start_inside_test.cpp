/// Searches that start inside: from a point of each set, for which no support function is asked.
#include <algorithm>
#include <map>

#include "core/complete.hpp"
#include "tests/core/certified_support.hpp"
#include "tests/core/evidence.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace start_inside_test {

/// Returns: the mean, exactly.
ExactVec mean(const Points& points) {
  ExactVec sum(0, 0, 0);
  for (const Point& p : points) sum += vec<Rational>(p);
  return sum / Rational(points.size());
}

template <class S>
Options<S> inside(const Vec3<S>& a, const Vec3<S>& b) {
  Options<S> options;
  options.inside = PointOfEach<S>{a, b};
  return options;
}
template <class S>
Options<S> inside_means(const Pair<S>& pair) {
  return inside<S>(pair.a.mean(), pair.b.mean());
}

TEST_CASE(
    "Inside: the first vertex is the difference of the two points, has no indices, and is told before any support",
    "[inside]") {
  using V = Vec3<double>;
  const auto a = point_set<double>(corner), b = point_set<double>(moved(corner, {1, 2, 3}));
  const auto run = observed<double>(a, b, inside<double>({1, 1, 1}, {2, 3, 4}));
  REQUIRE(std::get<SearchStarted<double>>(run.events[0]).direction == V(1, 2, 3));
  REQUIRE(std::get<SearchStarted<double>>(run.events[0]).why == FirstDirection::from_inside);
  const auto& added = std::get<VertexAdded<double>>(run.events[1]);
  REQUIRE(added.iteration == 0);
  REQUIRE(added.simplex.size() == 1);
  REQUIRE(added.simplex[0] == Vertex<double>{V(1, 1, 1), V(2, 3, 4), V(-1, -2, -3)});
  REQUIRE_FALSE(added.simplex[0].a.index);
  REQUIRE(to_string(std::get<RegionTested<double>>(run.events[2]).feature) == "A");
  REQUIRE(std::get<DirectionChosen<double>>(run.events[3]).direction == V(1, 2, 3));
  const auto& found = std::get<SupportFound<double>>(run.events[4]);
  REQUIRE((found.iteration == 1 && found.direction == V(1, 2, 3)));
  // Eq. 9 is applied: that vertex was found by a move.
  REQUIRE(std::get<CrossingTested<double>>(run.events[5]).value.has_value());
  REQUIRE((run.result == asked<double>(a, b, inside<double>({1, 1, 1}, {2, 3, 4}))));
}

TEST_CASE("Inside: where the two points coincide the sets meet there, and no support function is asked", "[inside]") {
  const auto a = point_set<double>(corner), b = point_set<double>(moved(corner, {1, 1, 1}));
  for (const int limit : {0, 20}) {
    Options<double> options = inside<double>({2, 2, 2}, {2, 2, 2});
    options.iteration_limit = limit;
    const AnyShape<double> watched_a(a), watched_b(b);
    const auto result = asked<double>(watched_a, watched_b, options);
    REQUIRE(result.status == Status::intersecting);
    REQUIRE(result.iterations == 0);
    REQUIRE(result.simplex.size() == 1);
    REQUIRE(watched_a.times_asked() + watched_b.times_asked() == 0);
  }
}

TEST_CASE("Inside: points that are not finite lead nowhere, and the search ends undecided", "[inside]") {
  const auto a = point_set<double>(corner);
  for (const double wrong : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const auto result = asked<double>(a, a, inside<double>({wrong, 1, 1}, {1, 2, 1}));
    REQUIRE(result.status == Status::undecided);
    REQUIRE(result.reason == Reason::unusable_direction);
    REQUIRE(result.iterations == 0);
  }
}

TEST_CASE("Inside: in exact numbers the answer is that of a search along +x, with and without the crossing test",
          "[inside]") {
  Dice dice(91);
  std::map<Status, int> seen;
  int spared = 0;
  for (int i = 0; i < 300; ++i) {
    const PairOfHulls pair = random_pair(dice);
    const auto a = point_set<Rational>(pair.a), b = point_set<Rational>(pair.b);
    const auto expected = asked<Rational, Complete<>>(a, b, {.iteration_limit = 100});
    REQUIRE(expected.status != Status::undecided);
    ++seen[expected.status];
    for (const CrossingTest crossing_test : {CrossingTest::on, CrossingTest::off}) {
      Options<Rational> options = inside<Rational>(mean(pair.a), mean(pair.b));
      options.iteration_limit = 100;
      options.crossing_test = crossing_test;
      const auto complete = asked<Rational, Complete<>>(a, b, options), intended = asked<Rational>(a, b, options);
      for (const auto& result : {complete, intended}) {
        INFO("pair " << i << (crossing_test == CrossingTest::on ? "" : ", no crossing test"));
        REQUIRE(result.status == expected.status);
        require_evidence(result, pair.a, pair.b);
      }
      if (crossing_test == CrossingTest::on) spared += expected.iterations - complete.iterations;
    }
  }
  REQUIRE(seen[Status::intersecting] > 50);
  REQUIRE(seen[Status::separated] > 50);
  REQUIRE(spared > 150);
}

// -- Certified --------------------------------------------------------------------------------------------------------

TEMPLATE_TEST_CASE(
    "Inside, C5: the certified answer is proven from the means, one of whose differences may be a corner, and from "
    "points "
    "that lie nowhere in the sets",
    "[inside][certified]", float, double) {
  using S = TestType;
  Dice dice(92);
  int by_mean = 0;
  std::map<Proof, int> proofs;
  for (int i = 0; i < 600; ++i) {
    const PairOfHulls hulls = random_pair(dice);
    const Frame<S> frame = i % 2 ? axis_aligned<S>("1", 1) : skew<S>("1/7", S(1) / S(7));
    const Pair<S> pair = pair_of<S>(seen(hulls.a, frame), seen(hulls.b, frame));
    const auto means_in = [](const CertifiedResult& result) {
      const auto* simplex = std::get_if<CommonSimplex>(&result.certificate);
      return simplex ? std::ranges::count(simplex->of, IndexPair{IndexPair::mean, IndexPair::mean}) : 0;
    };
    INFO("pair " << i);
    const CertifiedResult result = proven(pair, inside_means(pair));
    by_mean += means_in(result) > 0;
    ++proofs[result.proof];
    const Vec3<S> a = vec<S>(dice.point(20)), b = vec<S>(dice.point(20));
    REQUIRE(means_in(proven(pair, inside<S>(a, b))) == 0);
    proven(pair, inside<S>(pair.a.mean(), b));
    proven(pair, inside<S>(a, pair.b.mean()));
  }
  REQUIRE(by_mean > 50);
  REQUIRE(proofs[Proof::direction] > 50);
  REQUIRE(proofs[Proof::exact_fallback] > 20);
}

TEST_CASE("Inside: where means are known no better than the sets are deep in each other, the second search decides",
          "[inside][certified]") {
  // The mean of four points is off by up to 4u·2^48 = 2^-3.
  const Vec3<double> far(0x1p48, 0x1p48, 0x1p48);
  std::vector<Vec3<double>> a, b;
  for (const Point& p : corner) {
    a.push_back(vec<double>(p) + far);
    b.push_back(vec<double>(p) + far + Vec3<double>(0.5, 1.25, 0.75));
  }
  const Pair<double> pair = pair_of<double>(a, b);
  const CertifiedResult result = proven(pair, inside_means(pair));
  REQUIRE(result.status == Status::intersecting);
  REQUIRE(result.proof == Proof::exact_fallback);
  REQUIRE(proven(pair).proof == Proof::tetrahedron);
}

}  // namespace start_inside_test
}  // namespace gjk::test
