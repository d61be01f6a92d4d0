/// Algorithm 1 as it is printed goes on to process the simplex after it has found that the origin was not crossed, and may
/// then overwrite its answer. How often, and at which event does it part from what the text means?
#include "tests/core/evidence.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

using V = Vec3<double>;

template <class Rules, class S, class A, class B>
Run<S> observed_by(const A& a, const B& b, const Options<S>& options = {}) {
  Trace<S> trace;
  const Result<S> result = collision<S, Rules>(Watched<S, A>(a), Watched<S, B>(b), options, trace);
  return {result, std::move(trace.events)};
}

/// Returns: whether the events say the same, as far as this test needs to know.
bool same_event(const Event<double>& e, const Event<double>& f) {
  if (e.index() != f.index()) return false;
  const auto iteration = [](const Event<double>& event) {
    return std::visit([](const auto& one) { return one.iteration; }, event);
  };
  if (iteration(e) != iteration(f)) return false;
  if (const auto* found = std::get_if<SupportFound<double>>(&e)) {
    const auto& other = std::get<SupportFound<double>>(f);
    return found->direction == other.direction && same_vertex(found->vertex, other.vertex);
  }
  if (const auto* tested = std::get_if<CrossingTested<double>>(&e)) {
    const auto& other = std::get<CrossingTested<double>>(f);
    return tested->value == other.value && tested->verdict == other.verdict;
  }
  if (const auto* added = std::get_if<VertexAdded<double>>(&e))
    return same_simplex(added->simplex, std::get<VertexAdded<double>>(f).simplex);
  if (const auto* chosen = std::get_if<DirectionChosen<double>>(&e))
    return chosen->direction == std::get<DirectionChosen<double>>(f).direction;
  return true;
}

/// Returns: the position of the first event in which two runs differ.
std::size_t first_difference(const Run<double>& one, const Run<double>& other) {
  std::size_t i = 0;
  while (i < one.events.size() && i < other.events.size() && same_event(one.events[i], other.events[i])) ++i;
  return i;
}

const Sphere<double> ball(V(0, 0, 0), 1), ball_ten_away(V(10, 0, 0), 1);

TEST_CASE("Two unit spheres ten apart: separated by the text, in collision as Algorithm 1 is printed", "[as-printed]") {
  const auto intended = observed_by<AsIntended>(ball, ball_ten_away, Options<double>{});
  REQUIRE(intended.result.status == Status::separated);
  REQUIRE(intended.result.reason == Reason::origin_not_crossed);
  const auto printed = observed_by<AsPrinted>(ball, ball_ten_away, Options<double>{});
  REQUIRE(printed.result.status == Status::intersecting);
  REQUIRE(printed.result.reason == Reason::simplex_contains_origin);
  REQUIRE_FALSE(printed.result.separation.has_value());
  REQUIRE(printed.result.iterations == intended.result.iterations);
}

TEST_CASE("The two readings part right after the crossing test: one is finished, the other adds the vertex",
          "[as-printed]") {
  const auto intended = observed_by<AsIntended>(ball, ball_ten_away, Options<double>{});
  const auto printed = observed_by<AsPrinted>(ball, ball_ten_away, Options<double>{});
  const std::size_t at = first_difference(intended, printed);
  REQUIRE(at > 0);
  const auto& last_common = std::get<CrossingTested<double>>(intended.events[at - 1]);
  REQUIRE(last_common.verdict == Crossing::not_crossed);
  REQUIRE(std::holds_alternative<Finished<double>>(intended.events[at]));
  REQUIRE(intended.events.size() == at + 1);
  const auto& added = std::get<VertexAdded<double>>(printed.events[at]);
  REQUIRE(added.iteration == 2);
  REQUIRE(added.simplex.point(Role::A) == added.simplex.point(Role::B));  // the same vertex came back
  const auto& region = std::get<RegionTested<double>>(printed.events.at(printed.events.size() - 2));
  REQUIRE(region.expression == "AB×AO×AB");
  REQUIRE(region.relation == Relation::zero);
}

TEST_CASE("As printed, a search that keeps its answer proves it as the other does, and ends with the next simplex",
          "[as-printed]") {
  Dice dice(33);
  int reduced_at_the_end = 0;
  for (int i = 0; i < 300; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto a = point_set<double>(t.a), b = point_set<double>(t.b);
    const auto intended = observed_by<AsIntended>(a, b, Options<double>{});
    const auto printed = observed_by<AsPrinted>(a, b, Options<double>{});
    if (printed.result.status != Status::separated) continue;
    INFO("pair " << i);
    REQUIRE(printed.result.reason == Reason::origin_not_crossed);
    REQUIRE(printed.result.separation->direction == intended.result.separation->direction);
    REQUIRE(printed.result.separation->support_value == intended.result.separation->support_value);
    const auto reductions = events_of_kind<SimplexReduced<double>>(printed.events);
    if (reductions.empty() || reductions.back().iteration != printed.result.iterations) continue;
    ++reduced_at_the_end;
    REQUIRE(same_simplex(printed.result.simplex, reductions.back().after));
  }
  REQUIRE(reduced_at_the_end > 10);
}

TEST_CASE("Without the crossing test the two readings are the same", "[as-printed]") {
  Dice dice(31);
  for (int i = 0; i < 500; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto a = point_set<double>(t.a), b = point_set<double>(t.b);
    REQUIRE(same_result(collision<double, AsPrinted>(a, b, without_crossing_test<double>()),
                        collision<double, AsIntended>(a, b, without_crossing_test<double>())));
  }
}

/// Answers of both readings on random pairs of triangles, coordinates uniform in a cube.
struct Readings {
  int apart = 0;              ///< pairs that have no point in common
  int printed_says_meet = 0;  ///< of these
  int together = 0;
  int undecided = 0;  ///< by the text; left out of the others
};

TEST_CASE(
    "As printed, two to four of a hundred random triangle pairs apart are reported as collisions, and by the "
    "text none",
    "[as-printed][unsanitized]") {
  const std::uint64_t seed = 32;
  INFO("seed " << seed);
  Dice dice(seed);
  Readings count;
  for (int i = 0; i < 20000; ++i) {
    // Products of four differences of numbers below 1000 stay far below 2^53: double computes exactly.
    const Points t = dice.points(3, 500), u = dice.points(3, 500);
    const auto a = point_set<double>(t), b = point_set<double>(u);
    const auto intended = collision<double>(a, b);
    const auto printed = collision<double, AsPrinted>(a, b);
    INFO("pair " << i);
    if (intended.status == Status::undecided) {
      ++count.undecided;
      continue;
    }
    require_evidence(intended, t, u);  // so that no pair apart is ever called a collision, nor the reverse
    if (intended.status == Status::intersecting) {
      ++count.together;
      REQUIRE(same_result(printed, intended));
    } else {
      ++count.apart;
      count.printed_says_meet += printed.status == Status::intersecting;
    }
  }
  const double share = static_cast<double>(count.printed_says_meet) / count.apart;
  INFO(count.printed_says_meet << " of " << count.apart << " pairs apart, " << count.together << " pairs together");
  REQUIRE(count.undecided <= 2);
  REQUIRE(count.together > 2000);
  REQUIRE(share > 0.02);
  REQUIRE(share < 0.04);
}

}  // namespace
}  // namespace gjk::test
