#include "walkthroughs/steps/told_run.hpp"

#include "tests/kit/catch.hpp"
#include "walkthroughs/steps/differences.hpp"

namespace walkthroughs::steps {
namespace told_run_test {

TEST_CASE("Told runs: a step is read, whatever number is none in it", "[steps]") {
  const ToldStep step = read_step(R"( {"direction":[1,0,0],"simplex":[[-1,0,0],[2,3,4]]})");
  CHECK((step.direction == Vec(1, 0, 0) && step.simplex == Vertices{Vec(-1, 0, 0), Vec(2, 3, 4)}));
  CHECK(step.is_of_numbers());
  for (const char* const none : {"nan", "-nan", "NaN", "inf", "-Infinity", "null"}) {
    INFO(none);
    CHECK_FALSE(read_step(std::string(R"({"direction":[1,)") + none + R"(,0],"simplex":[[-1,0,0]]})").is_of_numbers());
    CHECK_FALSE(read_step(std::string(R"({"direction":[1,0,0],"simplex":[[-1,)") + none + ",0]]}").is_of_numbers());
  }
}

TEST_CASE("Told runs: of a direction only the ratios count, however long it is", "[steps]") {
  const Vec d = read_step(R"({"direction":[1e308,-5e307,0],"simplex":[[1,0,0]]})").direction;
  CHECK(d[0] == Approx(-2 * d[1]));
  CHECK((d[0] >= 1 && d[0] < 2));
}

TEST_CASE("Told runs: the newest vertex is the last, whichever end it was told at in every step", "[steps]") {
  const auto last_of = [](const std::vector<std::string>& simplices) {
    ToldRun run{"p", {{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {{0, 0, 0}}}};
    for (const std::string& simplex : simplices)
      run.steps.push_back(read_step("{\"direction\":[1,0,0],\"simplex\":[" + simplex + "]}"));
    bring_to_differences(run);
    return run.steps.back().simplex.back();
  };
  const std::string a = "[1,0,0]", b = "[2,0,0]", c = "[3,0,0]", d = "[4,0,0]";
  CHECK(last_of({a, b + "," + a, c + "," + b + "," + a}) == Vec(3, 0, 0));
  CHECK(last_of({a, b + "," + a, c + "," + a, d + "," + a}) == Vec(4, 0, 0));
  CHECK(last_of({a, a + "," + b, a + "," + b + "," + c}) == Vec(3, 0, 0));
  CHECK(last_of({a, b + "," + a, b + "," + a + "," + c, d + "," + c}) == Vec(3, 0, 0));  // once at the other end
  CHECK(last_of({a, b + "," + a}) == Vec(1, 0, 0));                                      // one step may be a mistake
}

TEST_CASE("Told runs: vertices that are rounded to floats are those of the difference again", "[steps]") {
  ToldRun run{"p", {{{0.1, 0.2, 0.3}, {0.7, 0, 0}}, {{0.4, 0.5, 0.6}}}};
  const Vec exact = run.pair.a[0] - run.pair.b[0];
  run.steps = {{{1, 0, 0}, {exact.cast<float>().cast<double>(), {9, 9, 9}}}};
  bring_to_differences(run);
  CHECK(run.steps.back().simplex == Vertices{exact, {9, 9, 9}});
  CHECK(run.roundings > 1e8);
}

TEST_CASE("Told runs: an answer is no step, whatever its evidence", "[steps]") {
  CHECK(is_meant_as_step(R"({"direction":[1,0,0],"simplex":[[1,0,0]]})"));
  CHECK_FALSE(is_meant_as_step(R"({"status":"separated","direction":[1,0,0],"simplex":[[1,0,0]]})"));
  for (const char* const line : {"", "yes", R"({"direction":[1,0,0]})"}) CHECK_FALSE(is_meant_as_step(line));
}

TEST_CASE("Told runs: what is no step is refused with the reason", "[steps]") {
  const auto check_fails = [](const std::string& line, const std::string& words) {
    INFO(line);
    CHECK_THROWS_WITH(read_step(line), kit::contains(words));
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
}

}  // namespace told_run_test
}  // namespace walkthroughs::steps
