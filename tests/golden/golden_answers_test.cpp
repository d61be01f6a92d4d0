// What gjkstep query answers about pairs that nobody chose, to the last bit: answers.jsonl.

#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/kit/json.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/query/query.hpp"

namespace golden_answers_test {

using kit::Dice, kit::Json;
using namespace walkthroughs::program;

namespace {

// No two dice are thrown where a compiler may choose which is first.

/// Of a lattice on which much coincides, and of tenths, which no binary number is.
Json coordinate(Dice& dice, bool tenths) {
  const int number = dice.between(-3, 3);
  return tenths ? Json(number / 10.0) : Json(number);
}

Json point(Dice& dice, bool tenths) {
  Json list = Json::array();
  for (int i = 0; i < 3; ++i) list.push_back(coordinate(dice, tenths));
  return list;
}

Json points(Dice& dice, bool tenths) {
  Json list = Json::array();
  for (int left = dice.between(1, 5); left > 0; --left) list.push_back(point(dice, tenths));
  return {{"points", list}};
}

Json round_shape(Dice& dice, int sums) {
  const Json center = point(dice, dice.coin());
  const double radius = dice.between(1, 8) / 4.0, height = dice.between(1, 8) / 4.0;
  switch (dice.between(0, sums > 0 ? 3 : 2)) {
    case 0: return {{"sphere", {{"center", center}, {"radius", radius}}}};
    case 1: {
      Json axis = point(dice, false);
      axis[2] = 1;
      return {{"cylinder", {{"center", center}, {"axis", axis}, {"radius", radius}, {"height", height}}}};
    }
    case 2: return points(dice, false);
    default: {
      const Json one = round_shape(dice, sums - 1), other = round_shape(dice, sums - 1);
      return {{"sum", {one, other}}};
    }
  }
}

/// Without sines: turned by quarters.
Json posed(Json object, Dice& dice) {
  if (dice.coin()) return object;
  object["pose"]["translation"] = point(dice, true);
  Json axis = Json{0, 0, 0};
  axis[static_cast<std::size_t>(dice.between(0, 2))] = 1;
  object["pose"]["rotation"] = {{"degrees", 90 * dice.between(0, 3)}, {"axis", axis}};
  return object;
}

// -- How they are asked -----------------------------------------------------------------------------------------------

struct Way {
  QueryOptions options;
  std::string words;  ///< as on the command line

  void add(const std::string& option, std::string_view value = "") {
    words += (words.empty() ? "" : " ") + ("--" + option) + (value.empty() ? "" : " ") + std::string(value);
  }
};

Way way(Dice& dice, QueryScalar scalar, QueryEvidence evidence, int rules, int zero_test) {
  Way way{{.scalar = scalar,
           .rules = static_cast<RuleSet>(rules),
           .zero_test = static_cast<ZeroTest>(zero_test),
           .evidence = evidence},
          ""};
  way.add("scalar", query_scalars[static_cast<std::size_t>(scalar)]);
  way.add("rules", words_of::rules[static_cast<std::size_t>(rules)]);
  way.add("zero-test", words_of::zero_test[static_cast<std::size_t>(zero_test)]);
  if (evidence != QueryEvidence::of_the_search) way.add("certified");
  if (evidence == QueryEvidence::fractions) way.add("fractions");
  if (const int start = dice.between(0, 3); start < 2)
    way.options.start = static_cast<QueryStart>(start), way.add("start", query_starts[static_cast<std::size_t>(start)]);
  else if (start == 2)
    way.options.first_direction = Point(1, -2, 3), way.add("first-direction", "1,-2,3");
  if (dice.between(0, 4) == 0) way.options.iteration_limit = 3, way.add("max-iterations", "3");
  return way;
}

std::string line_of(const Way& way, const Json& a, const Json& b) {
  const std::string pair = Json{{"a", a}, {"b", b}}.dump();
  std::string answer;
  answer_line(pair, 1, way.options, answer);
  return R"({"options":")" + way.words + R"(","pair":)" + pair + R"(,"answer":)" + answer.substr(0, answer.size() - 1) +
         "}\n";
}

}  // namespace

TEST_CASE("answers about pairs at random are the accepted ones") {
  Dice dice(43);
  std::string now;
  for (int kind = 0; kind < 5; ++kind)
    for (int rules = 0; rules < 4; ++rules)
      for (int i = 0; i < 3; ++i) {
        const QueryScalar scalar = std::array{QueryScalar::binary64, QueryScalar::binary32, QueryScalar::exact,
                                              QueryScalar::binary64, QueryScalar::binary32}[kind];
        const QueryEvidence evidence =
            std::array{QueryEvidence::of_the_search, QueryEvidence::of_the_search, QueryEvidence::of_the_search,
                       QueryEvidence::certificate, QueryEvidence::fractions}[kind];
        const Way asked = way(dice, scalar, evidence, rules, (rules + i) % 2);
        const bool tenths = i == 2;
        const Json a = points(dice, tenths), b = points(dice, tenths);
        now += line_of(asked, a, b);
      }
  for (int i = 0; i < 40; ++i) {
    const Way asked = way(dice, i % 2 == 0 ? QueryScalar::binary64 : QueryScalar::binary32,
                          i % 4 < 2 ? QueryEvidence::of_the_search : QueryEvidence::certificate, i % 4, i / 4 % 2);
    const Json a = posed(round_shape(dice, 2), dice), b = posed(round_shape(dice, 1), dice);
    now += line_of(asked, a, b);
  }
  golden::check_text("answers.jsonl", now, "answers");
}

}  // namespace golden_answers_test
