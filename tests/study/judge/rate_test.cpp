#include "tests/study/judge/rate.hpp"

#include "tests/kit/catch.hpp"

namespace study {

TEST_CASE("Score intervals are those that were computed by hand", "[rate]") {
  // z² = 3.841459. For 5 of 10: (5 + z²/2) / (10 + z²) = 0.5, half = z √(2.5 + z²/4) / (10 + z²) = 0.263408.
  REQUIRE(wilson(5, 10).low == Approx(0.236592).epsilon(1e-4));
  REQUIRE(wilson(5, 10).high == Approx(0.763408).epsilon(1e-4));
  // For 1 of 10: (1 + z²/2) / (10 + z²) = 0.211010, half = z √(0.9 + z²/4) / (10 + z²) = 0.193141.
  REQUIRE(wilson(1, 10).low == Approx(0.017876).epsilon(1e-3));
  REQUIRE(wilson(1, 10).high == Approx(0.404150).epsilon(1e-4));
  // Where nothing was seen the upper end is z² / (n + z²).
  REQUIRE(wilson(0, 1000000).low == 0);
  REQUIRE(wilson(0, 1000000).high == Approx(3.841459 / 1000003.841459).epsilon(1e-6));
  REQUIRE(wilson(10, 10).high == 1);
  REQUIRE(wilson(10, 10).low == Approx(1 - 3.841459 / 13.841459).epsilon(1e-6));
}

}  // namespace study
