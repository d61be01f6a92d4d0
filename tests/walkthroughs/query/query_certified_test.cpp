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
    QueryOptions one = certified(), between = certified(), along = certified();
    one.iteration_limit = 1;
    between.start = QueryStart::between;
    along.first_direction = Point(5e-324, 0, -1.7976931348623157e308);
    for (const QueryOptions& options : {one, between, along}) {
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

TEST_CASE("What cannot be certified is told, and what to do") {
  const std::string sum = R"({"sum":[{"points":[[0,0,0]]},)" + std::string(ball) + "]}";
  const std::string can = R"({"cylinder":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1}})";
  const auto posed = [](const std::string& pose) { return R"({"points":[[0,0,0]],"pose":)" + pose + "}"; };
  for (const auto& [object, part] : std::vector<std::pair<std::string, std::string>>{
           {ball,
            ".sphere: a sphere cannot be certified, because its points are computed, and so rounded; give points"},
           {can, ".cylinder: a cylinder cannot be certified"},
           {sum, ".sum: a sum of a point set and a sphere cannot be certified"},
           {posed(R"({"translation":[5e-324,0,0]})"), ".pose: an object that its pose moves cannot be certified"},
           {posed(R"({"rotation":{"axis":[0,0,1],"degrees":90}})"),
            "give the points where they are, or leave out --cert"},
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

TEST_CASE("A pose that moves nothing does no harm to what is certified, nor do a name and points of the plane") {
  const std::string still = R"({"points":[[0.1,0.2]],"name":"dot","pose":{"translation":[0,-0.0,0],)"
                            R"("rotation":{"axis":[1,2,3],"degrees":360}}})";
  for (const QueryScalar scalar : floating_scalars)
    CHECK(answer_text(pair_of(still, points("[0.1,0.2,0]")), certified(scalar)) ==
          answer_text(pair_of(points("[0.1,0.2,0]"), points("[0.1,0.2]")), certified(scalar)));
}
