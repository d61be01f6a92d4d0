#include "tests/study/steps/told_run.hpp"

#include "tests/kit/catch.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

const std::string pair = R"({"name":"p","a":{"points":[[0,0,0]]},"b":{"points":[[1,0,0]]}})";
const std::string step = R"({"direction":[1,0,0],"simplex":[[-1,0,0]]})";

TEST_CASE("Told runs: searches are read with their steps and answers, several of a file", "[steps]") {
  const auto runs = read_told_runs(pair + "\r\n" + step + "\n" + step + "\nfalse\n" + pair + "\n" + step, "f");
  REQUIRE(runs.size() == 2);
  CHECK((runs[0].named.name == "p" && runs[0].steps.size() == 2 && runs[0].said == Said::separated));
  CHECK((runs[1].steps.size() == 1 && !runs[1].said));
  CHECK(runs[0].steps[1].simplex == std::vector<Vec>{Vec(-1, 0, 0)});
}

TEST_CASE("Told runs: of a direction only the ratios count, however long it is", "[steps]") {
  const auto runs = read_told_runs(pair + R"(
{"direction":[1e308,-5e307,0],"simplex":[[1,0,0]]})",
                                   "f");
  const Vec d = runs.at(0).steps.at(0).direction;
  CHECK(d[0] == Approx(-2 * d[1]));
  CHECK((d[0] >= 1 && d[0] < 2));
}

TEST_CASE("Told runs: the newest vertex is the last, whichever end it was told at in every step", "[steps]") {
  const auto last_of = [](const std::vector<std::string>& simplices) {
    std::string text = pair;
    for (const std::string& simplex : simplices) text += "\n{\"direction\":[1,0,0],\"simplex\":[" + simplex + "]}";
    return read_told_runs(text, "f").at(0).steps.back().simplex.back();
  };
  const std::string a = "[1,0,0]", b = "[2,0,0]", c = "[3,0,0]", d = "[4,0,0]";
  CHECK(last_of({a, b + "," + a, c + "," + b + "," + a}) == Vec(3, 0, 0));
  CHECK(last_of({a, b + "," + a, c + "," + a, d + "," + a}) == Vec(4, 0, 0));
  CHECK(last_of({a, a + "," + b, a + "," + b + "," + c}) == Vec(3, 0, 0));
  CHECK(last_of({a, b + "," + a, b + "," + a + "," + c, d + "," + c}) == Vec(3, 0, 0));  // once at the other end
  CHECK(last_of({a, b + "," + a}) == Vec(1, 0, 0));                                      // one step may be a mistake
}

TEST_CASE("Told runs: what is no step is refused with its line and the reason", "[steps]") {
  const auto check_fails = [](const std::string& line, const std::string& words) {
    INFO(line);
    CHECK_THROWS_WITH(read_told_runs(pair + "\n" + line + "\n", "f"), kit::contains("f:2: ") && kit::contains(words));
  };
  check_fails("", "");
  check_fails("{", "");
  check_fails("[1]", "a step has");
  check_fails("{}", "a step has");
  check_fails(R"({"direction":[1,0,0]})", "a step has");
  check_fails(R"({"direction":[1,0],"simplex":[[0,0,0]]})", "direction: must be [x, y, z]");
  check_fails(R"({"direction":[1,0,"x"],"simplex":[[0,0,0]]})", "direction[2]: must be a number");
  check_fails(R"({"direction":[1,0,0],"simplex":[[0,0,1e300]]})", "simplex[0]: is too far away");
  check_fails(R"({"direction":[1,0,0],"simplex":[]})", "one to four points");
  check_fails(R"({"direction":[1,0,0],"simplex":[[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]]})", "one to four points");
  check_fails(R"({"a":{"points":[[0,0,0]]}})", "b");
  check_fails(R"({"a":{"sphere":{"center":[0,0,0],"radius":1}},"b":{"sphere":{"center":[0,0,0],"radius":1}}})",
              "sets of points");
  CHECK_THROWS_WITH(read_told_runs(pair + "\ntrue\n" + step, "f"), kit::contains("f:3: comes after the answer"));
  CHECK_THROWS_WITH(read_told_runs("true\n" + step, "f"), kit::contains("f:1: ") && kit::contains("must be a pair"));
  CHECK_THROWS_WITH(read_told_runs("", "f"), kit::contains("is empty"));
}

}  // namespace
}  // namespace study
