#include "tests/study/truth/nearest_feature.hpp"

#include <map>

#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"

namespace study {
namespace nearest_feature_test {

gjk::Simplex<double> simplex_of(const std::vector<gjk::Vec3<double>>& oldest_first) {
  gjk::Simplex<double> simplex;
  for (const auto& w : oldest_first) simplex.add({{}, {}, w});
  return simplex;
}

/// The feature that carries the nearest point, by barycentric coordinates: of all features over whose inside the origin
/// lies, the one that is least far away. Requires: the simplex is not flat.
Feature nearest_by_coordinates(const gjk::Simplex<double>& simplex) {
  gjk::test::Rational least = -1;
  Feature nearest = 0;
  for (Feature feature = 1; feature < 1U << simplex.size(); ++feature) {
    gjk::test::ExactVecs points;
    for (int i = 0; i < simplex.size(); ++i)
      if (feature >> i & 1U) points.push_back(gjk::test::exact(simplex.point(static_cast<gjk::Role>(i))));
    const auto coordinates = gjk::test::coordinates_of_origin(points);
    if (std::any_of(coordinates.begin(), coordinates.end(), [](const auto& c) { return c <= 0; })) continue;
    const auto way = gjk::test::toward_origin(points);
    if (least >= 0 && way.dot(way) >= least) continue;
    least = way.dot(way);
    nearest = feature;
  }
  return nearest;
}

bool is_flat(const gjk::Simplex<double>& simplex) {
  gjk::test::ExactVecs points;
  for (int i = 0; i < simplex.size(); ++i) points.push_back(gjk::test::exact(simplex[i].w));
  return gjk::test::gram_determinant(points) == 0;
}

TEST_CASE("The nearest feature of small whole-number simplices is the one found by barycentric coordinates",
          "[effort]") {
  for (int size = 2; size <= 4; ++size) {
    gjk::test::Dice dice(static_cast<std::uint64_t>(size));
    std::map<Feature, int> seen;
    for (int i = 0; i < 1500; ++i) {
      std::vector<gjk::Vec3<double>> points;
      for (int k = 0; k < size; ++k) points.push_back(gjk::test::vec<double>(dice.point(3)));
      const auto simplex = simplex_of(points);
      if (is_flat(simplex)) continue;
      INFO("simplex " << i << " of " << size);
      const Feature nearest = nearest_feature(simplex);
      REQUIRE(letters(nearest) == letters(nearest_by_coordinates(simplex)));
      ++seen[nearest];
    }
    REQUIRE(seen.size() == (1U << size) - 1);
  }
}

TEST_CASE("The nearest feature is right where it hangs on a single rounding", "[effort]") {
  const double tiny = 0x1p-600;  // squared, it vanishes even beside 0 in long double's products with 1
  const gjk::Vec3<double> B(1, 0, 0);
  REQUIRE(letters(nearest_feature(simplex_of({B, {0, 1, 0}}))) == "AB");
  REQUIRE(letters(nearest_feature(simplex_of({{1, 0, 0}, {tiny, 1, 0}}))) == "AB");
  REQUIRE(letters(nearest_feature(simplex_of({{1, 1, 0}, {-tiny, 1, 0}}))) == "AB");
  REQUIRE(letters(nearest_feature(simplex_of({{1, 1, 0}, {tiny, 1, 0}}))) == "A");
  REQUIRE(letters(nearest_feature(simplex_of({{1, 1, 0}, {0, 1, 0}}))) == "A");
}

TEST_CASE("Of a flat simplex no nearest feature is told where only its inside could be", "[effort]") {
  REQUIRE(nearest_feature(simplex_of({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}})) != 15);
  REQUIRE(letters(nearest_feature(simplex_of({{1, 1, 0}, {2, 2, 0}, {3, 3, 0}}))) == "C");
}

TEST_CASE("The origin lies on a feature or beyond it and rounding does not blur the two", "[effort]") {
  const double tiny = 0x1p-600;
  const auto on = [](const std::vector<gjk::Vec3<double>>& oldest_first) {
    const auto simplex = simplex_of(oldest_first);
    return letters(nearest_feature(simplex)) + (lies_on(simplex, nearest_feature(simplex)) ? " on" : " beyond");
  };
  REQUIRE(on({{1, 0, 0}, {0, 0, 0}}) == "A on");
  REQUIRE(on({{1, 0, 0}, {tiny, 0, 0}}) == "A beyond");
  REQUIRE(on({{1, 0, 0}, {-1, 0, 0}}) == "AB on");
  REQUIRE(on({{1, tiny, 0}, {-1, tiny, 0}}) == "AB beyond");
  REQUIRE(on({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}) == "ABC on");
  REQUIRE(on({{1, 0, tiny}, {-1, 1, tiny}, {-1, -1, tiny}}) == "ABC beyond");
  REQUIRE(on({{0, 0, 2}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}) == "ABC on");
  REQUIRE(on({{0, 0, 2}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}}) == "ABCD on");
}

}  // namespace nearest_feature_test
}  // namespace study
