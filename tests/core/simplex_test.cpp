#include "core/simplex.hpp"

#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

Simplex<double> of_first(int size) {
  Simplex<double> simplex;
  for (int i = 0; i < size; ++i)
    simplex.add({{Vec3<double>(i, 0, 0), i}, {Vec3<double>(0, 0, 0)}, Vec3<double>(i, 0, 0)});
  return simplex;
}

TEST_CASE("A simplex counts from the oldest vertex, and by roles from the newest", "[simplex]") {
  const Simplex<double> simplex = of_first(4);
  REQUIRE(simplex.size() == 4);
  for (int i = 0; i < 4; ++i) {
    REQUIRE(simplex[i].w.x() == i);
    REQUIRE(simplex[static_cast<Role>(i)].w.x() == 3 - i);
    REQUIRE(simplex.point(static_cast<Role>(i)).x() == 3 - i);
    REQUIRE(letter(static_cast<Role>(i)) == "ABCD"[i]);
  }
}

TEST_CASE("Of a simplex the vertices of some roles are kept in the order that is asked for", "[simplex]") {
  const Simplex<double> kept = of_first(4).only({Role::C, Role::A, Role::B});
  REQUIRE(kept.size() == 3);
  REQUIRE(kept[0].w.x() == 1);
  REQUIRE(kept[1].w.x() == 3);
  REQUIRE(kept[2].w.x() == 2);
}

TEST_CASE("Simplices are the same where they have the same vertices in the same order, and no more", "[simplex]") {
  for (int n = 0; n <= 4; ++n)
    for (int m = 0; m <= 4; ++m) REQUIRE((of_first(n) == of_first(m)) == (n == m));
  REQUIRE_FALSE(of_first(2) == of_first(2).only({Role::A, Role::B}));
}

TEST_CASE("A copy has what was there, and nothing of what it had before", "[simplex]") {
  for (int n = 0; n <= 4; ++n) {
    Simplex<double> copy = of_first(4).only({Role::A, Role::B, Role::C, Role::D});
    copy = of_first(n);
    REQUIRE(copy == of_first(n));
    const Simplex<double>& self = copy;
    copy = self;
    REQUIRE(copy == of_first(n));
    REQUIRE(Simplex<double>(copy) == of_first(n));
  }
}

}  // namespace
}  // namespace gjk::test
