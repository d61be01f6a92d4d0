/// Random convex pairs against answers found in another way.
#include <random>

#include "tests/core/evidence.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

struct Tally {
  int hits = 0, misses = 0, undecided = 0;
  int pairs() const { return hits + misses + undecided; }
};

/// Between 30 and 70 of 100 pairs meet: otherwise one of the two answers would hardly be tested.
void require_balanced(const Tally& tally) {
  INFO(tally.hits << " hits, " << tally.misses << " misses, " << tally.undecided << " undecided");
  REQUIRE(10 * tally.hits > 3 * tally.pairs());
  REQUIRE(10 * tally.hits < 7 * tally.pairs());
}

void count(Tally& tally, Status status, bool they_meet) {
  if (status == Status::undecided) {
    ++tally.undecided;
    return;
  }
  REQUIRE((status == Status::intersecting) == they_meet);
  ++(they_meet ? tally.hits : tally.misses);
}

/// Two tetrahedra that are not flat, the second moved by up to `apart`.
PairOfHulls tetrahedra(Dice& dice, int reach, int apart) {
  for (;;) {
    PairOfHulls pair{dice.points(4, reach), moved(dice.points(4, reach), dice.point(apart))};
    if (!is_flat(pair.a) && !is_flat(pair.b)) return pair;
  }
}

template <class S>
Tally compare_with_separating_axes(std::uint64_t seed, int pairs, int reach, int apart, bool examine_evidence) {
  Dice dice(seed);
  Tally tally;
  for (int i = 0; i < pairs; ++i) {
    const PairOfHulls t = tetrahedra(dice, reach, apart);
    INFO("pair " << i);
    const Result<S> result = asked<S>(point_set<S>(t.a), point_set<S>(t.b));
    count(tally, result.status, tetrahedra_meet(t.a, t.b));
    if (examine_evidence) require_evidence(result, t.a, t.b);
  }
  return tally;
}

TEST_CASE("Tetrahedra in general position: GJK in double agrees with the separating axes on every pair it decides",
          "[random]") {
  const std::uint64_t seed = 1;
  INFO("seed " << seed);
  // Products of four differences of numbers below 1000 stay far below 2^53: double computes exactly.
  const Tally tally = compare_with_separating_axes<double>(seed, 30000, 500, 320, false);
  require_balanced(tally);
  REQUIRE(tally.undecided <= 5);
}

TEST_CASE("Tetrahedra with coordinates that are not whole: GJK in double agrees with exact arithmetic", "[random]") {
  const std::uint64_t seed = 5;
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; };
  const auto corners = [&](const Vec3<double>& offset) {
    std::vector<Vec3<double>> points;
    for (int i = 0; i < 4; ++i) {
      const double x = number(), y = number();
      points.push_back(Vec3<double>(x, y, number()) + offset);
    }
    return points;
  };
  const auto exactly = [](const std::vector<Vec3<double>>& points) {
    std::vector<Vec3<Rational>> exact;  // a double is a rational number
    for (const Vec3<double>& p : points) exact.push_back(p.cast<Rational>());
    return PointSet<Rational>(exact);
  };
  Tally tally;
  for (int i = 0; i < 1500; ++i) {
    INFO("pair " << i);
    const double dx = number(), dy = number();
    const auto a = corners(Vec3<double>::Zero()), b = corners(0.5 * Vec3<double>(dx, dy, number()));
    const Status exact = asked<Rational>(exactly(a), exactly(b)).status;
    REQUIRE(exact != Status::undecided);
    count(tally, asked<double>(PointSet<double>(a), PointSet<double>(b)).status, exact == Status::intersecting);
  }
  require_balanced(tally);
  REQUIRE(tally.undecided == 0);
}

TEST_CASE("Tetrahedra on a crowded lattice, where touching is common: GJK in double agrees with the separating axes",
          "[random]") {
  const std::uint64_t seed = 2;
  INFO("seed " << seed);
  const Tally tally = compare_with_separating_axes<double>(seed, 10000, 3, 1, false);
  require_balanced(tally);
  REQUIRE(tally.undecided == 0);
}

TEST_CASE("Tetrahedra in exact numbers: the answer agrees with the separating axes, and its evidence proves it",
          "[random][unsanitized]") {
  const std::uint64_t seed = 3;
  INFO("seed " << seed);
  const Tally roomy = compare_with_separating_axes<Rational>(seed, 2000, 100, 65, true);
  require_balanced(roomy);
  REQUIRE(roomy.undecided <= 1);
  const Tally crowded = compare_with_separating_axes<Rational>(seed, 2000, 3, 1, true);
  require_balanced(crowded);
  REQUIRE(crowded.undecided == 0);
}

TEST_CASE("Small integers are exact in double: the run is the exact one, event for event", "[random]") {
  const std::uint64_t seed = 4;
  INFO("seed " << seed);
  Dice dice(seed);
  for (int i = 0; i < 1000; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto exactly = observed<Rational>(point_set<Rational>(t.a), point_set<Rational>(t.b));
    const auto in_double = observed<double>(point_set<double>(t.a), point_set<double>(t.b));
    REQUIRE(in_double.events.size() == exactly.events.size());
    REQUIRE(in_double.result.status == exactly.result.status);
    REQUIRE(in_double.result.iterations == exactly.result.iterations);
    REQUIRE(exact(places(in_double.result.simplex)) == places(exactly.result.simplex));
  }
}

TEST_CASE("Spheres: GJK agrees with the distance of the centers", "[random]") {
  const std::uint64_t seed = 5;
  INFO("seed " << seed);
  Dice dice(seed);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    const auto center = [&] {
      return Vec3<double>(dice.between(-1., 1.), dice.between(-1., 1.), dice.between(-1., 1.));
    };
    const Vec3<double> c = center(), d = center();
    const double r = dice.between(0.1, 1.0), q = dice.between(0.1, 1.0);
    const double gap = (c - d).norm() - (r + q);
    if (std::abs(gap) < 1e-9) continue;  // too close for rounded support points to tell
    INFO("pair " << i << ", gap " << gap);
    const auto result = asked<double>(Sphere<double>(c, r), Sphere<double>(d, q));
    count(tally, result.status, gap < 0);
  }
  require_balanced(tally);
  REQUIRE(tally.undecided <= 5);
}

TEST_CASE("A sphere against a point: GJK agrees with the distance, at all scales", "[random]") {
  const std::uint64_t seed = 6;
  INFO("seed " << seed);
  for (const double scale : {1e-3, 1.0, 1e3}) {
    Dice dice(seed);
    Tally tally;
    for (int i = 0; i < 3000; ++i) {
      const Vec3<double> p(dice.between(-1., 1.), dice.between(-1., 1.), dice.between(-1., 1.));
      const double r = dice.between(0.5, 1.3);
      const auto result = asked<double>(PointSet<double>({p * scale}), Sphere<double>(Vec3<double>::Zero(), r * scale));
      count(tally, result.status, p.norm() < r);
    }
    require_balanced(tally);
    REQUIRE(tally.undecided <= 3);
  }
}

TEST_CASE("Changing places, or turning and scaling both sets, does not change the answer", "[random]") {
  const std::uint64_t seed = 8;
  INFO("seed " << seed);
  Dice dice(seed);
  for (int i = 0; i < 300; ++i) {
    const PairOfHulls t = tetrahedra(dice, 6, 5);
    const bool they_meet = tetrahedra_meet(t.a, t.b);
    const Status expected = they_meet ? Status::intersecting : Status::separated;
    for (const auto& frame : frames<Rational>()) {
      const auto placed = [&](const Points& points) { return PointSet<Rational>(seen(points, frame)); };
      INFO("pair " << i << ", " << frame.name);
      REQUIRE(asked<Rational>(placed(t.a), placed(t.b)).status == expected);
      REQUIRE(asked<Rational>(placed(t.b), placed(t.a)).status == expected);
    }
  }
}

/// What numbers of S are worth without rounding; Separation's bound is compared with nothing less.
template <class S>
Vec3<Rational> exactly(const Vec3<S>& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

/// Returns: the most that a·d comes to over a list of points, and the most of |x d.x| + |y d.y| + |z d.z|.
template <class S>
std::pair<Rational, Rational> reach_and_size(const std::vector<Vec3<S>>& points, const Vec3<Rational>& d) {
  std::pair<Rational, Rational> most{exactly(points[0]).dot(d), 0};
  for (const Vec3<S>& point : points) {
    const Vec3<Rational> products = exactly(point).cwiseProduct(d);
    most.first = std::max(most.first, Rational(products.sum()));
    most.second = std::max(most.second, Rational(products.cwiseAbs().sum()));
  }
  return most;
}

TEMPLATE_TEST_CASE("A separation below its error bound is a proof, and rounding comes to a thirtieth of the bound",
                   "[random]", float, double) {
  using S = TestType;
  const std::uint64_t seed = 12;
  INFO("seed " << seed);
  Dice dice(seed);
  const Rational epsilon(std::numeric_limits<S>::epsilon());
  const auto cloud = [&](double from) {
    std::vector<Vec3<S>> points;
    for (int i = 0; i < 6; ++i)
      points.emplace_back(static_cast<S>(from + dice.between(0., 1.)), static_cast<S>(dice.between(0., 1.)),
                          static_cast<S>(dice.between(0., 1.)));
    return points;
  };
  int separated = 0, proofs = 0;
  Rational worst = 0;
  for (int i = 0; i < 2000; ++i) {
    INFO("pair " << i);
    // The corner of one is the other's, moved by some roundings, so that many gaps are near the bound.
    const std::vector<Vec3<S>> a = cloud(0);
    std::vector<Vec3<S>> b = cloud(1);
    b[0] = a[0] * (S(1) + S(dice.between(0, 40)) * std::numeric_limits<S>::epsilon());
    const Result<S> result = asked<S>(PointSet<S>(a), PointSet<S>(b));
    if (!result.separation) continue;
    ++separated;
    const Vec3<Rational> d = exactly(result.separation->direction);
    const auto [reach_a, size_a] = reach_and_size(a, d);
    const auto [reach_minus_b, size_b] = reach_and_size(b, Vec3<Rational>(-d));
    const Rational bound = 6 * epsilon * (size_a + size_b), told(result.separation->support_value);
    const Rational off = abs(reach_a + reach_minus_b - told);
    REQUIRE(off <= bound);
    worst = std::max(worst, Rational(off / bound));
    if (told >= -bound) continue;
    ++proofs;
    REQUIRE(reach_a + reach_minus_b < 0);
  }
  REQUIRE(proofs > 100);
  REQUIRE(proofs < separated);  // some gaps are too small to be believed
  REQUIRE(worst > Rational(1, 30));
}

}  // namespace
}  // namespace gjk::test
