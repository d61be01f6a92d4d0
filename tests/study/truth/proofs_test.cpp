#include "tests/study/truth/proofs.hpp"

#include "tests/kit/catch.hpp"
#include "tests/study/pairs/hulls.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace proofs_test {

const Points square_base{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};

Rational third() { return Rational(1, 3); }

TEST_CASE("Proofs: a direction separates where all of A lies before all of B, and not where they touch", "[proofs]") {
  const Points above{{1, 1, 0.5}, {2, 1, 3}}, on{{1, 1, 0}, {2, 1, 3}};
  CHECK(separates({0, 0, 1}, {square_base, above}));
  CHECK_FALSE(separates({0, 0, -1}, {square_base, above}));
  CHECK_FALSE(separates({0, 0, 1}, {square_base, on}));
  CHECK_FALSE(separates({0, 0, 0}, {square_base, above}));
}

TEST_CASE("Proofs: a direction between balls and cylinders is looked at without roots", "[proofs]") {
  const Ball ball{{0, 0, 0}, 1}, at_gap{{3, 4, 0}, 3.999999}, touching{{3, 4, 0}, 4};
  CHECK(separates({3, 4, 0}, {ball, at_gap}));
  CHECK_FALSE(separates({3, 4, 0}, {ball, touching}));
  CHECK_FALSE(separates({1, 0, 0}, {ball, at_gap}));
  const Can can{{0, 0, 0}, {0, 0, 2}, 1, 2};  // |z| <= 1
  CHECK(separates({0, 0, 1}, {can, Ball{{0, 0, 3}, 1.5}}));
  CHECK_FALSE(separates({0, 0, 1}, {can, Ball{{0, 0, 3}, 2}}));
  CHECK(separates({1, 0, 1}, {can, Points{{1.25, 0, 1.25}}}));
  CHECK_FALSE(separates({1, 0, 1}, {can, Points{{1, 0, 1}}}));
  CHECK_THROWS_AS(separates({1, 0, 0}, {Can{{0, 0, 0}, {1, 1, 0}, 1, 2}, ball}), std::invalid_argument);
}

TEST_CASE("Proofs: a body holds a point, also one that no double can be", "[proofs]") {
  const Points triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(contains(triangle, {third(), third(), 0}));
  CHECK(contains(triangle, {third(), 2 * third(), 0}));
  CHECK_FALSE(contains(triangle, {third(), 2 * third() + Rational(1, 1000000), 0}));
  CHECK_FALSE(contains(triangle, {third(), third(), Rational(1, 1000000)}));
  CHECK(contains(Ball{{0, 0, 0}, 3}, {1, 2, 2}));
  CHECK_FALSE(contains(Ball{{0, 0, 0}, 3}, {1, 2, 2 + Rational(1, 1000000)}));
  CHECK(contains(Can{{0, 0, 0}, {0, 0, 1}, 5, 2}, {3, 4, 1}));
  CHECK_FALSE(contains(Can{{0, 0, 0}, {0, 0, 1}, 5, 2}, {3, 4, 1 + third()}));
  CHECK_FALSE(contains(Can{{0, 0, 0}, {0, 0, 1}, 5, 2}, {3, 5, 0}));
}

TEST_CASE("Proofs: sets only touch where moving one in some direction parts them", "[proofs]") {
  const Points cube{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};
  CHECK(only_touch({cube, plus({2, 0, 0}, cube)}));
  CHECK_FALSE(only_touch({cube, plus({1.9, 0, 0}, cube)}));
  CHECK(only_touch({square_base, Points{{1, 1, 0}, {2, 2, 0}, {1, 2, 0}}}));  // in one plane
  const Points through{{0, 0, 0}, {0, 0, 2}};
  CHECK_FALSE(only_touch({through, Points{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}}));
  CHECK(only_touch({through, Points{{0, -1, 1}, {1, -1, 1}, {0, 1, 1}}}));  // an edge on it
  CHECK(only_touch({Ball{{0, 0, 0}, 1}, Ball{{3, 4, 0}, 4}}));
  CHECK_FALSE(only_touch({Ball{{0, 0, 0}, 1}, Ball{{3, 4, 0}, 4.5}}));
}

TEST_CASE("Proofs: balls and cylinders have a direction or a point that proves what the oracle says", "[proofs]") {
  int apart = 0, together = 0;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Pair pair = family.make(3, i % family.size.value_or(300));
      if (std::holds_alternative<Points>(pair.a)) break;
      INFO(family.name << " " << i);
      if (truth(pair) == Truth::separated) {
        ++apart;
        REQUIRE(separates(direction_between(pair), pair));
      } else {
        ++together;
        const RationalVec point = common_point(pair);
        REQUIRE(contains(pair.a, point));
        REQUIRE(contains(pair.b, point));
      }
    }
  REQUIRE(apart > 500);
  REQUIRE(together > 500);
}

}  // namespace proofs_test
}  // namespace study
