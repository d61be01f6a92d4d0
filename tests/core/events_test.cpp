/// What a run tells: complete, consistent, and without influence on the run.
#include "core/events.hpp"

#include "tests/core/replay.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace events_test {

using V = Vec3<double>;

/// Requires that the events are complete, fit together, and end with the result of a plain run. Returns: their kinds.
template <class S>
std::string require_replayable(const Run<S>& run, const Result<S>& plain) {
  REQUIRE((std::get<Finished<S>>(run.events.back()).result == run.result));
  REQUIRE((run.result == plain));
  std::string kinds;
  REQUIRE_NOTHROW(kinds = replayed(run.events));
  return kinds;
}
template <class S>
std::string require_replayable(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options = {}) {
  return require_replayable(observed(a, b, options), asked(a, b, options));
}

TEMPLATE_TEST_CASE("An observed run and a plain run give the same result bit for bit, and the trace replays the run",
                   "[events]", double, Rational) {
  using S = TestType;
  Dice dice(10);
  for (int i = 0; i < 500; ++i) {
    const PairOfHulls t = random_pair(dice);
    INFO("pair " << i);
    for (const CrossingTest test : {CrossingTest::on, CrossingTest::off}) {
      Options<S> options;
      options.crossing_test = test;
      options.first_direction = i % 3 ? Vec3<S>(S(1), S(0), S(0)) : vec<S>(dice.point(2));
      options.iteration_limit = i % 7 ? 20 : i % 4;
      require_replayable<S>(point_set<S>(t.a), point_set<S>(t.b), options);
    }
  }
}

TEST_CASE("Every exit is told: the trace ends with exactly one Finished, whatever the reason", "[events]") {
  const auto point = point_set<double>({{0, 0, 0}}), apart = point_set<double>({{2, 1, 0}, {2, -1, 0}});
  const auto around = point_set<double>({{-1, -1, -1}, {3, 0, 0}, {-1, 3, 0}, {0, 0, 3}});
  const auto end = [&](const auto& a, const Options<double>& options) {
    return std::pair(asked<double>(a, point, options).reason, require_replayable<double>(a, point, options));
  };
  Options<double> standard, off = without_crossing_test<double>(), none, zero;
  none.iteration_limit = 0;
  zero.first_direction = V(0, 0, 0);

  REQUIRE(end(apart, standard) == std::pair(Reason::origin_not_crossed, std::string("SVCARDVCF")));
  REQUIRE(end(apart, off).first == Reason::no_new_vertex);
  REQUIRE(end(apart, off).second.ends_with("VCF"));
  REQUIRE(end(around, standard).first == Reason::simplex_contains_origin);
  REQUIRE(end(around, standard).second.ends_with("RF"));
  REQUIRE(end(around, none) == std::pair(Reason::iteration_limit, std::string("SF")));
  REQUIRE(end(around, zero) == std::pair(Reason::unusable_direction, std::string("SF")));
  none.iteration_limit = 1;
  REQUIRE(end(around, none) == std::pair(Reason::iteration_limit, std::string("SVCARDF")));
}

TEST_CASE("Every event of an iteration comes in the order in which it happens", "[events]") {
  const auto around = point_set<double>({{-1, -1, -1}, {3, 0, 0}, {-1, 3, 0}, {0, 0, 3}});
  // One region for a vertex, three for a segment, seven for a triangle, twelve for a tetrahedron: nothing is left out.
  REQUIRE(require_replayable<double>(around, point_set<double>({{0, 0, 0}})) ==
          "SVCARDVCARRRDVCARRRRRRRDVCARRRRRRRRRRRRF");
}

TEST_CASE("Anything that takes an event observes, also a function that looks at one kind only", "[events]") {
  const auto a = point_set<double>({{2, 1, 0}, {-2, 1, 0}, {0, -3, 0}}), point = point_set<double>({{0, 0, 0}});
  int calls = 0;
  const auto count_supports = [&]<class E>(const E&) { calls += std::is_same_v<E, SupportFound<double>>; };
  const auto result = collision<double>(a, point, {}, count_supports);
  REQUIRE(calls == result.iterations);
  STATIC_REQUIRE(Observer<Trace<Rational>, Rational>);
  STATIC_REQUIRE(Observer<const NobodyListens, float>);
  STATIC_REQUIRE_FALSE(Observer<int, double>);
}

namespace {

/// Takes all kinds of events but one.
template <class Missed>
struct DeafTo {
  template <class E>
  requires(!std::same_as<E, Missed>) void operator()(const E&) const {}
};

/// Returns: how many kinds an observer, and one of certified searches, may be deaf to, one at a time.
template <class... Events>
std::pair<int, int> kinds_that_may_be_missed(std::type_identity<std::variant<Events...>>) {
  return {(0 + ... + Observer<DeafTo<Events>, double>), (0 + ... + CertifiedObserver<DeafTo<Events>, double>)};
}

}  // namespace

TEST_CASE("An observer takes every kind of event, those of certified searches where it listens to one", "[events]") {
  const auto [of_gjk, of_certified] = kinds_that_may_be_missed(std::type_identity<Event<double>>{});
  CHECK(of_gjk == 4);  // those of proofs, signs, features kept and what is certified
  CHECK(of_certified == 0);
}

}  // namespace events_test
}  // namespace gjk::test
