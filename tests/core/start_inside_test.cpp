/// Searches that start inside: from a point of each set, for which no support function is asked.
#include <map>

#include "core/rule_sets.hpp"
#include "tests/core/certified_support.hpp"
#include "tests/core/evidence.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

const Points tetrahedron{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};

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
  const auto a = point_set<double>(tetrahedron), b = point_set<double>(moved(tetrahedron, {1, 2, 3}));
  const auto run = observed<double>(a, b, inside<double>({1, 1, 1}, {2, 3, 4}));
  REQUIRE(std::get<SearchStarted<double>>(run.events[0]).direction == V(1, 2, 3));
  REQUIRE(std::get<SearchStarted<double>>(run.events[0]).why ==
          "from a point inside A to one inside B; their difference is the first vertex");
  const auto& added = std::get<VertexAdded<double>>(run.events[1]);
  REQUIRE(added.iteration == 0);
  REQUIRE(added.simplex.size() == 1);
  REQUIRE(added.simplex[0] == Vertex<double>{V(1, 1, 1), V(2, 3, 4), V(-1, -2, -3)});
  REQUIRE_FALSE(added.simplex[0].a.index);
  REQUIRE(std::get<RegionTested<double>>(run.events[2]).feature == "A");
  REQUIRE(std::get<DirectionChosen<double>>(run.events[3]).direction == V(1, 2, 3));
  const auto& found = std::get<SupportFound<double>>(run.events[4]);
  REQUIRE((found.iteration == 1 && found.direction == V(1, 2, 3)));
  // Eq. 9 is applied: that vertex was found by a move.
  REQUIRE(std::get<CrossingTested<double>>(run.events[5]).value.has_value());
  REQUIRE(same_result(run.result, asked<double>(a, b, inside<double>({1, 1, 1}, {2, 3, 4}))));
}

TEST_CASE("Inside: where the two points coincide the sets meet there, and no support function is asked", "[inside]") {
  const auto a = point_set<double>(tetrahedron), b = point_set<double>(moved(tetrahedron, {1, 1, 1}));
  for (const int limit : {0, 20}) {
    Options<double> options = inside<double>({2, 2, 2}, {2, 2, 2});
    options.iteration_limit = limit;
    const Watched<double, PointSet<double>> watched_a(a), watched_b(b);
    const auto result = collision<double>(watched_a, watched_b, options);
    REQUIRE(result.status == Status::intersecting);
    REQUIRE(result.iterations == 0);
    REQUIRE(result.simplex.size() == 1);
    REQUIRE(watched_a.times_asked() + watched_b.times_asked() == 0);
  }
}

TEST_CASE("Inside: points that are not finite lead nowhere, and the search ends undecided", "[inside]") {
  const auto a = point_set<double>(tetrahedron);
  for (const double wrong : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const auto result = asked<double>(a, a, inside<double>({wrong, 1, 1}, {1, 2, 1}));
    REQUIRE(result.status == Status::undecided);
    REQUIRE(result.reason == Reason::unusable_direction);
    REQUIRE(result.iterations == 0);
  }
}

TEST_CASE(
    "Inside: in exact numbers the answer is that of a search along +x, by all rules, with and without the crossing "
    "test",
    "[inside]") {
  const std::uint64_t seed = 91;
  INFO("seed " << seed);
  Dice dice(seed);
  std::map<Status, int> seen;
  int spared = 0;
  for (int i = 0; i < 300; ++i) {
    const PairOfHulls pair = random_pair(dice);
    const auto a = point_set<Rational>(pair.a), b = point_set<Rational>(pair.b);
    const auto expected = collision<Rational, Complete<>>(a, b, {.iteration_limit = 100});
    REQUIRE(expected.status != Status::undecided);
    ++seen[expected.status];
    for (const auto& rules : rule_sets)
      for (const CrossingTest crossing_test : {CrossingTest::on, CrossingTest::off}) {
        if (rules.value == RuleSet::as_printed) continue;  // which is wrong on some
        INFO("pair " << i << ", rules " << rules.name
                     << (crossing_test == CrossingTest::on ? "" : ", no crossing test"));
        Options<Rational> options = inside<Rational>(mean(pair.a), mean(pair.b));
        options.iteration_limit = 100;
        options.crossing_test = crossing_test;
        const auto result = with_rules<ExactZeroTest>(
            rules.value, [&]<class Rules>() { return collision<Rational, Rules>(a, b, options); });
        REQUIRE(result.status == expected.status);
        REQUIRE(result.separation.has_value() == (result.status == Status::separated));
        if (result.separation)
          REQUIRE(difference_stays_below<Rational>(pair.a, pair.b, result.separation->direction,
                                                   result.separation->support_value));
        else
          REQUIRE(contain_origin(places(result.simplex)));
        if (rules.value == RuleSet::complete && crossing_test == CrossingTest::on)
          spared += expected.iterations - result.iterations;
      }
  }
  REQUIRE(seen[Status::intersecting] > 50);
  REQUIRE(seen[Status::separated] > 50);
  REQUIRE(spared > 150);
}

TEST_CASE("Inside: balls and cylinders are found as between their centers", "[inside]") {
  using V = Vec3<double>;
  const Sphere<double> ball(V(1, 2, 3), 2);
  for (const double gap : {-0.5, 0.5}) {
    const Cylinder<double> can(V(1, 2, 6 + gap), V(0, 0, 1), 1, 2);
    const auto result = asked<double>(ball, can, inside<double>(ball.center(), can.center()));
    REQUIRE(result.status == (gap < 0 ? Status::intersecting : Status::separated));
    REQUIRE(result.iterations <= 2);
  }
}

// -- Certified --------------------------------------------------------------------------------------------------------

TEMPLATE_TEST_CASE(
    "Inside: from the means the certified answer is the same, and the first vertex may be one of its points",
    "[inside][certified]", float, double) {
  using S = TestType;
  const std::uint64_t seed = 92;
  INFO("seed " << seed);
  Dice dice(seed);
  int by_mean = 0, by_direction = 0, second = 0;
  for (int i = 0; i < 600; ++i) {
    const PairOfHulls hulls = random_pair(dice);
    const Frame<S> frame = i % 2 ? axis_aligned<S>("1", 1) : skew<S>("1/7", S(1) / S(7));
    const Pair<S> pair{PointSet<S>(seen(hulls.a, frame)), PointSet<S>(seen(hulls.b, frame))};
    INFO("pair " << i);
    const CertifiedResult result = proven(pair, inside_means(pair));
    REQUIRE(result.status == proven(pair).status);
    by_direction += result.proof == Proof::direction;
    second += result.proof == Proof::second_search;
    if (const auto* simplex = std::get_if<CommonSimplex>(&result.certificate))
      for (const IndexPair& each : simplex->of) by_mean += each == IndexPair{IndexPair::mean, IndexPair::mean};
  }
  REQUIRE(by_mean > 50);
  REQUIRE(by_direction > 50);
  REQUIRE(second > 20);
}

TEMPLATE_TEST_CASE("Inside, C5: points that lie nowhere in the sets change no certified answer", "[inside][certified]",
                   float, double) {
  using S = TestType;
  const std::uint64_t seed = 93;
  INFO("seed " << seed);
  Dice dice(seed);
  for (int i = 0; i < 300; ++i) {
    const PairOfHulls hulls = random_pair(dice);
    const Pair<S> pair{point_set<S>(hulls.a), point_set<S>(hulls.b)};
    const Status expected = proven(pair).status;
    const auto anywhere = [&] { return vec<S>(dice.point(20)); };
    INFO("pair " << i);
    const CertifiedResult result = proven(pair, inside<S>(anywhere(), anywhere()));
    REQUIRE(result.status == expected);
    if (const auto* simplex = std::get_if<CommonSimplex>(&result.certificate))
      for (const IndexPair& pair_of_indices : simplex->of) REQUIRE(pair_of_indices.a >= 0);
    REQUIRE(proven(pair, inside<S>(pair.a.mean(), anywhere())).status == expected);
    REQUIRE(proven(pair, inside<S>(anywhere(), pair.b.mean())).status == expected);
  }
}

TEST_CASE("Inside: where means are known no better than the sets are deep in each other, the second search decides",
          "[inside][certified]") {
  // The mean of four points is off by up to 4u·2^48 = 2^-3.
  const Vec3<double> far(0x1p48, 0x1p48, 0x1p48);
  std::vector<Vec3<double>> a, b;
  for (const Point& p : tetrahedron) {
    a.push_back(vec<double>(p) + far);
    b.push_back(vec<double>(p) + far + Vec3<double>(0.5, 1.25, 0.75));
  }
  const Pair<double> pair = pair_of<double>(a, b);
  const CertifiedResult result = proven(pair, inside_means(pair));
  REQUIRE(result.status == Status::intersecting);
  REQUIRE(result.proof == Proof::second_search);
  REQUIRE(proven(pair).proof == Proof::tetrahedron);
}

}  // namespace
}  // namespace gjk::test
