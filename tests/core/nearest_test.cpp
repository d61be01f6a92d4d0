/// The feature of a simplex that is nearest to the origin, against one found by trying all of them in fractions.
#include "core/nearest.hpp"

#include <map>

#include "core/certified.hpp"
#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

/// Letters of the vertices of a feature, A first.
std::string feature_of(const Order& order) {
  std::string letters;
  for (const Role role : order) letters += letter(role);
  std::sort(letters.begin(), letters.end());
  return letters;
}

struct Nearest {
  std::string feature;
  bool is_on_a_boundary;  ///< some vertex off the feature is no farther along −v than it
};

/// The one feature whose point v nearest to the origin lies in its interior, all vertices w being beyond: (w − v)·v >= 0.
/// Where a face of a tetrahedron holds the origin, so does the tetrahedron, and is as good.
///
/// Requires: affinely independent points. `newest_first`: their letters are A, B, C, D.
Nearest found_by_trying_all(const ExactVecs& newest_first) {
  for (std::uint32_t chosen = 1; chosen < (1u << newest_first.size()); ++chosen) {
    ExactVecs subset;
    Nearest found{"", false};
    for (std::size_t i = 0; i < newest_first.size(); ++i)
      if (chosen & (1u << i)) {
        subset.push_back(newest_first[i]);
        found.feature += "ABCD"[i];
      }
    const auto weights = coordinates_of_origin(subset);
    if (std::any_of(weights.begin(), weights.end(), [](const Rational& x) { return x <= 0; })) continue;
    const ExactVec v = -toward_origin(subset);
    std::vector<Rational> beyond;
    for (std::size_t i = 0; i < newest_first.size(); ++i)
      if (!(chosen & (1u << i))) beyond.push_back((newest_first[i] - v).dot(v));
    if (std::any_of(beyond.begin(), beyond.end(), [](const Rational& x) { return x < 0; })) continue;
    if (v == ExactVec(ExactVec::Zero()) && subset.size() == 3 && newest_first.size() == 4) found.feature = "ABCD";
    found.is_on_a_boundary = std::any_of(beyond.begin(), beyond.end(), [](const Rational& x) { return x == 0; });
    return found;
  }
  throw std::logic_error("some feature is nearest");
}

/// Returns: what nearest_with_A() says of these points, the last of which is A.
Order asked(const std::vector<Vec3<double>>& oldest_first) {
  const PointSet<double> a(oldest_first), origin({Vec3<double>::Zero()});
  const detail::ExactDifference<double> difference(a, origin);
  detail::ExactSimplex<double> simplex(difference);
  for (int i = 0; i < static_cast<int>(oldest_first.size()); ++i) simplex.add({i, 0});
  return detail::nearest_with_A(simplex, simplex.size());
}

struct Tally {
  std::map<std::string, int> features;
  int on_a_boundary = 0;
};

Tally compare(int size, int tries, std::uint64_t seed) {
  Dice dice(seed);
  Tally tally;
  for (int i = 0; i < tries; ++i) {
    const std::vector<Vec3<double>> oldest_first = point_set<double>(dice.points(size, i % 8 == 0 ? 9 : 2)).points();
    ExactVecs newest_first = exact(oldest_first);
    std::reverse(newest_first.begin(), newest_first.end());
    if (gram_determinant(newest_first) == 0) continue;
    const Nearest expected = found_by_trying_all(newest_first);
    if (expected.feature[0] != 'A') continue;
    const Order found = asked(oldest_first);
    INFO("simplex " << i << " of " << size);
    REQUIRE(feature_of(found) == expected.feature);
    REQUIRE(*(found.end() - 1) == Role::A);
    ++tally.features[expected.feature];
    tally.on_a_boundary += expected.is_on_a_boundary;
  }
  return tally;
}

void require_each_seen(const Tally& tally, const std::vector<std::string>& features, int times) {
  REQUIRE(tally.features.size() == features.size());
  for (const std::string& feature : features) {
    INFO(feature << " was nearest " << tally.features.at(feature) << " times");
    REQUIRE(tally.features.at(feature) >= times);
  }
}

TEST_CASE("The feature of a simplex that is nearest to the origin, if A is in it", "[nearest][unsanitized]") {
  require_each_seen(compare(1, 50, 60), {"A"}, 50);
  const Tally segments = compare(2, 1000, 61), triangles = compare(3, 4000, 62), tetrahedra = compare(4, 7000, 63);
  require_each_seen(segments, {"A", "AB"}, 50);
  REQUIRE(segments.on_a_boundary > 10);
  require_each_seen(triangles, {"A", "AB", "AC", "ABC"}, 50);
  REQUIRE(triangles.on_a_boundary > 100);
  require_each_seen(tetrahedra, {"A", "AB", "AC", "AD", "ABC", "ABD", "ACD", "ABCD"}, 50);
  REQUIRE(tetrahedra.on_a_boundary > 300);
}

}  // namespace
}  // namespace gjk::test
