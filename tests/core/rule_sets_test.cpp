/// Sets of rules by name, and what a variant of them hides.
#include "core/rule_sets.hpp"

#include <algorithm>
#include <set>

#include "tests/core/evidence.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

template <class Rules>
std::string name_of_type() {
  if constexpr (std::same_as<Rules, Intended<>>) return "as-intended exact";
  if constexpr (std::same_as<Rules, Printed<>>) return "as-printed exact";
  if constexpr (std::same_as<Rules, Eager<>>) return "eager exact";
  if constexpr (std::same_as<Rules, Complete<>>) return "complete exact";
  if constexpr (std::same_as<Rules, Complete<RelativeZeroTest>>) return "complete relative";
  if constexpr (std::same_as<Rules, Intended<RelativeZeroTest>>) return "as-intended relative";
  if constexpr (std::same_as<Rules, Printed<RelativeZeroTest>>) return "as-printed relative";
  if constexpr (std::same_as<Rules, Eager<RelativeZeroTest>>) return "eager relative";
  return "";
}

TEST_CASE("Each set of rules is called by its name with each zero test, and none is left out", "[rule-sets]") {
  std::set<std::string> called;
  for (std::size_t i = 0; i < rule_sets.size(); ++i)
    for (std::size_t k = 0; k < zero_tests.size(); ++k) {
      REQUIRE(rule_sets[i].value == static_cast<RuleSet>(i));
      REQUIRE(zero_tests[k].value == static_cast<ZeroTestKind>(k));
      const std::string name =
          with_rules(rule_sets[i].value, zero_tests[k].value, []<class Rules>() { return name_of_type<Rules>(); });
      REQUIRE(name == std::string(rule_sets[i].name) + " " + std::string(zero_tests[k].name));
      REQUIRE(name == std::string(to_string(rule_sets[i].value)) + " " + std::string(to_string(zero_tests[k].value)));
      REQUIRE_FALSE(rule_sets[i].meaning.empty());
      called.insert(name);
    }
  REQUIRE(called.size() == 8);
  const auto nothing = []<class Rules>() {};
  const auto beyond_rules = static_cast<RuleSet>(rule_sets.size());
  const auto beyond_tests = static_cast<ZeroTestKind>(zero_tests.size());
  REQUIRE_THROWS_AS(with_rules(beyond_rules, ZeroTestKind::exact, nothing), std::invalid_argument);
  REQUIRE_THROWS_AS(with_rules(RuleSet::eager, beyond_tests, nothing), std::invalid_argument);
}

TEST_CASE("Algorithm 1 of a set of rules by its name is that of its type", "[rule-sets]") {
  REQUIRE(first_point(RuleSet::as_intended) == FirstPoint::taken_as_it_is);
  REQUIRE(first_point(RuleSet::as_printed) == FirstPoint::taken_as_it_is);
  REQUIRE(first_point(RuleSet::eager) == FirstPoint::tested);
  REQUIRE(first_point(RuleSet::complete) == FirstPoint::taken_as_it_is);
  REQUIRE(not_crossed(RuleSet::complete) == NotCrossed::answer_at_once);
  REQUIRE(not_crossed(RuleSet::as_intended) == NotCrossed::answer_at_once);
  REQUIRE(not_crossed(RuleSet::as_printed) == NotCrossed::process_the_simplex);
  REQUIRE(not_crossed(RuleSet::eager) == NotCrossed::answer_at_once);
}

TEST_CASE("From the same first direction eager rules answer as those intended do, and never later", "[rule-sets]") {
  Dice dice(53);
  int sooner = 0;
  for (int i = 0; i < 2000; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto a = point_set<double>(t.a), b = point_set<double>(t.b);
    const auto intended = asked<double>(a, b), eager = asked<double, Eager<>>(a, b);
    INFO("pair " << i);
    REQUIRE(eager.iterations <= intended.iterations);
    if (intended.status != Status::undecided && eager.status != Status::undecided)
      REQUIRE(eager.status == intended.status);
    sooner += eager.iterations < intended.iterations ? 1 : 0;
  }
  REQUIRE(sooner > 100);
}

// -- As printed -------------------------------------------------------------------------------------------------------

// Algorithm 1 as it is printed goes on to process the simplex after it has found that the origin was not crossed, and may then
// overwrite its answer. How often, and at which event does it part from what the text means?

TEST_CASE(
    "Two unit spheres ten apart: separated by the text, in collision as Algorithm 1 is printed, which goes on after "
    "the crossing test",
    "[as-printed]") {
  const Sphere<double> ball(Vec3<double>(0, 0, 0), 1), ball_ten_away(Vec3<double>(10, 0, 0), 1);
  const auto intended = observed<double>(ball, ball_ten_away),
             printed = observed<double, AsPrinted>(ball, ball_ten_away);
  REQUIRE(intended.result.status == Status::separated);
  REQUIRE(intended.result.reason == Reason::origin_not_crossed);
  REQUIRE(printed.result.status == Status::intersecting);
  REQUIRE(printed.result.reason == Reason::simplex_contains_origin);
  REQUIRE_FALSE(printed.result.separation.has_value());
  REQUIRE(printed.result.iterations == intended.result.iterations);

  const auto [end, added] = std::ranges::mismatch(intended.events, printed.events);
  REQUIRE(std::get<CrossingTested<double>>(end[-1]).verdict == Crossing::not_crossed);
  REQUIRE(std::holds_alternative<Finished<double>>(*end));
  const auto& simplex = std::get<VertexAdded<double>>(*added).simplex;
  REQUIRE(simplex.point(Role::A) == simplex.point(Role::B));  // the same vertex came back
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
    const auto intended = observed<double>(a, b);
    const auto printed = observed<double, AsPrinted>(a, b);
    if (printed.result.status != Status::separated) continue;
    INFO("pair " << i);
    REQUIRE(printed.result.reason == Reason::origin_not_crossed);
    REQUIRE(printed.result.separation->direction == intended.result.separation->direction);
    REQUIRE(printed.result.separation->support_value == intended.result.separation->support_value);
    const auto reductions = events_of_kind<SimplexReduced<double>>(printed.events);
    if (reductions.empty() || reductions.back().iteration != printed.result.iterations) continue;
    ++reduced_at_the_end;
    REQUIRE(printed.result.simplex == reductions.back().after);
  }
  REQUIRE(reduced_at_the_end > 10);
}

TEST_CASE("Without the crossing test the two readings are the same", "[as-printed]") {
  Dice dice(31);
  for (int i = 0; i < 500; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto a = point_set<double>(t.a), b = point_set<double>(t.b);
    const auto options = without_crossing_test<double>();
    REQUIRE((asked<double, AsPrinted>(a, b, options) == asked<double>(a, b, options)));
  }
}

TEST_CASE(
    "As printed, two to four of a hundred random triangle pairs apart are reported as collisions, and by the text none",
    "[as-printed][unsanitized]") {
  Dice dice(32);
  int apart = 0, printed_says_meet = 0, together = 0, undecided = 0;
  for (int i = 0; i < 20000; ++i) {
    // Products of four differences of numbers below 1000 stay far below 2^53: double computes exactly.
    const Points t = dice.points(3, 500), u = dice.points(3, 500);
    const auto a = point_set<double>(t), b = point_set<double>(u);
    const auto intended = asked<double>(a, b), printed = asked<double, AsPrinted>(a, b);
    INFO("pair " << i);
    undecided += intended.status == Status::undecided;
    if (intended.status == Status::undecided) continue;
    require_evidence(intended, t, u);  // so that no pair apart is ever called a collision, nor the reverse
    if (intended.status == Status::intersecting) {
      ++together;
      REQUIRE((printed == intended));
    } else {
      ++apart;
      printed_says_meet += printed.status == Status::intersecting;
    }
  }
  CAPTURE(apart, printed_says_meet, together, undecided);
  REQUIRE(undecided <= 2);
  REQUIRE(together > 2000);
  REQUIRE(printed_says_meet > 0.02 * apart);
  REQUIRE(printed_says_meet < 0.04 * apart);
}

// -- Variants ---------------------------------------------------------------------------------------------------------

/// Each hides one detail, and does what the hidden one does.
struct Counting : AsIntended {
  static inline int at_origin, segment, edge, face, side, ABCn_of_triangle_, ACDn_, AQn_, APn_, below, above, Eq_8,
      Eq_9, kept_edge, processed_face;

  static bool is_at_origin(const auto& AO) { return ++at_origin, AsIntended::is_at_origin(AO); }
  static auto from_segment(const auto& AB, const auto& AO) { return ++segment, AsIntended::from_segment(AB, AO); }
  static auto from_edge(const auto& AX, const auto& AO, const auto& AXn) {
    return ++edge, AsIntended::from_edge(AX, AO, AXn);
  }
  static bool is_above_face(const auto& value) { return ++face, AsIntended::is_above_face(value); }
  static Side side_of_triangle(const auto& value) { return ++side, AsIntended::side_of_triangle(value); }
  static auto ABCn_of_triangle(const auto& AB, const auto& AC) {
    return ++ABCn_of_triangle_, AsIntended::ABCn_of_triangle(AB, AC);
  }
  static auto ACDn(const auto& AC, const auto& AD) { return ++ACDn_, AsIntended::ACDn(AC, AD); }
  static auto AQn(Face f, const auto& AQ, const auto& APQn, const auto& earlier) {
    return ++AQn_, AsIntended::AQn(f, AQ, APQn, earlier);
  }
  static auto APn(Face f, const auto& AP, const auto& APQn, const auto& earlier) {
    return ++APn_, AsIntended::APn(f, AP, APQn, earlier);
  }
  static Kept kept_below_triangle() { return ++below, AsIntended::kept_below_triangle(); }
  static Kept kept_above(Face f) { return ++above, AsIntended::kept_above(f); }
  template <class S, class A, class B>
  static auto difference(const A& a, const B& b) {
    return ++Eq_8, AsIntended::difference<S>(a, b);
  }
  static bool crossed(const auto& w_d) { return ++Eq_9, AsIntended::crossed(w_d); }
  static auto keep_edge(auto step, Role X, const auto& AX, const auto& AXn) {
    return ++kept_edge, AsIntended::keep_edge(step, X, AX, AXn);
  }
  static auto process_face(auto step, Face f, const auto&... vectors) {
    return ++processed_face, AsIntended::process_face(step, f, vectors...);
  }
};

TEST_CASE("A detail that a variant hides is asked of the variant, wherever it is used", "[rule-sets]") {
  Dice dice(52);
  for (int i = 0; i < 500; ++i) {
    const PairOfHulls t = random_pair(dice);
    const auto points_a = point_set<double>(t.a), points_b = point_set<double>(t.b);
    const AnyShape<double> a(points_a), b(points_b);
    REQUIRE((collision<double, Counting>(a, b) == asked<double>(a, b)));
  }
  for (const int times :
       {Counting::at_origin, Counting::segment, Counting::edge, Counting::face, Counting::side,
        Counting::ABCn_of_triangle_, Counting::ACDn_, Counting::AQn_, Counting::APn_, Counting::below, Counting::above,
        Counting::Eq_8, Counting::Eq_9, Counting::kept_edge, Counting::processed_face})
    REQUIRE(times > 0);
}

struct ADBnInward : AsIntended {
  static auto ADBn(const auto& AD, const auto& AB) { return AB.cross(AD); }
};

TEST_CASE("A variant that hides a detail changes that and nothing else", "[rule-sets]") {
  const auto regions_of = []<class Rules>(Rules) {
    // Of the tetrahedron of rules_test.cpp, the origin inside.
    Simplex<double> simplex;
    for (const Point& p : {Point{6, 6, -2}, Point{0, -6, -2}, Point{-6, 0, -2}, Point{0, 0, 6}})
      simplex.add({vec<double>(p), vec<double>({0, 0, 0}), vec<double>(p)});
    Trace<double> trace;
    process<Rules>(simplex, CrossingTest::on, trace);
    return events_of_kind<RegionTested<double>>(trace.events);
  };
  const auto right = regions_of(AsIntended{}), wrong = regions_of(ADBnInward{});
  for (std::size_t i = 0; i < 10; ++i) {  // eight are skipped, ABC and ACD do not see the origin
    REQUIRE(right.at(i).formula == wrong.at(i).formula);
    REQUIRE(right.at(i).normal == wrong.at(i).normal);
  }
  REQUIRE(right.at(10).formula == "AD×AB");
  REQUIRE(wrong.at(10).formula == "AB×AD");
  REQUIRE(*right.at(10).normal == -*wrong.at(10).normal);
  REQUIRE(right.at(10).verdict == Verdict::rejected);
  REQUIRE(wrong.at(10).verdict == Verdict::chosen);
  REQUIRE(right.at(11).feature == "ABCD");
  REQUIRE(wrong.at(11).feature == "AB");
  REQUIRE(wrong.at(11).formula == "ADBn×AB");
}

TEST_CASE("Tolerances are multiplied up from the factors of the formula, in the order of the formula", "[rule-sets]") {
  const auto sized = [](const Vec3<double>& v) {
    return detail::vector(v, RelativeZeroTest::size(v), detail::NoWords(""));
  };
  const auto AB = sized({0.1, 0.2, 0.4}), AC = sized({0.7, -0.3, 0.1});
  const Vertex<double> A{{Vec3<double>(0.3, 0.1, 0)}, {Vec3<double>(0.1, 0, 0.9)}, {0.2, 0.1, -0.9}};
  const auto AO = detail::to_origin_from(A.w, RelativeZeroTest::size(A), detail::NoWords(""));
  const auto lengths = [](const auto& v) { return std::vector<double>(v.size.lengths.begin(), v.size.lengths.end()); };
  const double b = lengths(AB).at(0), c = lengths(AC).at(0);
  REQUIRE(b != c);
  const auto ABCn = AB.cross(AC);
  REQUIRE(lengths(ABCn) == std::vector{b, c});
  REQUIRE(lengths(AB.cross(ABCn)) == std::vector{b, b, c});
  REQUIRE(lengths(ABCn.cross(AC)) == std::vector{c, c, b});
  const double o = lengths(AO).at(0);
  REQUIRE(lengths(AB.cross(ABCn).dot(AO)) == std::vector{o, b, b, c});
  REQUIRE(lengths(detail::triple(AB, AO)) == std::vector{o, b, b});
}

}  // namespace
}  // namespace gjk::test
