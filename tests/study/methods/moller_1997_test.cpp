#include "tests/study/methods/moller_1997.hpp"

#include <algorithm>
#include <map>

#include "core/gjk.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/pairs/random_triangles.hpp"
#include "tests/study/truth/oracle.hpp"
#include "tests/study/truth/exact_number.hpp"

namespace study::moller_1997 {
namespace moller_1997_test {

using Exact = study::Exact;

template <class S>
Finding<S> found(const Points& first, const Points& second, Distances treatment = Distances::as_computed) {
  return find(triangle_of<S>(first), triangle_of<S>(second), treatment);
}

/// One run over many pairs: how each answer was found.
struct Seen {
  std::map<How, int> yes, no;
};

Seen agree_with_the_oracle(int levels, bool in_one_plane, std::uint64_t pairs) {
  Seen seen;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    Dice dice(7, "moller", i);
    Pair pair = coarse_triangles(dice, levels, 1);
    if (in_one_plane)  // askew: (x, y) stands for (x, y, x + 2 y)
      for (Body* const body : {&pair.a, &pair.b})
        for (Vec& p : std::get<Points>(*body)) p[2] = p[0] + 2 * p[1];
    const Points &a = std::get<Points>(pair.a), &b = std::get<Points>(pair.b);
    if (is_flat(a) || is_flat(b)) continue;
    const auto finding = found<Exact>(a, b);
    INFO("pair " << i);
    REQUIRE(finding.meet == (truth(pair) == Truth::intersecting));
    ++(finding.meet ? seen.yes : seen.no)[finding.how];
  }
  return seen;
}

TEST_CASE("Moeller 1997: in exact numbers it agrees with the oracle on triangles of a grid, also in one plane askew",
          "[moller]") {
  Seen seen = agree_with_the_oracle(4, false, 6000);
  REQUIRE(seen.yes[How::intervals] > 1000);
  REQUIRE(seen.no[How::intervals] > 1000);
  REQUIRE(seen.no[How::beyond_a_plane] > 500);
  seen = agree_with_the_oracle(6, true, 3000);
  REQUIRE(seen.yes[How::in_one_plane] > 1000);
  REQUIRE(seen.no[How::in_one_plane] > 100);
}

TEMPLATE_TEST_CASE("Moeller 1997: a corner just short of the other triangle touches it once distances are snapped",
                   "[moller]", float, double, Exact) {
  const Points unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};                         // |N| = 1: distances are lengths
  const Points above{{0.25, 0.25, 0x1p-21}, {0.25, 0.5, 1}, {0.5, 0.25, 1}};  // 2^-21 < 1e-6
  REQUIRE_FALSE(found<TestType>(unit, above).meet);
  REQUIRE(found<TestType>(unit, above, Distances::small_ones_snapped).meet);
  const Points higher{{0.25, 0.25, 0x1p-19}, {0.25, 0.5, 1}, {0.5, 0.25, 1}};
  REQUIRE_FALSE(found<TestType>(unit, higher, Distances::small_ones_snapped).meet);
}

/// The report's two disagreements were of this kind (Section 4): "the triangles intersected at exactly 1 point along an
/// edge. The intersection point was not any of the vertices, nor were the triangles coplanar".
TEST_CASE("Moeller 1997: of whole-number triangles that touch along edges rounding finds some apart", "[moller]") {
  const Points a{{6, 5, 7}, {1, 4, 1}, {5, 2, 7}}, b{{4, 3, 5}, {3, 2, 5}, {3, 1, 5}};
  REQUIRE(truth({a, b}) == Truth::intersecting);
  const auto exactly = found<Exact>(a, b);
  REQUIRE(exactly.meet);
  REQUIRE(exactly.second.most == exactly.first.least);
  for (const auto& distances : {exactly.first_distances, exactly.second_distances})
    REQUIRE(std::ranges::count(distances, Exact(0)) == 0);
  REQUIRE_FALSE(found<double>(a, b).meet);
  REQUIRE_FALSE(found<double>(a, b, Distances::small_ones_snapped).meet);
  const gjk::PointSet<double> first(a), second(b);
  REQUIRE(gjk::collision<double>(first, second).status == gjk::Status::intersecting);
}

/// The common corner, (26, 18, 96), is at distance 0 from both planes, without rounding. One edge of A cuts B's plane
/// there: its place, found from the edge's other end at y = 95, is 95 + (18 - 95)·d/(d - 0), which ought to be 18. But
/// -77·-219,385 = 16,892,645 has more than 24 binary digits: in float the product is rounded, the quotient is not -77,
/// and A's interval begins at 18 + 2^-17, while B's is the corner alone. A snap of distances comes before that and
/// changes nothing; in double, with 53 digits, the product is exact.
TEST_CASE("Moeller 1997: in float a product of whole numbers is rounded and a common corner is missed", "[moller]") {
  const Points a{{26, 18, 96}, {92, 95, 29}, {15, 98, 72}}, b{{26, 18, 96}, {57, 93, 28}, {84, 15, 18}};
  for (const auto treatment : {Distances::as_computed, Distances::small_ones_snapped}) {
    const auto in_float = found<float>(a, b, treatment);
    REQUIRE(in_float.first_distances == std::array<float, 3>{0, -219385, 51146});
    REQUIRE(in_float.second_distances[0] == 0);
    REQUIRE(in_float.second.least == 18);
    REQUIRE(in_float.second.most == 18);
    REQUIRE(in_float.first.least == 18 + 0x1p-17F);
    REQUIRE_FALSE(in_float.meet);
    REQUIRE(found<double>(a, b, treatment).first.least == 18);
    REQUIRE(found<double>(a, b, treatment).meet);
  }
  REQUIRE(truth({a, b}) == Truth::intersecting);
}

}  // namespace moller_1997_test
}  // namespace study::moller_1997
