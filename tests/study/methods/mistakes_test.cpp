#include "tests/study/methods/mistakes.hpp"

#include <set>

#include "tests/catch.hpp"
#include "tests/study/claims/claims_measured.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/pairs/random_triangles.hpp"
#include "tests/study/methods/wrong_rules.hpp"

namespace study {
namespace {

using V = gjk::Vec3<double>;

/// The directions of a run, in their order.
struct Directions {
  std::vector<V> all;
  template <class E>
  void operator()(const E& event) {
    if constexpr (std::is_same_v<E, gjk::SupportFound<double>>) all.push_back(event.direction);
  }
};

template <class AllRules>
std::pair<gjk::Status, std::vector<V>> way_of(const Pair& pair) {
  Directions directions;
  const gjk::PointSet<double> a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
  const auto result = gjk::collision<double, AllRules>(a, b, gjk::Options<double>{}, directions);
  return {result.status, directions.all};
}

TEST_CASE("The short form of the rules without a mistake goes the way of the real ones", "[mistakes]") {
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Dice dice(5, "mistakes", i);
    INFO("pair " << i);
    const Pair touching = coarse_triangles(dice, 4, 1);
    REQUIRE(way_of<Rules<Faithful>>(touching) == way_of<gjk::AsIntended>(touching));
    const Pair solid = family_named("tetrahedra").make(5, i);
    REQUIRE(way_of<Rules<Faithful>>(solid) == way_of<gjk::AsIntended>(solid));
  }
}

TEST_CASE("Every mistake changes some runs, and all have names of their own", "[mistakes]") {
  const ClaimsOptions options{.pairs = 3000, .seed = 1, .threads = 2};
  MistakeTable all = measure_mistakes(TestPairs::grid_triangles, options);
  all += measure_mistakes(TestPairs::tetrahedra, options);
  std::set<std::string> names;
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    INFO(mistakes()[i].name);
    REQUIRE(all.counts[i].changed.count > 0);
    REQUIRE(names.insert(mistakes()[i].name).second);
  }
}

TEST_CASE("A mistake that is asked about a pair by hand: the zero direction, the first point, the wrong side",
          "[mistakes]") {
  const auto ask = [](const std::string& part, const Points& a, const Points& b) {
    for (const Mistake& mistake : mistakes())
      if (mistake.name.find(part) != std::string::npos)
        return mistake.ask(gjk::PointSet<double>(a), gjk::PointSet<double>(b)).status;
    throw std::invalid_argument("no mistake is called " + part);
  };
  const Points origin{{0, 0, 0}};
  using gjk::Status;
  REQUIRE(ask("first vertex", origin, origin) == Status::undecided);
  REQUIRE(ask("the segment is not", {{1, 0, 0}, {-1, 0, 0}}, origin) == Status::undecided);
  REQUIRE(ask("first point", {{-1, 0, 0}, {-2, 0, 0}}, origin) == Status::separated);
  REQUIRE(ask("first point", {{1, 0, 0}, {-2, 0, 0}}, origin) == Status::intersecting);
  REQUIRE(ask("<=", {{1, 0, 0}, {0, 0, 0}}, origin) == Status::separated);
  REQUIRE(ask("as printed", {{5, 0, 0}}, origin) == Status::intersecting);
  REQUIRE(ask("support(B, d)", {{3, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {2.5, 0, 0}}) == Status::separated);
}

}  // namespace
}  // namespace study
