/// The plain call allocates nothing, nor does the certified one for ordinary numbers.
#include <map>

#include "core/certified/certified.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {

/// Returns: how many times memory was asked for with new since the program started; see counting_new.cpp.
std::size_t allocations();

namespace {

template <class A, class B>
void require_no_heap(const A& a, const B& b) {
  std::size_t before = allocations();
  const Result<double> plain = collision<double>(a, b);
  const std::size_t made = allocations() - before;
  REQUIRE(made == 0);
  // The counter must be able to see an allocation: the same call, observed, makes some.
  Trace<double> trace;
  before = allocations();
  const Result<double> told = collision<double>(a, b, {}, trace);
  const std::size_t made_telling = allocations() - before;
  REQUIRE(made_telling > 0);
  REQUIRE(told == plain);
}

TEST_CASE("The plain call allocates nothing on the heap, decided or not; the observed one does", "[heap]") {
  Dice dice(12);
  const Sphere<double> ball(Vec3<double>(1, 1, 1), 1.5), far(Vec3<double>(5, -3, 2), 1);
  require_no_heap(ball, far);
  for (int i = 0; i < 5000; ++i) {
    const PairOfHulls t = random_pair(dice);
    INFO("pair " << i);
    require_no_heap(point_set<double>(t.a), point_set<double>(t.b));
    require_no_heap(point_set<double>(t.a), ball);
  }
}

TEST_CASE("The certified call allocates nothing for ordinary numbers, whatever proves its answer", "[heap]") {
  Dice dice(13);
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
  for (const Proof proof : {Proof::direction, Proof::tetrahedron, Proof::exact_fallback}) REQUIRE(proofs[proof] > 50);
}

}  // namespace
}  // namespace gjk::test
