/// Random convex pairs against answers found in another way.
#include "tests/core/certified_support.hpp"
#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace random_test {

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

Vec3<double> any_point(Dice& dice) { return {dice.between(-1., 1.), dice.between(-1., 1.), dice.between(-1., 1.)}; }

TEST_CASE(
    "Tetrahedra on a roomy lattice, on a crowded one, where touching is common, and anywhere: GJK is proven right",
    "[random]") {
  Dice dice(1);
  Tally roomy, crowded, anywhere;
  const auto compare = [](Tally& tally, const auto& a, const auto& b) {
    const Pair<double> pair = pair_of<double>(a, b);
    count(tally, asked<double>(pair.a, pair.b).status, proven(pair).status == Status::intersecting);
  };
  for (int i = 0; i < 3000; ++i) {
    INFO("pair " << i);
    // Products of four differences of numbers below 1000 stay far below 2^53: double computes exactly.
    compare(roomy, dice.points(4, 500), moved(dice.points(4, 500), dice.point(320)));
    compare(crowded, dice.points(4, 3), moved(dice.points(4, 3), dice.point(1)));
    std::vector<Vec3<double>> a(4), b(4);
    for (Vec3<double>& p : a) p = any_point(dice);
    const Vec3<double> apart = 0.5 * any_point(dice);
    for (Vec3<double>& p : b) p = any_point(dice) + apart;
    compare(anywhere, a, b);
  }
  for (const Tally& tally : {roomy, crowded, anywhere}) {
    require_balanced(tally);
    REQUIRE(tally.undecided <= 5);
  }
}

TEST_CASE("Small integers are exact in double: the run is the exact one, event for event", "[random]") {
  Dice dice(4);
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

TEST_CASE("Spheres, and a sphere against a point: GJK agrees with the distance of the centers, at all scales",
          "[random]") {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    Dice dice(6);
    Tally spheres, points;
    for (int i = 0; i < 7000; ++i) {
      const Vec3<double> c = any_point(dice), d = any_point(dice);
      const double r = dice.between(0.1, 1.0), q = dice.between(0.1, 1.0), ball = dice.between(0.5, 1.3);
      const double gap = (c - d).norm() - (r + q);
      if (std::abs(gap) < 1e-9) continue;  // too close for rounded support points to tell
      INFO("pair " << i << ", gap " << gap << " times " << scale);
      const Sphere<double> a(scale * c, scale * r), b(scale * d, scale * q);
      count(spheres, asked<double>(a, b).status, gap < 0);
      const Sphere<double> around_origin(Vec3<double>::Zero(), scale * ball);
      count(points, asked<double>(PointSet<double>({scale * c}), around_origin).status, c.norm() < ball);
    }
    for (const Tally& tally : {spheres, points}) {
      require_balanced(tally);
      REQUIRE(tally.undecided <= 5);
    }
  }
}

/// Returns: the most that a·d comes to over a list of points, and the most of |x d.x| + |y d.y| + |z d.z|.
template <class S>
std::pair<Rational, Rational> reach_and_size(const std::vector<Vec3<S>>& points, const Vec3<Rational>& d) {
  std::pair<Rational, Rational> most{exact(points[0]).dot(d), 0};
  for (const Vec3<S>& point : points) {
    const Vec3<Rational> products = exact(point).cwiseProduct(d);
    most.first = std::max(most.first, Rational(products.sum()));
    most.second = std::max(most.second, Rational(products.cwiseAbs().sum()));
  }
  return most;
}

TEMPLATE_TEST_CASE("A separation below its error bound is a proof, and rounding comes to a thirtieth of the bound",
                   "[random]", float, double) {
  using S = TestType;
  Dice dice(12);
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
    const Vec3<Rational> d = exact(result.separation->direction);
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

}  // namespace random_test
}  // namespace gjk::test
