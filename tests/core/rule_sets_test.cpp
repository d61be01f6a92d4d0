/// Sets of rules by name, and what a variant of them hides.
#include "core/rule_sets.hpp"

#include <set>
#include <typeindex>

#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace rule_sets_test {

TEST_CASE("Each set of rules has its place, with each zero test, and none is left out", "[rule-sets]") {
  std::set<std::type_index> types;
  for (std::size_t i = 0; i < rule_sets.size(); ++i)
    for (std::size_t k = 0; k < zero_tests.size(); ++k) {
      REQUIRE(rule_sets[i].value == static_cast<RuleSet>(i));
      REQUIRE(zero_tests[k].value == static_cast<ZeroTestKind>(k));
      types.insert(with_rules(rule_sets[i].value, zero_tests[k].value,
                              []<class Rules>() { return std::type_index(typeid(Rules)); }));
    }
  REQUIRE(types.size() == 8);
  const auto nothing = []<class Rules>() {};
  const auto beyond_rules = static_cast<RuleSet>(rule_sets.size());
  const auto beyond_tests = static_cast<ZeroTestKind>(zero_tests.size());
  REQUIRE_THROWS_AS(with_rules(beyond_rules, ZeroTestKind::exact, nothing), std::invalid_argument);
  REQUIRE_THROWS_AS(with_rules(RuleSet::eager, beyond_tests, nothing), std::invalid_argument);
}

TEST_CASE("Algorithm 1 of a set of rules by its name is that of its type", "[rule-sets]") {
  for (const RuleSet rules : {RuleSet::as_intended, RuleSet::as_printed, RuleSet::eager, RuleSet::complete}) {
    CHECK((first_point(rules) == FirstPoint::tested) == (rules == RuleSet::eager));
    CHECK((not_crossed(rules) == NotCrossed::process_the_simplex) == (rules == RuleSet::as_printed));
  }
}

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

TEST_CASE("Tolerances are multiplied up from the factors of the formula, in the order of the formula", "[rule-sets]") {
  const auto sized = [](const Vec3<double>& v) {
    return detail::vector(v, RelativeZeroTest::size(v), detail::NoWords(NamedVector()));
  };
  const auto AB = sized({0.1, 0.2, 0.4}), AC = sized({0.7, -0.3, 0.1});
  const Vertex<double> A{{Vec3<double>(0.3, 0.1, 0)}, {Vec3<double>(0.1, 0, 0.9)}, {0.2, 0.1, -0.9}};
  const auto AO = detail::to_origin_from(A.w, RelativeZeroTest::size(A), detail::NoWords(NamedVector()));
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

}  // namespace rule_sets_test
}  // namespace gjk::test
