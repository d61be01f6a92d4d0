// gjkstep query: its answers and its errors, line by line.

#include "walkthroughs/query/query.hpp"

#include <boost/multiprecision/gmp.hpp>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "tests/core/support.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/query/queries.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/query/query_object.hpp"
#include "walkthroughs/text/scene_limits.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::test::Dice;
using Json = nlohmann::json;

namespace {

std::string answer_text(const std::string& line, const QueryOptions& options = {}) {
  std::string out;
  answer_line(line, 7, options, out);
  REQUIRE(lines(out).size() == 1);
  return lines(out)[0];
}

Json answer(const std::string& line, const QueryOptions& options = {}) {
  return Json::parse(answer_text(line, options));
}

/// Returns: the error of a bad line.
std::string error_of(const std::string& line, const QueryOptions& options = {}) {
  INFO(line.substr(0, 200));
  const Json said = answer(line, options);
  INFO(said.dump(-1, ' ', false, Json::error_handler_t::replace));
  REQUIRE(said.size() == 2);
  CHECK(said["line"] == 7);
  return said["error"];
}

}  // namespace

// -- Answers ----------------------------------------------------------------------------------------------------------

namespace {

template <class S>
S number_of(const std::string& token) {
  if constexpr (std::same_as<S, float>) return std::strtof(token.c_str(), nullptr);
  if constexpr (std::same_as<S, double>) return std::strtod(token.c_str(), nullptr);
  if constexpr (std::same_as<S, long double>) return std::strtold(token.c_str(), nullptr);
  if constexpr (std::same_as<S, Exact>) return Exact(token);
}

/// Returns: the numbers of the evidence in the order of the text, but for indices.
template <class S>
std::vector<S> numbers_in(const std::string& answer) {
  std::string text = answer.substr(answer.find("\"evidence\""));
  for (const std::string key : {"\"a_index\":", "\"b_index\":"})
    for (std::size_t at; (at = text.find(key)) != std::string::npos;)
      text.erase(at, text.find_first_of(",}", at + key.size()) - at);
  std::vector<S> numbers;
  constexpr const char* of_numbers = "0123456789+-.e/";
  for (std::size_t at = 0; (at = text.find_first_of("0123456789-", at)) != std::string::npos;) {
    const std::size_t end = text.find_first_not_of(of_numbers, at);
    numbers.push_back(number_of<S>(text.substr(at, end - at)));
    at = end;
  }
  return numbers;
}

template <class S>
void add(std::vector<S>& numbers, const gjk::Vec3<S>& v) {
  numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
}

template <class S>
std::vector<S> numbers_of(const gjk::Result<S>& result) {
  std::vector<S> numbers;
  if (const auto& proof = result.separation) {
    add(numbers, proof->direction);
    numbers.push_back(proof->support_value);
    add(numbers, proof->vertex.a.point);
    add(numbers, proof->vertex.b.point);
    return numbers;
  }
  for (int i = 0; i < result.simplex.size(); ++i) {
    add(numbers, result.simplex[i].w);
    add(numbers, result.simplex[i].a.point);
    add(numbers, result.simplex[i].b.point);
  }
  return numbers;
}

template <class S>
void check_indices(const Json& written, const gjk::Vertex<S>& vertex) {
  CHECK(written.contains("a_index") == vertex.a.index.has_value());
  CHECK(written.contains("b_index") == vertex.b.index.has_value());
  if (vertex.a.index) CHECK(written["a_index"] == *vertex.a.index);
  if (vertex.b.index) CHECK(written["b_index"] == *vertex.b.index);
}

template <class S>
void check_says(const std::string& text, const gjk::Result<S>& result) {
  const Json said = Json::parse(text);
  CHECK(said["status"] == std::string(to_string(result.status)));
  CHECK(said["reason"] == std::string(to_string(result.reason)));
  CHECK(said["iterations"] == result.iterations);
  CHECK(numbers_in<S>(text) == numbers_of(result));
  if (result.separation) return check_indices(said["evidence"], result.separation->vertex);
  REQUIRE(said["evidence"]["simplex"].size() == static_cast<std::size_t>(result.simplex.size()));
  for (int i = 0; i < result.simplex.size(); ++i)
    check_indices(said["evidence"]["simplex"][static_cast<std::size_t>(i)], result.simplex[i]);
}

/// The support function of whatever shape, so that each search is compiled once, not once a shape.
template <class S>
struct SupportOf {
  std::function<gjk::SupportPoint<S>(const gjk::Vec3<S>&)> support;

  explicit SupportOf(const auto& shape) : support([&](const gjk::Vec3<S>& d) { return shape.support(d); }) {}
};

/// Returns: the answer of a plain call of the algorithm. `between`: from a point inside one to a point inside the other.
template <class S>
gjk::Result<S> called(const auto& a, const auto& b, const gjk::Vec3<S>& between, const QueryOptions& query) {
  gjk::Options<S> options;
  options.iteration_limit = query.iteration_limit;
  if (query.rules == RuleSet::eager && !gjk::is_zero(between)) options.first_direction = between;
  const auto by = [&]<class Rules>() { return gjk::collision<S, Rules>(SupportOf<S>(a), SupportOf<S>(b), options); };
  if constexpr (std::floating_point<S>)
    return gjk::with_rules(query.rules, query.zero_test, by);
  else  // nothing is rounded: both zero tests are this one, and fractions take the longest to compile
    return gjk::with_rules<gjk::ExactZeroTest>(query.rules, by);
}

using Corners = std::vector<Point>;

template <class S>
gjk::PointSet<S> in_scalar(const Corners& corners) {
  std::vector<gjk::Vec3<S>> points;
  for (const Point& p : corners) points.emplace_back(S(p.x()), S(p.y()), S(p.z()));
  return gjk::PointSet<S>(points);
}

Point mean(const Corners& corners) {
  Point sum = Point::Zero();
  for (const Point& p : corners) sum += p;
  return sum / static_cast<double>(corners.size());
}

template <class S>
gjk::Vec3<S> in_scalar(const Point& p) {
  return {S(p.x()), S(p.y()), S(p.z())};
}

std::string json(const Point& p) { return Json{p.x(), p.y(), p.z()}.dump(); }

std::string json(const Corners& corners) {
  std::string list;
  for (const Point& p : corners) list += (list.empty() ? "" : ",") + json(p);
  return "{\"points\":[" + list + "]}";
}

Point random_point(Dice& dice) {
  const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0);
  return {x, y, dice.between(-1.0, 1.0)};
}

/// Half of them of whole numbers, which often touch.
Corners random_corners(Dice& dice) {
  const bool is_whole = dice.between(0, 1) == 0;
  Corners corners;
  const int count = dice.between(1, 8);
  for (int i = 0; i < count; ++i) {
    const Point p = random_point(dice);
    corners.push_back(is_whole ? Point((p * 3).array().round()) : p);
  }
  return corners;
}

template <class S>
void check_random_pairs(QueryScalar scalar, RuleSet rules, ZeroTest zero_test, int count) {
  Dice dice(7474);
  int statuses[3] = {};
  for (int i = 0; i < count; ++i) {
    const QueryOptions options{
        .scalar = scalar, .rules = rules, .zero_test = zero_test, .iteration_limit = i % 3 == 0 ? 3 : 20};
    const Corners a = random_corners(dice), b = random_corners(dice);
    INFO("pair " << i << ": " << pair_of(json(a), json(b)));
    const auto set_a = in_scalar<S>(a), set_b = in_scalar<S>(b);
    const auto result = called<S>(set_a, set_b, in_scalar<S>(Point(mean(b) - mean(a))), options);
    ++statuses[static_cast<int>(result.status)];
    check_says(answer_text(pair_of(json(a), json(b)), options), result);
  }
  for (const int seen : statuses) CHECK(seen > count / 50);
}

}  // namespace

TEST_CASE("The answers to point sets are those of collision() in every scalar, by all rules and with each zero test") {
  for (const auto& rules : gjk::rule_sets)
    for (const auto& zero_test : gjk::zero_tests) {
      check_random_pairs<float>(QueryScalar::binary32, rules.value, zero_test.value, 500);
      check_random_pairs<double>(QueryScalar::binary64, rules.value, zero_test.value, 500);
      check_random_pairs<long double>(QueryScalar::long_double, rules.value, zero_test.value, 500);
      check_random_pairs<Exact>(QueryScalar::exact, rules.value, zero_test.value, 200);
    }
}

namespace {

template <class S>
void check_random_round_pairs(QueryScalar scalar, RuleSet rules) {
  Dice dice(21);
  for (int i = 0; i < 300; ++i) {
    const QueryOptions options{.scalar = scalar, .rules = rules};
    const Point center = random_point(dice), middle = random_point(dice), axis = random_point(dice);
    const double radius = dice.between(0.1, 1.0), width = dice.between(0.1, 1.0), height = dice.between(0.1, 1.0);
    const gjk::Sphere<S> sphere(in_scalar<S>(center), S(radius));
    const gjk::Cylinder<S> cylinder(in_scalar<S>(middle), in_scalar<S>(axis), S(width), S(height));
    const std::string line =
        pair_of(R"({"sphere":{"center":)" + json(center) + R"(,"radius":)" + Json(radius).dump() + "}}",
                R"({"cylinder":{"center":)" + json(middle) + R"(,"axis":)" + json(axis) + R"(,"radius":)" +
                    Json(width).dump() + R"(,"height":)" + Json(height).dump() + "}}");
    INFO(line);
    check_says(answer_text(line, options), called<S>(sphere, cylinder, in_scalar<S>(Point(middle - center)), options));
  }
}

}  // namespace

TEST_CASE("The answers to spheres and cylinders are those of collision() in every floating scalar") {
  for (const RuleSet rules : {RuleSet::as_intended, RuleSet::eager}) {
    check_random_round_pairs<float>(QueryScalar::binary32, rules);
    check_random_round_pairs<double>(QueryScalar::binary64, rules);
    check_random_round_pairs<long double>(QueryScalar::long_double, rules);
  }
}

TEST_CASE("A pose moves an object in every scalar") {
  const std::string far = R"({"points":[[1,0,0],[0,1,0],[0,0,1]],"name":"corner","pose":{"translation":[0,0,-5]}})";
  const std::string turned = R"({"points":[[5,-1,0],[5,1,0]],"pose":{"rotation":{"axis":[0,0,1],"degrees":90}}})";
  for (const QueryScalar scalar :
       {QueryScalar::binary32, QueryScalar::binary64, QueryScalar::long_double, QueryScalar::exact}) {
    CHECK(answer(pair_of(far, dot), {.scalar = scalar})["status"] == "separated");
    CHECK(answer(pair_of(turned, R"({"points":[[0,5,0]]})"), {.scalar = scalar})["status"] == "intersecting");
  }
  const gjk::Pose<double> pose{.translation = {0, 0, -5}};
  using PointSet = gjk::PointSet<double>;
  const gjk::Posed<double, PointSet> posed(PointSet({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), pose);
  check_says(answer_text(pair_of(far, dot)), called<double>(posed, PointSet({{0, 0, 0}}), {1, 0, 0}, {}));
}

TEST_CASE("A sum of point sets gives the answer of the set of all sums, in every scalar") {
  const std::string sum = R"({"sum":[{"points":[[1,0,0],[0,1,0],[0,0,1]]},{"points":[[2,2,2],[3,-1,0.5]]}]})";
  const std::string all = R"({"points":[[3,2,2],[4,-1,0.5],[2,3,2],[3,0,0.5],[2,2,3],[3,-1,1.5]]})";
  for (const QueryScalar scalar :
       {QueryScalar::binary32, QueryScalar::binary64, QueryScalar::long_double, QueryScalar::exact})
    for (const char* other : {dot, R"({"points":[[2.5,2.25,2],[9,9,9]]})", R"({"points":[[3,1,1],[3,2,3],[2,0,2]]})"}) {
      Json of_sum = answer(pair_of(sum, other), {.scalar = scalar}),
           of_all = answer(pair_of(all, other), {.scalar = scalar});
      CHECK(of_sum["status"] == of_all["status"]);
      CHECK(of_sum["iterations"] == of_all["iterations"]);
      CHECK(answer(pair_of(other, sum), {.scalar = scalar})["status"] == of_all["status"]);
    }
  CHECK(!answer(pair_of(sum, dot))["evidence"].contains("a_index"));  // a sum has no list
}

TEST_CASE("A capsule is a segment plus a ball: it ends a radius beyond the segment") {
  const std::string capsule =
      R"({"sum":[{"points":[[-1,0,0],[1,0,0]]},{"sphere":{"center":[0,0,0],"radius":0.5}}],"pose":{"translation":[0,0,9]}})";
  for (const QueryScalar scalar : {QueryScalar::binary32, QueryScalar::binary64, QueryScalar::long_double}) {
    const auto status_at = [&](const std::string& point) {
      return answer(pair_of(capsule, "{\"points\":[" + point + "]}"), {.scalar = scalar})["status"];
    };
    for (const char* inside : {"[1.499,0,9]", "[0.9,0.49,9]", "[-1.3,0,9.3]"})
      CHECK(status_at(inside) == "intersecting");
    for (const char* outside : {"[1.501,0,9]", "[0.9,0.51,9]", "[-1.4,0,9.4]"})
      CHECK(status_at(outside) == "separated");
  }
}

TEST_CASE("Eager rules search from where the poses put the centers, and need one point of most that are apart") {
  const std::string far = R"({"points":[[1,0,0],[0,1,0],[-1,-1,0]],"pose":{"translation":[0,0,-5]}})";
  for (const QueryScalar scalar :
       {QueryScalar::binary32, QueryScalar::binary64, QueryScalar::long_double, QueryScalar::exact}) {
    const Json said = answer(pair_of(far, dot), {.scalar = scalar, .rules = RuleSet::eager});
    CHECK(said["status"] == "separated");
    CHECK(said["iterations"] == 1);
    CHECK(answer(pair_of(far, far), {.scalar = scalar, .rules = RuleSet::eager})["status"] == "intersecting");
  }
  const std::string end = R"({"points":[[3e38,0,0]]})", other_end = R"({"points":[[-3e38,0,0]]})";
  const Json beyond = answer(pair_of(end, other_end), {.scalar = QueryScalar::binary32, .rules = RuleSet::eager});
  CHECK(beyond["iterations"] == 1);  // their distance is no float, so the search begins along +x
}

namespace {

template <class S>
void check_beginning(QueryScalar scalar) {
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const Corners a = random_corners(dice), b = random_corners(dice);
    const Point direction = random_point(dice);
    const std::string line = pair_of(json(a), json(b));
    INFO(line << " along " << json(direction));
    const auto set_a = in_scalar<S>(a), set_b = in_scalar<S>(b);
    gjk::Options<S> options{.first_direction = in_scalar<S>(direction)};
    check_says(answer_text(line, {.scalar = scalar, .first_direction = direction}),
               gjk::collision<S>(set_a, set_b, options));
    options.first_direction = in_scalar<S>(gjk::first_direction_between(mean(a), mean(b)));
    check_says(answer_text(line, {.scalar = scalar, .start = QueryStart::between}),
               gjk::collision<S>(set_a, set_b, options));
  }
}

}  // namespace

TEST_CASE("A search begins along the direction given, or between the centers, in every scalar") {
  check_beginning<float>(QueryScalar::binary32);
  check_beginning<double>(QueryScalar::binary64);
  check_beginning<long double>(QueryScalar::long_double);
  check_beginning<Exact>(QueryScalar::exact);
}

TEST_CASE(
    "Points of the plane have two numbers, or a third that is 0, a pair may say that it is planar, as scenes do") {
  const std::string flat = R"({"points":[[0,0],[2,0],[0,2]]})", also_flat = R"({"points":[[0,0,0],[2,0,0],[0,2,0]]})";
  const std::string disc = R"({"sphere":{"center":[3,3],"radius":1}})",
                    a_ball = R"({"sphere":{"center":[3,3,0],"radius":1}})";
  CHECK(answer(pair_of(flat, disc)) == answer(pair_of(also_flat, a_ball)));
  const auto planar = [](const std::string& a, const std::string& b) {
    return answer("{\"dimension\":2,\"a\":" + a + ",\"b\":" + b + "}");
  };
  CHECK(planar(flat, disc) == answer(pair_of(flat, disc)));
  CHECK(planar(R"({"points":[[0,0],[2,0]],"pose":{"rotation":{"degrees":90}}})", disc)["status"] == "separated");
  CHECK(has(planar(also_flat, R"({"points":[[0,0,1]]})")["error"].get<std::string>(), "b.points[0][2]: must be 0"));
  CHECK(has(answer(R"({"dimension":4,"a":{},"b":{}})")["error"].get<std::string>(), "whole number from 2 to 3"));
}

TEST_CASE("What a line says of the pair as a whole, its name and its answer among it, is not looked at") {
  const std::string pair = R"("a":{"points":[[0,0,0]]},"b":{"points":[[1,0,0]]})";
  CHECK(answer(R"({"name":"x","family":7,"answer":{"status":"intersecting"},"notes":["touching"],"source":"y",)" +
               pair + "}") == answer("{" + pair + "}"));
  CHECK(has(answer(R"({"nome":"x",)" + pair + "}")["error"].get<std::string>(), "nome"));
}

TEST_CASE("Two unit spheres ten apart meet as Algorithm 1 is printed and not as it is meant") {
  const std::string line = pair_of(ball, ball_ten_away);
  CHECK(answer(line, {.rules = RuleSet::as_intended})["status"] == "separated");
  CHECK(answer(line, {.rules = RuleSet::as_printed})["status"] == "intersecting");
}

TEST_CASE("Exact numbers decide touching triangles askew that floating point may not") {
  // The second begins where an edge of the first has its middle: in binary fractions of the decimals exactly so.
  const std::string line = pair_of(R"({"points":[[0.75,0.25,0.5],[0.25,0.75,-0.5],[-9,-9,0.1]]})",
                                   R"({"points":[[0.5,0.5,0],[7,9,0.3],[9,7,0.7]]})");
  CHECK(answer(line, {.scalar = QueryScalar::exact})["status"] == "intersecting");
}

TEST_CASE("Evidence in exact numbers is written as fractions in lowest terms") {
  const std::string line = pair_of(R"({"points":[[0.5,3,0]]})", R"({"points":[[2,0.25,0]]})");
  const Json evidence = answer(line, {.scalar = QueryScalar::exact})["evidence"];
  CHECK(evidence["a"] == Json{"1/2", "3", "0"});
  CHECK(evidence["b"] == Json{"2", "1/4", "0"});
}

TEST_CASE("What is not finite is a word") {
  const Json said =
      answer(pair_of(R"({"points":[[3e38,3e38,3e38],[-3e38,1,3e38]]})", R"({"points":[[-3e38,-3e38,-3e38]]})"),
             {.scalar = QueryScalar::binary32});
  CHECK(said["status"] == "undecided");
  CHECK(has(said["evidence"].dump(), "\"inf\""));
}

TEST_CASE("A long double beyond all doubles is a string that reads back the same") {
  const Corners a{{1e150, -1e150, 1}, {1e-320, 5e-324, -1e150}}, b{{1e29, 1e-300, 0}};
  const QueryOptions options{.scalar = QueryScalar::long_double};
  const std::string text = answer_text(pair_of(json(a), json(b)), options);
  CHECK(has(text, "e+449\""));
  check_says(text, called<long double>(in_scalar<long double>(a), in_scalar<long double>(b), {1, 0, 0}, options));
}

TEST_CASE("Numbers keep the sign of zero where they are written with a fraction") {
  const auto simplex = [](const std::string& zero) {
    return answer(pair_of("{\"points\":[[" + zero + ",0,0]]}", dot))["evidence"]["simplex"][0];
  };
  CHECK(std::signbit(simplex("-0.0")["a"][0].get<double>()));
  CHECK_FALSE(std::signbit(simplex("-0")["a"][0].get<double>()));
  CHECK(has(answer_text(pair_of(R"({"points":[[-0.0,0,0]]})", dot)), "\"a\":[-0.0,0,0]"));
}

TEST_CASE("Numbers are read as the nearest double") {
  const auto first = [](const std::string& number) {
    return answer(pair_of("{\"points\":[[" + number + ",0,0]]}", dot))["evidence"];
  };
  CHECK(first("9007199254740993")["a"][0] == 9007199254740992.0);
  CHECK(first("123456789012345678901234567890")["a"][0] == 123456789012345678901234567890.0);
  CHECK(first("1e-400")["simplex"][0]["a"][0] == 0.0);
  CHECK(answer_text(pair_of(R"({"points":[[0.1,0,0]]})", dot), {.scalar = QueryScalar::exact})
            .find("3602879701896397/36028797018963968") != std::string::npos);
}

// -- Bad lines --------------------------------------------------------------------------------------------------------

TEST_CASE("A bad line is told with its number, its place and what to do") {
  const std::string no_number = pair_of(R"({"points":[[NaN,0,0]]})", dot);
  for (const auto& [line, part] : std::vector<std::pair<std::string, std::string>>{
           {"", "blank"},
           {"   \t", "blank"},
           {"\r", "blank"},
           {"nonsense", "is not JSON at column"},
           {"[]", "expected an object { ... } with 'a' and 'b', found a list"},
           {"{}", "a: is missing"},
           {R"({"a":)" + std::string(dot) + "}", "b: is missing"},
           {pair_of(dot, "{}"), "b: has no shape; give 'points', 'sphere', 'cylinder' or 'sum'"},
           {R"({"a":{},"b":{},"c":1})", "c: is not a key; did you mean"},
           {pair_of(R"({"point":[[0,0,0]]})", dot), "a.point: is not a key; did you mean 'points'"},
           {pair_of(R"({"points":[]})", dot), "a.points: has no point"},
           {pair_of(R"({"points":[[0]]})", dot), "a.points[0]: expected a point [x, y, z], found a list of 1"},
           {pair_of(R"({"points":[[0,0,"0"]]})", dot), "a.points[0][2]: expected a number, found a string"},
           {pair_of(R"({"points":[[0,0,null]]})", dot), "a.points[0][2]: expected a number, found null"},
           {no_number, "'NaN' is not a number; write a finite one"},
           {pair_of(R"({"points":[[-Infinity,0,0]]})", dot), "write a finite one"},
           {pair_of(R"({"points":[[1e400,0,0]]})", dot), "a.points[0][0]: the number '1e400' is too large"},
           {pair_of(R"({"points":[[1e151,0,0]]})", dot), "a.points[0][0]: 1e+151 is beyond 1e150"},
           {pair_of(ball, R"({"sphere":{"center":[0,0,0],"radius":0}})"), "b.sphere.radius: must be larger than 0"},
           {pair_of(ball, R"({"sphere":{"center":[0,0,0],"radius":-1}})"), "b.sphere.radius: must be larger than 0"},
           {pair_of(ball, R"({"sphere":{"center":[0,0,0]}})"), "b.sphere.radius: is missing"},
           {pair_of(ball, R"({"cylinder":{"center":[0,0,0],"axis":[0,0,0],"radius":1,"height":1}})"),
            "b.cylinder.axis: has no length"},
           {pair_of(R"({"points":[[0,0,0]],"sphere":{"center":[0,0,0],"radius":1}})", dot), "is a second shape"},
           {pair_of(R"({"sum":[]})", dot), "a.sum: expected a list of two shapes, found a list of 0"},
           {pair_of(R"({"sum":[{"points":[]},{"points":[[0,0,0]]}]})", dot), "a.sum[0].points: has no point"},
           {R"({"a":{"points":[[0,0,0]]},"a":{"points":[[0,0,0]]}})", "a: this key appears twice"},
           {R"({"a":{"points":[[0,0,0]],"points":[[0,0,0]]}})", "a.points: this key appears twice"},
           {pair_of(dot, dot) + pair_of(dot, dot), "is not JSON"},
           {pair_of(dot, dot) + " // no", "is not JSON"},
           {pair_of(dot, dot).substr(0, 30), "is not JSON"},
           {std::string("{\"a\"\0}", 6), "there is a byte 0"},
           {"{\"\xFF\":1}", "is not UTF-8 at column 3: the byte \\xff is no letter there; save the text as UTF-8"},
           {"{\"\xC3\":1}", "is not UTF-8 at column 3: the byte \\xc3"},
           {"{\"\xE2\x80\xAE\x1B\":1}", "there is a byte 27"},
           {R"({"\u202e\u001b":1})", "\\u202e\\x1b: is not a key"},
           {"{\"\\ud800\":1}", "is not JSON"},
           {"\xFF\xFE{", "UTF-16"},
           {std::string(1000000, '['), "too many brackets"},
           {"{\"a\":" + std::string(1000000, '['), "too many brackets"},
           {std::string(1000000, 'x'), "is not JSON"},
           {"\"" + std::string(1000000, 'x') + "\"", "found a string"}}) {
    const std::string error = error_of(line);
    INFO(error);
    CHECK(has(error, part));
    CHECK(error.size() < 400);
  }
}

TEST_CASE("A set may have as many points as in scene files and not one more") {
  std::string points = "[0,0,0]";
  for (std::size_t i = 1; i < scene_limits::points; ++i) points += ",[0,0,0]";
  CHECK(answer(pair_of("{\"points\":[" + points + "]}", dot))["status"] == "intersecting");
  CHECK(has(error_of(pair_of("{\"points\":[" + points + ",[0,0,0]]}", dot)), "too many elements"));
}

TEST_CASE("What a float cannot hold is told and not taken for infinite or nothing") {
  const QueryOptions in_float{.scalar = QueryScalar::binary32};
  for (const auto& [object, part] : std::vector<std::pair<std::string, std::string>>{
           {R"({"points":[[0,0,0],[1e39,0,0]]})", ".points[1][0]: 1e+39 is beyond the largest float"},
           {R"({"sphere":{"center":[0,-1e40,0],"radius":1}})", ".sphere.center[1]: -1e+40 is beyond"},
           {R"({"sphere":{"center":[0,0,0],"radius":1e39}})", ".sphere.radius: 1e+39 is beyond"},
           {R"({"sphere":{"center":[0,0,0],"radius":1e-46}})", ".sphere.radius: 1e-46 is so small that it is 0 as a"},
           {R"({"cylinder":{"center":[0,0,0],"axis":[1,0,0],"radius":1,"height":1e-60}})",
            ".cylinder.height: 1e-60 is so small"},
           {R"({"sum":[{"points":[[0,0,0]]},{"sphere":{"center":[0,0,0],"radius":1e-46}}]})",
            ".sum[1].sphere.radius: 1e-46 is so small"},
           {R"({"points":[[0,0,0]],"pose":{"translation":[1e39,0,0]}})", ".pose.translation[0]: 1e+39 is beyond"}}) {
    CHECK(has(error_of(pair_of(dot, object), in_float), "b" + part));
    CHECK(has(error_of(pair_of(object, dot), in_float), "a" + part));
    CHECK(answer(pair_of(dot, object)).contains("status"));
  }
}

TEST_CASE("The length of an axis does not matter in any scalar, as in scene files") {
  const auto can = [](const std::string& axis) {
    return R"({"cylinder":{"center":[3,0,0],"axis":)" + axis + R"(,"radius":0.5,"height":1}})";
  };
  const std::string far = R"({"points":[[0.1,0.2,0.3],[0.5,-1,2]]})";
  const std::string askew_times_2_to_the_minus_500 =
      json(Point(std::scalbn(0.3, -500), std::scalbn(1.7, -500), std::scalbn(-0.9, -500)));
  for (const QueryScalar scalar : {QueryScalar::binary32, QueryScalar::binary64, QueryScalar::long_double})
    for (const auto& [axis, longer] :
         std::vector<std::pair<std::string, std::string>>{{"[0,1,0]", "[0,1e-100,0]"},
                                                          {"[0,1,0]", "[0,1e150,0]"},
                                                          {"[0,1,0]", "[0,5e-324,0]"},
                                                          {"[0.3,1.7,-0.9]", askew_times_2_to_the_minus_500}}) {
      const QueryOptions options{.scalar = scalar};
      INFO(axis << " " << longer);
      CHECK(answer_text(pair_of(far, can(axis)), options) == answer_text(pair_of(far, can(longer)), options));
    }
}

TEST_CASE("Spheres and cylinders cannot be asked in exact numbers") {
  const QueryOptions exact{.scalar = QueryScalar::exact};
  CHECK(has(error_of(pair_of(dot, ball), exact), "b: a sphere cannot be asked in exact numbers"));
  CHECK(has(error_of(pair_of(R"({"cylinder":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1}})", dot), exact),
            "a: a cylinder cannot be asked in exact numbers"));
  const std::string capsule = R"({"sum":[{"points":[[0,0,0],[1,0,0]]},)" + std::string(ball) + "]}";
  CHECK(has(error_of(pair_of(capsule, dot), exact), "a.sum[1]: a sphere cannot be asked in exact numbers"));
}
