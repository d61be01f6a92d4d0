// gjkstep query --certified: answers that are true, with certificates that others can check.

#include <map>
#include <nlohmann/json.hpp>

#include "tests/core/support.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/query/certificates.hpp"
#include "tests/walkthroughs/query/queries.hpp"
#include "walkthroughs/query/query.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::test::Dice;
using Json = nlohmann::ordered_json;

namespace {

constexpr QueryScalar floating_scalars[] = {QueryScalar::binary32, QueryScalar::binary64};

QueryOptions certified(QueryScalar scalar = QueryScalar::binary64) {
  return {.scalar = scalar, .evidence = QueryEvidence::certificate};
}
QueryOptions in_fractions(QueryOptions options = certified()) {
  options.evidence = QueryEvidence::fractions;
  return options;
}

std::string answer_text(const std::string& line, const QueryOptions& options = certified()) {
  std::string out;
  answer_line(line, 7, options, out);
  REQUIRE(lines(out).size() == 1);
  return lines(out)[0];
}

std::string points(const std::string& list) { return "{\"points\":[" + list + "]}"; }

template <class S>
void check_proven_in(const std::string& line, QueryOptions options) {
  const auto pair = nlohmann::json::parse(line);
  const auto a = set_in<S>(pair["a"]), b = set_in<S>(pair["b"]);
  options.evidence = QueryEvidence::certificate;
  const Json said = Json::parse(answer_text(line, options));
  INFO(said);
  CHECK(is_proven<S>(said, a, b));
  Json exact = Json::parse(answer_text(line, in_fractions(options)));
  INFO(exact);
  CHECK(is_proven<S>(exact, a, b));
  CHECK(exact["certificate"].begin().key() == said["certificate"].begin().key());
  exact["certificate"].erase("weights");
  exact["certificate"].erase("point");
  if (said["certificate"].contains("nearest")) exact["certificate"].erase("direction");
  if (!said["certificate"].contains("direction")) CHECK(exact == said);
}

void check_proven(const std::string& line, const QueryOptions& options = certified()) {
  INFO(line);
  if (options.scalar == QueryScalar::binary32)
    check_proven_in<float>(line, options);
  else
    check_proven_in<double>(line, options);
}

}  // namespace

// -- What is written --------------------------------------------------------------------------------------------------

TEST_CASE("Each kind of certificate is written as the help says, and with the exact numbers that were asked for") {
  struct Expected {
    std::string a, b, head, certificate, exact;
  };
  for (const auto& [a, b, head, certificate, exact] : std::vector<Expected>{
           {"[0,0,0],[1,0.5,0]", "[3,0,0]",
            R"("status":"separated","iterations":2,"second_iterations":0,"proof":"direction")",
            R"("direction":[2,-0.5,-0.0])", R"("direction":["2","-1/2","0"])"},
           {"[1,1,1],[1,-1,-1],[-1,1,-1],[-1,-1,1]", "[0.25,0,0]",
            R"("status":"intersecting","iterations":4,"second_iterations":0,"proof":"tetrahedron")",
            R"("simplex":[[0,0],[1,0],[2,0],[3,0]])",
            R"("simplex":[[0,0],[1,0],[2,0],[3,0]],"weights":["5/16","5/16","3/16","3/16"],"point":["1/4","0","0"])"},
           {"[0,0.4],[0.1,0.5],[0.5,0.5]", "[0.9,0.1],[0.1,0.9]",
            R"("status":"separated","iterations":3,"second_iterations":3,"proof":"second-search")",
            R"("nearest":[[2,1],[2,0]])",
            R"("nearest":[[2,1],[2,0]],"direction":["1/72057594037927936","1/72057594037927936","0"])"},
           {"[1,2,3]", "[1,2,3]",
            R"("status":"intersecting","iterations":1,"second_iterations":1,"proof":"second-search")",
            R"("simplex":[[0,0]])", R"("simplex":[[0,0]],"weights":["1"],"point":["1","2","3"])"},
           {"[0,0,0],[3,0,0]", "[1,0,0]",
            R"("status":"intersecting","iterations":2,"second_iterations":2,"proof":"second-search")",
            R"("simplex":[[1,0],[0,0]])",
            R"("simplex":[[1,0],[0,0]],"weights":["1/3","2/3"],"point":["1","0","0"])"}}) {
    const std::string line = pair_of(points(a), points(b));
    INFO(line);
    CHECK(answer_text(line) == "{" + head + ",\"certificate\":{" + certificate + "}}");
    CHECK(answer_text(line, in_fractions()) == "{" + head + ",\"certificate\":{" + exact + "}}");
    check_proven(line);
  }
}

// -- That it is true --------------------------------------------------------------------------------------------------

namespace {

using Corners = std::vector<Point>;

std::string text_of(const Corners& corners) {
  std::string list;
  for (const Point& p : corners) list += (list.empty() ? "" : ",") + Json{p.x(), p.y(), p.z()}.dump();
  return points(list);
}

/// A few points on a small grid, which often touch, are flat, or coincide; turned askew by a sheer that rounds in doubles.
Corners random_corners(Dice& dice, double size) {
  Corners corners;
  const int count = dice.between(1, 6), flat = dice.between(0, 2);
  for (int i = 0; i < count; ++i) {
    const double x = dice.between(-3, 3), y = dice.between(-3, 3), z = flat == 0 ? 0 : dice.between(-3, 3);
    corners.push_back(size * Point(x + 0.1 * y, y + 0.3 * z, z + 0.7 * x));
  }
  return corners;
}

}  // namespace

TEST_CASE("Certified answers are proven by their certificates, by all rules and with each zero test") {
  std::map<std::string, int> seen;
  for (const QueryScalar scalar : floating_scalars)
    for (const auto& rules : gjk::rule_sets)
      for (const auto& zero_test : gjk::zero_tests) {
        Dice dice(7474);
        for (int i = 0; i < 150; ++i) {
          QueryOptions options = certified(scalar);
          options.rules = rules.value;
          options.zero_test = zero_test.value;
          const double size = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-30 : 1e30;
          const Corners a = random_corners(dice, size), b = random_corners(dice, size);
          const std::string line = pair_of(text_of(a), text_of(b));
          check_proven(line, options);
          const Json said = Json::parse(answer_text(line, options));
          ++seen[said["proof"]];
          ++seen[said["certificate"].begin().key()];
        }
      }
  for (const char* each : {"direction", "nearest", "simplex", "tetrahedron", "second-search"}) {
    INFO(each);
    CHECK(seen[each] > 20);
  }
}

TEST_CASE("What the first search begins with, and how far it may go, changes no certified answer") {
  Dice dice(3);
  for (int i = 0; i < 100; ++i) {
    const Corners a = random_corners(dice, 1), b = random_corners(dice, 1);
    const std::string line = pair_of(text_of(a), text_of(b));
    const Json expected = Json::parse(answer_text(line))["status"];
    QueryOptions one = certified(), between = certified(), inside = certified(), along = certified();
    one.iteration_limit = 1;
    between.start = QueryStart::between;
    inside.start = QueryStart::inside;
    along.first_direction = Point(5e-324, 0, -1.7976931348623157e308);
    for (const QueryOptions& options : {one, between, inside, along}) {
      check_proven(line, options);
      CHECK(Json::parse(answer_text(line, options))["status"] == expected);
    }
  }
}

TEST_CASE("Certified answers are right where plain ones are not") {
  const std::string line = pair_of(points("[0,0.5],[0.3,0.2]"), points("[0.3,0.8],[0,0.5]"));
  CHECK(has(answer_text(line, {}), "\"separated\""));
  CHECK(has(answer_text(line), "\"intersecting\""));
  check_proven(line);
}

TEST_CASE("Every finite number can be certified, the largest and the smallest together") {
  const std::string huge = "1.7976931348623157e308", tiny = "5e-324";
  const auto status = [](const std::string& a, const std::string& b) {
    const std::string line = pair_of(points(a), points(b));
    check_proven(line);
    return Json::parse(answer_text(line))["status"].get<std::string>();
  };
  const std::string from = "[-" + huge + ",-" + huge + ",0]", to = "[" + huge + "," + huge + ",0]",
                    origin = "[-0.0,0,-0.0]";
  CHECK(status(from + "," + to, origin) == "intersecting");
  CHECK(status(from + "," + to, "[" + tiny + "," + tiny + ",0]") == "intersecting");
  CHECK(status(from + "," + to, "[" + tiny + ",0,0]") == "separated");
  CHECK(status(from + "," + to, "[0,0,-" + tiny + "]") == "separated");
  CHECK(status(from, to) == "separated");
  CHECK(status("[" + tiny + ",0,0],[-" + tiny + ",0,0]", origin) == "intersecting");
  CHECK(status("[" + tiny + ",0,0],[0," + tiny + ",0]", origin) == "separated");
  CHECK(status("[-0.0,0,0]", "[0,-0.0,0]") == "intersecting");
  CHECK(status(from + "," + to + ",[0,0," + tiny + "]", "[0,0," + tiny + "]") == "intersecting");
}

TEST_CASE("Certified in float, every number that rounds to a finite float is one") {
  const auto status = [](const std::string& a, const std::string& b) {
    const std::string line = pair_of(points(a), points(b));
    check_proven(line, certified(QueryScalar::binary32));
    return Json::parse(answer_text(line, certified(QueryScalar::binary32)))["status"].get<std::string>();
  };
  CHECK(status("[-3.4028234663852886e38,1,0],[3.4028235e38,-1,0]", "[0,0,0]") == "intersecting");
  CHECK(status("[-3.4028235e38,1e-45,0],[3.4028235e38,1e-45,0]", "[0,0,0]") == "separated");
  CHECK(status("[1e-45,0,0]", "[1.4e-45,0,0]") == "intersecting");
  CHECK(status("[1e-46,0,0]", "[0,0,0]") == "intersecting");  // the same floats
  CHECK(status("[0.1,0,0]", "[0.10000000149011612,0,0]") == "intersecting");
}

// -- Bad lines --------------------------------------------------------------------------------------------------------

TEST_CASE("Lines that hold no pair are told, certified as else") {
  for (const auto& [object, part] : std::vector<std::pair<std::string, std::string>>{
           {"{}", ": has no shape"},
           {points(""), ".points: has no point"},
           {points("[1e400,0,0]"), ".points[0][0]: the number '1e400' is too large for floating point"},
           {points("[NaN,0,0]"), "'NaN' is not a number"}})
    for (const QueryScalar scalar : floating_scalars) {
      INFO(object);
      const Json first = Json::parse(answer_text(pair_of(object, dot), certified(scalar)));
      const Json second = Json::parse(answer_text(pair_of(dot, object), in_fractions(certified(scalar))));
      CHECK(has(first.value("error", ""), part));
      CHECK(has(second.value("error", ""), part));
      CHECK((first["line"] == 7 && first.size() == 2));
      if (part[0] == '.')
        CHECK((first["error"].get<std::string>()[0] == 'a' && second["error"].get<std::string>()[0] == 'b'));
    }
  CHECK(has(answer_text(pair_of(points("[3.5e38,0,0]"), dot), certified(QueryScalar::binary32)),
            "a.points[0][0]: 3.5e+38 is beyond the largest float, 3.4e38"));
  CHECK(has(answer_text("", certified()), "the line is blank"));
}

// -- Starting inside --------------------------------------------------------------------------------------------------

TEST_CASE("From inside, the mean of all points may be one of the points that hold the origin, and has the index -1") {
  const std::string line = pair_of(points("[0,0,0],[4,0,0],[0,4,0],[0,0,4]"), points("[0.5,0.5,0.5],[5,1,1],[1,5,2]"));
  QueryOptions inside = certified();
  inside.start = QueryStart::inside;
  const Json said = Json::parse(answer_text(line, inside));
  INFO(said);
  CHECK(said["status"] == "intersecting");
  CHECK(said["proof"] == "tetrahedron");
  CHECK(said["certificate"]["simplex"][0] == Json::array({-1, -1}));
  check_proven(line, inside);
}

TEST_CASE("From inside, a simplex that is no certificate shows its first vertex without indices") {
  QueryOptions inside;
  inside.start = QueryStart::inside;
  const Json met = Json::parse(answer_text(pair_of(points("[0,0,0],[2,0,0]"), points("[1,0,0]")), inside));
  CHECK(met["status"] == "intersecting");
  CHECK(met["iterations"] == 0);
  CHECK(met["evidence"]["simplex"].dump() == R"([{"w":[0,0,0],"a":[1,0,0],"b":[1,0,0]}])");
  for (const QueryScalar scalar : {QueryScalar::binary32, QueryScalar::long_double, QueryScalar::exact}) {
    inside.scalar = scalar;
    const std::string apart =
        answer_text(pair_of(points("[0,0,0],[1,0,0],[0,1,0]"), points("[3,3,1],[4,4,4]")), inside);
    CHECK(Json::parse(apart)["status"] == "separated");
    CHECK(Json::parse(apart)["iterations"] == 1);
  }
  inside.scalar = QueryScalar::exact;  // the mean of three points of a segment is no double
  const Json third =
      Json::parse(answer_text(pair_of(points("[0,0,0],[0,0,0],[1,1,1]"), points("[0.5,0.5,0.5]")), inside));
  CHECK(third["status"] == "intersecting");
  CHECK(third["evidence"]["simplex"][0]["a"].dump() == R"(["1/3","1/3","1/3"])");
}

// -- Other shapes -----------------------------------------------------------------------------------------------------

namespace {

std::string ball_at(const std::string& center, const std::string& radius) {
  return R"({"sphere":{"center":)" + center + R"(,"radius":)" + radius + "}}";
}
std::string can_at(const std::string& center) {
  return R"({"cylinder":{"center":)" + center + R"(,"axis":[0,0,2],"radius":1,"height":2}})";
}
std::string posed(const std::string& object, const std::string& pose) {
  return object.substr(0, object.size() - 1) + R"(,"pose":)" + pose + "}";
}

}  // namespace

TEST_CASE("Balls, and balls and points, are decided exactly, to the last digit") {
  const auto said = [](const std::string& a, const std::string& b, QueryScalar scalar = QueryScalar::binary64) {
    const std::string answer = answer_text(pair_of(a, b), certified(scalar));
    CHECK(answer_text(pair_of(b, a), certified(scalar)) == answer);
    CHECK(answer_text(pair_of(b, a), in_fractions(certified(scalar))) == answer);
    return answer;
  };
  const std::string together = R"({"status":"intersecting","proof":"distance"})",
                    apart = R"({"status":"separated","proof":"distance"})";
  CHECK(said(ball, ball_at("[3,4,12]", "12")) == together);
  CHECK(said(ball, ball_at("[3,4,12]", "11.999999999999998")) == apart);
  CHECK(said(ball, ball_at("[3,4,12]", "11.999999999999998"), QueryScalar::binary32) == together);  // the float 12
  CHECK(said(ball, ball_at("[3,4,12]", "11.999999"), QueryScalar::binary32) == apart);
  CHECK(said(points("[-1,3,4],[1,3,4]"), ball_at("[0,0,0]", "5")) == together);
  CHECK(said(points("[-1,3,4],[1,3,4]"), ball_at("[0,0,0]", "4.999999999999999")) == apart);
  CHECK(said(posed(points("[3,4,0]"), R"({"translation":[0,0,0]})"), ball_at("[0,0,0]", "5")) == together);
}

TEST_CASE("Cylinders, sums and what a pose moves are proven, or undecided with a bound on the gap") {
  const std::string capsule = R"({"sum":[{"points":[[0,0,-1],[0,0,1]]},)" + std::string(ball) + "]}";
  const std::string box = posed(points("[-1,-1,-1],[1,-1,-1],[-1,1,-1],[1,1,-1],[-1,-1,1],[1,-1,1],[-1,1,1],[1,1,1]"),
                                R"({"translation":[0,0,-3],"rotation":{"axis":[0,0,1],"degrees":30}})");
  for (const QueryScalar scalar : floating_scalars)
    for (const std::string& object : {can_at("[0,0,0]"), capsule, box, posed(ball, R"({"translation":[0,0.5,0]})")}) {
      INFO(object);
      const Json met = Json::parse(answer_text(pair_of(object, can_at("[0.3,0.2,-1.5]")), certified(scalar)));
      CHECK(met["status"] == "intersecting");
      CHECK(met["proof"] == "surface");
      CHECK(met.size() == 3);
      const Json apart = Json::parse(answer_text(pair_of(object, can_at("[0,7,0]")), certified(scalar)));
      CHECK(apart["status"] == "separated");
      CHECK(apart["proof"] == "direction");
      CHECK(apart["certificate"]["direction"].size() == 3);
      CHECK(apart.size() == 4);
      const Json exact = Json::parse(answer_text(pair_of(object, can_at("[0,7,0]")), in_fractions(certified(scalar))));
      CHECK(exact["certificate"]["direction"][1].is_string());
    }
  for (const std::string& touching : {can_at("[0.25,0,2]"), posed(capsule, R"({"translation":[0,0,3]})")}) {
    const Json said = Json::parse(answer_text(pair_of(can_at("[0,0,0]"), touching)));
    INFO(said);
    CHECK(said["status"] == "undecided");
    CHECK((said["gap"] > 0 && said["gap"] < 1e-6));
    CHECK(said.size() == 3);
  }
}

TEST_CASE("Shapes too large for their products are undecided, and nothing is known of their gap") {
  const Json said = Json::parse(answer_text(pair_of(can_at("[1e308,0,0]"), can_at("[0,0,0]"))));
  CHECK(said["status"] == "undecided");
  CHECK(said["gap"] == "inf");
}

TEST_CASE("A pose that moves nothing does no harm to what is certified, nor do a name and points of the plane") {
  const std::string still = R"({"points":[[0.1,0.2]],"name":"dot","pose":{"translation":[0,-0.0,0],)"
                            R"("rotation":{"axis":[1,2,3],"degrees":360}}})";
  for (const QueryScalar scalar : floating_scalars)
    CHECK(answer_text(pair_of(still, points("[0.1,0.2,0]")), certified(scalar)) ==
          answer_text(pair_of(points("[0.1,0.2,0]"), points("[0.1,0.2]")), certified(scalar)));
}
