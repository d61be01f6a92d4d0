// What certified_collision() tells: the events of its first search, then the proofs and the second search, as they were.
#include <cmath>
#include <string>

#include "tests/core/certified_support.hpp"
#include "tests/core/oracle.hpp"

namespace gjk::test {
namespace certified_events_test {
namespace {

using V = Vec3<double>;

const Pair<double> touching =
    pair_of<double>({V(0, 0, 0), V(3, 1, 0), V(2, -2, 0)}, {V(1.5, 0.5, 0), V(3, 3, 0), V(0, 2.5, 0)});

}  // namespace

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
      is_second |= std::holds_alternative<FilterTried<double>>(event);
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

}  // namespace certified_events_test
}  // namespace gjk::test
