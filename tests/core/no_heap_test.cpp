/// The plain call allocates nothing, nor does the certified one for ordinary numbers.
#include <map>

#include "core/certified.hpp"
#include "tests/core/counting_new.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

using V = Vec3<double>;

struct Counted {
  Result<double> result;
  std::size_t allocations;
};

template <class Call>
Counted counted(const Call& call) {
  const std::size_t before = allocations();
  const Result<double> result = call();
  return {result, allocations() - before};
}

template <class A, class B>
void require_no_heap(const A& a, const B& b, Status expected) {
  const Counted plain = counted([&] { return collision<double>(a, b); });
  REQUIRE(plain.allocations == 0);
  REQUIRE(plain.result.status == expected);
  // The counter must be able to see an allocation: the same call, observed, makes some.
  Trace<double> trace;
  const Counted told = counted([&] { return collision<double>(a, b, {}, trace); });
  REQUIRE(told.allocations > 0);
  REQUIRE(told.result == plain.result);
}

TEST_CASE("The plain call allocates nothing on the heap, the observed one does", "[heap]") {
  const auto t = point_set<double>(corner);
  const Sphere<double> ball(V(1, 1, 1), 1.5);
  SECTION("point sets that meet") {
    require_no_heap(t, point_set<double>(moved(corner, {1, 2, -1})), Status::intersecting);
  }
  SECTION("point sets that do not") {
    require_no_heap(t, point_set<double>(moved(corner, {4, 5, 6})), Status::separated);
  }
  SECTION("spheres that meet") { require_no_heap(ball, Sphere<double>(V(2, 0, 2.5), 1), Status::intersecting); }
  SECTION("spheres that do not") { require_no_heap(ball, Sphere<double>(V(5, -3, 2), 1), Status::separated); }
  SECTION("a sphere and a point set") { require_no_heap(t, ball, Status::intersecting); }
}

TEST_CASE("The plain call allocates nothing over thousands of random pairs, decided or not", "[heap]") {
  const std::uint64_t seed = 12;
  INFO("seed " << seed);
  Dice dice(seed);
  for (int i = 0; i < 5000; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto a = point_set<double>(t.a), b = point_set<double>(t.b);
    const Counted plain = counted([&] { return collision<double>(a, b); });
    INFO("pair " << i);
    REQUIRE(plain.allocations == 0);
  }
}

TEST_CASE("The certified call allocates nothing for ordinary numbers, whatever proves its answer", "[heap]") {
  const std::uint64_t seed = 13;
  INFO("seed " << seed);
  Dice dice(seed);
  std::map<Proof, int> proofs;
  for (int i = 0; i < 2000; ++i) {
    const PairOfHulls t = random_pair(dice);
    const Frame<double> frame = i % 2 == 0 ? axis_aligned("1", 1.0) : skew("1/7", 1.0 / 7);
    const PointSet<double> a(seen(t.a, frame)), b(seen(t.b, frame));
    const std::size_t before = allocations();
    const CertifiedResult result = certified_collision(a, b);
    const CertifiedResult from_inside = certified_collision(a, b, {.inside = PointOfEach<double>{a.mean(), b.mean()}});
    const std::size_t made = allocations() - before;
    INFO("pair " << i);
    REQUIRE(made == 0);
    REQUIRE(from_inside.status == result.status);
    ++proofs[result.proof];
  }
  for (const Proof proof : {Proof::direction, Proof::tetrahedron, Proof::second_search}) REQUIRE(proofs[proof] > 50);
}

}  // namespace
}  // namespace gjk::test
