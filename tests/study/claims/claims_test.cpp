/// What the counts of few pairs in ../golden cannot show; report_test.py looks at those.
#include "tests/study/claims/claims.hpp"

#include "tests/kit/catch.hpp"

namespace study {
namespace claims_test {

TEST_CASE("Float and double are given the same triangles", "[claims]") {
  for (const TriangleKind& kind : triangle_kinds())
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Pair pair = kind.make(1, i);
      for (const Body& body : {pair.a, pair.b})
        for (const Vec& p : std::get<Points>(body))
          for (const double x : p) REQUIRE(x == static_cast<double>(static_cast<float>(x)));
    }
}

TEST_CASE("Of small triangles far apart for their size Moeller's test, snapped, says that they meet", "[claims]") {
  using enum Compared;
  const TriangleKind small{"small", [](std::uint64_t, std::uint64_t) {
                             return Pair{Points{{0, 0, 0}, {0x1p-10, 0, 0}, {0, 0x1p-10, 0}},
                                         Points{{0, 0, 0.5}, {0x1p-10, 0, 0.5}, {0, 0x1p-10, 0.5}}};
                           }};
  const Comparisons compared = compare_with_moller(small, {.pairs = 10, .seed = 1, .threads = 1});
  for (std::size_t way = 0; way < way_names.size(); ++way) {
    INFO(way_names[way]);
    const bool is_snapped = way >= 2;
    const Comparison& counts = compared[0][way];
    CHECK(counts[only_moller] == (is_snapped ? 10 : 0));
    CHECK(counts[only_moller_right] == 0);
    CHECK(counts[only_moller_beyond_plane] == (is_snapped ? 10 : 0));
    CHECK(counts[both_no] == (is_snapped ? 0 : 10));
  }
}

}  // namespace claims_test
}  // namespace study
