#include "walkthroughs/judge/answer.hpp"

#include "tests/kit/catch.hpp"

namespace walkthroughs::judge {
namespace answer_test {

const Pair apart{Points{{0, 0, 0}, {1, 0, 0}}, Points{{2, 0, 0}, {2, 1, 0}}};
const Pair meeting{Points{{0, 0, 0}, {2, 0, 0}}, Points{{1, 0, 0}, {5, 5, 0}}};

Said said(const std::string& line) { return read_answer(line, apart).said; }

Evidence evidence(const std::string& line, const Pair& pair) { return read_answer(line, pair).evidence; }

TEST_CASE("Answers: a word, a distance or an object with a status is one, and everything else is not") {
  for (const char* const line : {"yes", "true", " True\r", "YES", "\"intersecting\"", "distance 0", "distance -0.5",
                                 R"({"status":"intersecting"})", R"({"status":true})", R"({"distance":0})"})
    CHECK(said(line) == Said::intersecting);
  for (const char* const line : {"no", "false", "\"separated\"", "distance 1e-300", R"({"distance":2})",
                                 R"({"iterations":3,"status":"separated","x":[[[]]]})"})
    CHECK(said(line) == Said::separated);
  for (const char* const line : {"undecided", R"({"status":"undecided"})"}) CHECK(said(line) == Said::undecided);
  for (const char* const line : {"nan", "-NaN", "inf", "distance nan", "distance inf"})
    CHECK(said(line) == Said::not_a_number);
  for (const char* const line : {"", "   ", "1", "0", "null", "[true]", "true false", "yes.", "distance",
                                 "distance 1 2", "distance x", "\xff\xfe", "0.25"}) {
    INFO(line);
    CHECK_FALSE(is_meant_as_answer(line));
    CHECK(said(line) == Said::nothing);
  }
  for (const char* const line : {"{}", R"({"status":"maybe"})", R"({"status":1})", "{\"status\"",
                                 R"({"status":"separated","status":"intersecting"})", R"({"error":"too hard"})"}) {
    INFO(line);
    CHECK(is_meant_as_answer(line));
    const ProgramAnswer answer = read_answer(line, apart);
    CHECK(answer.said == Said::nothing);
    CHECK_FALSE(answer.why.empty());
  }
  CHECK(read_answer(std::string(100000, '['), apart).said == Said::nothing);
  CHECK(read_answer(R"({"error":"too hard","line":7})", apart).why == "too hard");
  for (const char* const line : {"distance 0.25", R"({"distance":0.25})", R"({"status":"separated","distance":0.25})"})
    CHECK(read_answer(line, apart).distance == 0.25);
  CHECK_FALSE(read_answer(R"({"status":"separated","distance":"far"})", apart).distance);
}

TEST_CASE("Answers: a direction is evidence where all of a lies before all of b, wherever it is written") {
  for (const char* const place :
       {R"({"status":"separated","direction":%})", R"({"status":false,"evidence":{"direction":%}})",
        R"({"status":"separated","certificate":{"direction":%}})"}) {
    const auto with = [place](const std::string& direction) {
      std::string line = place;
      return evidence(line.replace(line.find('%'), 1, direction), apart);
    };
    CHECK(with("[1,0,0]") == Evidence::holds);
    CHECK(with(R"(["1/3","0","-1/10000"])") == Evidence::holds);
    CHECK(with("[-1,0,0]") == Evidence::proves_nothing);
    CHECK(with("[0,0,0]") == Evidence::proves_nothing);
    for (const char* const bad : {"[1,0]", "7", R"(["inf","0","0"])", R"(["1/0","0","0"])", R"(["1.5","0","0"])",
                                  R"(["1/-1","0","0"])", R"(["","0","0"])", "[[1],0,0]", "null"})
      CHECK(with(bad) == Evidence::proves_nothing);
    CHECK(with("[\"" + std::string(5000, '9') + "\",\"0\",\"0\"]") == Evidence::proves_nothing);
  }
  CHECK(evidence("false", apart) == Evidence::none);
  CHECK(evidence(R"({"status":"intersecting","direction":[1,0,0]})", apart) == Evidence::none);
}

TEST_CASE("Answers: the indices of the nearest points are evidence as gjkstep query --certified means them") {
  CHECK(evidence(R"({"status":"separated","certificate":{"nearest":[[1,0]]}})", apart) == Evidence::holds);
  CHECK(evidence(R"({"status":"separated","certificate":{"nearest":[[1,0],[0,0]]}})", apart) ==
        Evidence::proves_nothing);
  CHECK(evidence(R"({"status":"separated","certificate":{"nearest":[[7,0]]}})", apart) == Evidence::proves_nothing);
}

TEST_CASE("Answers: a simplex is evidence where the origin is in its hull, also where it is flat") {
  const auto with = [](const std::string& simplex) {
    return evidence(R"({"status":"intersecting","simplex":)" + simplex + "}", meeting);
  };
  CHECK(with("[[0,0],[1,0]]") == Evidence::holds);
  CHECK(with("[[0,0],[1,0],[0,0]]") == Evidence::holds);  // the same point twice
  CHECK(with(R"([{"a_index":1,"b_index":0},{"a_index":0,"b_index":0,"w":[9,9,9]}])") == Evidence::holds);
  CHECK(with("[[0,0]]") == Evidence::proves_nothing);
  for (const char* const bad :
       {"[]", "[[0,0],[1,0],[0,1],[1,1],[0,0]]", "[[0]]", "[[0,-1]]", "[[0.5,0]]", "[[0,9]]", "{}"})
    CHECK(with(bad) == Evidence::proves_nothing);
}

TEST_CASE("Answers: of round bodies nothing is looked at") {
  const Pair balls{Ball{{0, 0, 0}, 1}, Ball{{1.5, 0, 0}, 1}};
  CHECK(evidence(R"({"status":true,"simplex":[[0,0]]})", balls) == Evidence::none);
}

}  // namespace answer_test
}  // namespace walkthroughs::judge
