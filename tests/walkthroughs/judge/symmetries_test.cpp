// What is done to pairs is what its name says and rounds nothing.
#include "walkthroughs/judge/symmetries.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "tests/kit/catch.hpp"

namespace walkthroughs::judge {
namespace {

using Set = PointsOf<double>;

const PointPair pair{{{0, 1, 2}, {3, 5, -1}, {0.5, 0, 0}}, {{-4, 1, 1}, {2, 2, 0.25}}};

std::vector<PointPair> many(Symmetry symmetry, const PointPair& of = pair) {
  std::vector<PointPair> all;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Dice dice(1, "symmetries", i);
    if (const auto one = after(symmetry, of, dice)) all.push_back(*one);
  }
  return all;
}

bool is_same_set(Set x, Set y) {
  const auto before = [](const Vec& p, const Vec& q) {
    return std::ranges::lexicographical_compare(std::vector(p.begin(), p.end()), std::vector(q.begin(), q.end()));
  };
  std::ranges::sort(x, before);
  std::ranges::sort(y, before);
  return x == y;
}

/// Squares of all distances between points, of one set or of both: what no motion changes.
std::multiset<double> distances(const PointPair& p) {
  Set all = p.a;
  all.insert(all.end(), p.b.begin(), p.b.end());
  std::multiset<double> squares;
  for (const Vec& x : all)
    for (const Vec& y : all) squares.insert((x - y).squaredNorm());
  return squares;
}

}  // namespace

TEST_CASE("Exchanging, permuting and repeating points keeps the sets", "[symmetries]") {
  for (const auto& changed : many(Symmetry::exchanged)) {
    REQUIRE(changed.a == pair.b);
    REQUIRE(changed.b == pair.a);
  }
  bool is_other = false;
  for (const auto& changed : many(Symmetry::permuted)) {
    REQUIRE(is_same_set(changed.a, pair.a));
    REQUIRE(is_same_set(changed.b, pair.b));
    is_other = is_other || changed.a != pair.a;
  }
  REQUIRE(is_other);
  for (const auto& changed : many(Symmetry::repeated)) {
    REQUIRE(changed.a.size() > pair.a.size());
    REQUIRE(changed.b.size() > pair.b.size());
    for (const Vec& p : changed.a) REQUIRE(std::ranges::count(pair.a, p) == 1);
    for (const Vec& p : pair.a) REQUIRE(std::ranges::count(changed.a, p) >= 1);
  }
}

TEST_CASE("Turning with the cube and moving keep all distances", "[symmetries]") {
  for (const Symmetry symmetry : {Symmetry::turned, Symmetry::moved}) {
    int others = 0;
    for (const auto& changed : many(symmetry)) {
      REQUIRE(distances(changed) == distances(pair));
      others += changed.a != pair.a;
    }
    REQUIRE(others > 150);
  }
}

TEST_CASE("Scaling goes to both ends of the range and loses no digit", "[symmetries]") {
  double least = 1, most = 1;
  for (const auto& changed : many(Symmetry::scaled)) {
    const double factor = changed.a[0].y();  // of 1
    for (std::size_t i = 0; i < pair.a.size(); ++i) REQUIRE(changed.a[i] == Vec(factor * pair.a[i]));
    REQUIRE(Vec(changed.a[2] / factor) == pair.a[2]);
    least = std::min(least, factor);
    most = std::max(most, factor);
  }
  REQUIRE(0.25 * least == std::numeric_limits<double>::denorm_min());
  REQUIRE(5 * most <= std::numeric_limits<double>::max());
  REQUIRE(16 * most > std::numeric_limits<double>::max());
}

TEST_CASE("Where the numbers leave no room nothing is done", "[symmetries]") {
  const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const PointPair wide{{{largest, 0, 0}}, {{least, least, least}}};
  REQUIRE(many(Symmetry::scaled, wide).size() == 200);  // by 1
  for (const auto& changed : many(Symmetry::scaled, wide)) REQUIRE(changed.a == wide.a);
  REQUIRE(many(Symmetry::moved, wide).empty());
}

}  // namespace walkthroughs::judge
