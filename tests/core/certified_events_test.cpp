// What certified_collision() tells: the events of its first search, then the proofs and the second search, as they were.
#include <cmath>
#include <string>

#include "tests/core/certified_support.hpp"
#include "tests/core/oracle.hpp"

namespace gjk::test {
namespace {

using V = Vec3<double>;

/// One word or two for each event.
struct Brief {
  std::string operator()(const ProofTried<double>& e) const {
    return std::string(to_string(e.proof)) + " of " + std::to_string(e.numbers.size()) +
           (e.holds ? " holds" : " fails");
  }
  std::string operator()(const SignTaken<double>& e) const {
    return e.expression +
           (e.sign > 0   ? " > 0"
            : e.sign < 0 ? " < 0"
                         : " = 0") +
           (e.exact.empty() ? "" : ": " + e.exact);
  }
  std::string operator()(const FeatureKept<double>& e) const {
    return "kept " + e.kept + (e.contains_origin ? ", holds the origin" : "");
  }
  std::string operator()(const Certified<double>& e) const {
    return std::string(to_string(e.result.status)) + " by " + std::string(to_string(e.result.proof));
  }
  std::string operator()(const VertexAdded<double>& e) const { return std::to_string(e.simplex.size()) + " vertices"; }
  std::string operator()(const DirectionChosen<double>& e) const { return "d = " + e.expression; }
  std::string operator()(const SupportFound<double>&) const { return "looked"; }
  std::string operator()(const auto&) const { return "?"; }
};

/// Returns: a line for each event after those of the first search.
std::string brief(const std::vector<Event<double>>& events) {
  std::string lines;
  bool is_first_search = true;
  for (const Event<double>& event : events) {
    if (!is_first_search) lines += std::visit(Brief{}, event) + "\n";
    if (std::holds_alternative<Finished<double>>(event)) is_first_search = false;
  }
  return lines;
}

const Pair<double> touching =
    pair_of<double>({V(0, 0, 0), V(3, 1, 0), V(2, -2, 0)}, {V(1.5, 0.5, 0), V(3, 3, 0), V(0, 2.5, 0)});

}  // namespace

TEST_CASE("A proof that holds ends the search", "[certified]") {
  const Pair<double> apart = pair_of<double>({V(0, 0, 0)}, {V(4, 0, 0)});
  CHECK(brief(told(apart)) == "direction of 1 holds\nseparated by direction\n");
  const Pair<double> together =
      pair_of<double>({V(-1, -1, -1), V(9, 0, 0), V(0, 9, 0), V(0, 0, 9)}, {V(0.5, 0.5, 0.5)});
  CHECK(brief(told(together)) == "tetrahedron of 4 holds\nintersecting by tetrahedron\n");
}

TEST_CASE("Where a corner stands on an edge the signs in doubt are told with their fractions", "[certified]") {
  CHECK(brief(told(touching)) ==
        "tetrahedron of 0 fails\n"
        "1 vertices\nAO.x > 0\nkept A\nd = AO\nw·d > 0\n"
        "2 vertices\nAB·AO > 0\n(AB×AO).x = 0: 0\n(AB×AO).y = 0: 0\n(AB×AO).z < 0\nkept BA\nd = AB×AO×AB\nw·d > 0\n"
        "3 vertices\nAB·AO > 0\nABn·AO = 0: 0\n"
        "(AB×AO).x = 0: 0\n(AB×AO).y = 0: 0\n(AB×AO).z = 0: 0\nkept BA, holds the origin\n"
        "intersecting by second-search\n");
}

TEST_CASE("One double higher the same signs part, and none reaches across", "[certified]") {
  Pair<double> apart = touching;
  apart.b = PointSet<double>({V(1.5, above(0.5), 0), V(3, 3, 0), V(0, 2.5, 0)});
  const std::string lines = brief(told(apart));
  CHECK(lines.starts_with("direction of 1 fails\n1 vertices\n"));
  CHECK(lines.find("(AB×AO).z > 0: 3/9007199254740992\nkept BA\nd = AB×AO×AB\n") != std::string::npos);
  CHECK(lines.find("w·d < 0: -") != std::string::npos);
  CHECK(lines.find("looked\nmax w·d < 0: -") != std::string::npos);
  CHECK(lines.ends_with("separated by second-search\n"));
}

TEST_CASE("Numbers that no double could hold are told times a power of two", "[certified]") {
  std::vector<Vec3<double>> a, b;
  for (const Vec3<double>& p : touching.a.points()) a.push_back(0x1p-600 * p);
  for (const Vec3<double>& p : touching.b.points()) b.push_back(0x1p-600 * p);
  int squares = 0;
  for (const Event<double>& event : told(pair_of<double>(a, b)))
    if (const auto* sign = std::get_if<SignTaken<double>>(&event); sign && sign->expression == "AB·AO") {
      REQUIRE(sign->power.has_value());
      CHECK(std::ldexp(sign->value, 1200 - *sign->power) > 1);
      ++squares;
    }
  CHECK(squares > 0);
}

TEST_CASE("Who listens hears the answer that others get", "[certified]") {
  Dice dice(41);
  for (int i = 0; i < 2000; ++i) {
    const Points p = dice.points(dice.between(1, 5), 2), q = dice.points(dice.between(1, 5), 2);
    const Pair<double> both = pair_of<double>(p, q);
    REQUIRE(std::get<Certified<double>>(told(both).back()).result == proven(both));
  }
}

TEST_CASE("C4: each simplex that the second search keeps is nearer to the origin than the one before, up to the origin",
          "[certified]") {
  std::vector<Pair<double>> pairs{pair_of<double>(cycling_apart_a, cycling_apart_b),
                                  pair_of<double>(cycling_meeting_a, cycling_meeting_b)};
  Dice dice(43);
  for (int i = 0; i < 5000; ++i)
    pairs.push_back(pair_of<double>(dice.points(dice.between(1, 6), 3), dice.points(dice.between(1, 6), 3)));
  int kept = 0;
  for (const Pair<double>& pair : pairs) {
    std::optional<Rational> before;
    for (const Event<double>& event : told(pair)) {
      const auto* feature = std::get_if<FeatureKept<double>>(&event);
      if (!feature) continue;
      const Rational now = toward_origin(exact(places(feature->after))).squaredNorm();
      CHECK((now == 0) == feature->contains_origin);
      if (before) CHECK(now < *before);
      before = now;
      ++kept;
    }
  }
  CHECK(kept > 1000);
}

TEST_CASE("A vertex is new where neither search has found its place before", "[certified]") {
  int again = 0, news = 0;
  for (const Pair<double>& pair :
       {pair_of<double>(cycling_apart_a, cycling_apart_b), pair_of<double>(cycling_meeting_a, cycling_meeting_b)}) {
    std::vector<Vec3<double>> found;
    bool is_second = false;
    for (const Event<double>& event : told(pair)) {
      is_second |= std::holds_alternative<ProofTried<double>>(event);
      const auto* support = std::get_if<SupportFound<double>>(&event);
      if (!support) continue;
      const Vec3<double>& w = support->vertex.w;
      CHECK(support->is_new == (std::find(found.begin(), found.end(), w) == found.end()));
      (support->is_new ? news : again) += is_second;
      found.push_back(w);
    }
  }
  CHECK(again > 0);
  CHECK(news > 0);
}

TEST_CASE("Each value lies as near to its fraction as its error says", "[certified]") {
  Dice dice(42);
  int in_doubt = 0;
  for (int i = 0; i < 500; ++i) {
    const Points p = dice.points(dice.between(1, 5), 2), q = dice.points(dice.between(1, 5), 2);
    for (const Event<double>& event : told(pair_of<double>(p, q))) {
      const auto* sign = std::get_if<SignTaken<double>>(&event);
      if (!sign) continue;
      REQUIRE(sign->exact.empty() == (std::abs(sign->value) > sign->error || sign->error == 0));
      if (sign->exact.empty()) {
        REQUIRE(sign->sign == (sign->value > 0) - (sign->value < 0));
        continue;
      }
      ++in_doubt;
      const Rational exact(sign->exact);
      REQUIRE(exact.sign() == sign->sign);
      REQUIRE(abs(Rational(exact - Rational(sign->value))) <= Rational(sign->error));
    }
  }
  CHECK(in_doubt > 100);
}

}  // namespace gjk::test
