#include "tests/study/corpus/corpus.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/certificates.hpp"
#include "tests/study/corpus/published.hpp"
#include "tests/study/corpus/shown.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/oracle.hpp"
#include "tests/study/truth/proofs.hpp"
#include "tests/walkthroughs/support.hpp"

namespace study {
namespace corpus_test {

using Json = nlohmann::json;

/// GJKSTEP_CORPUS is the file that is kept.
const std::string& kept() {
  static const std::string text = walkthroughs::test::bytes_of(GJKSTEP_CORPUS);
  return text;
}

std::vector<Json> kept_lines() {
  std::vector<Json> all;
  std::istringstream stream(kept());
  for (std::string line; std::getline(stream, line);) all.push_back(Json::parse(line));
  return all;
}

Vec vec_in(const Json& list) { return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()}; }

Body body_in(const Json& object) {
  if (object.contains("points")) {
    Points points;
    for (const Json& p : object["points"]) points.push_back(vec_in(p));
    return points;
  }
  if (object.contains("sphere"))
    return Ball{vec_in(object["sphere"]["center"]), object["sphere"]["radius"].get<double>()};
  const Json& can = object.at("cylinder");
  return Can{vec_in(can["center"]), vec_in(can["axis"]), can["radius"].get<double>(), can["height"].get<double>()};
}

Pair pair_in(const Json& line) { return {body_in(line["a"]), body_in(line["b"])}; }

RationalVec rational_in(const Json& list) {
  return {Rational(list.at(0).get<std::string>()), Rational(list.at(1).get<std::string>()),
          Rational(list.at(2).get<std::string>())};
}

bool is_of_points(const Pair& pair) { return std::holds_alternative<Points>(pair.a); }

TEST_CASE("Corpus: the kept file is what its command makes, and no larger than 200 KB", "[corpus][unsanitized]") {
  std::string made;
  for (const NamedPair& each : kept_corpus()) made += answered_line(answered(each)) + "\n";
  INFO("to accept it: gjkstep-study pairs --corpus > tests/study/corpus.jsonl");
  CHECK(made == kept());
  CHECK(kept().size() <= 200'000);
}

TEST_CASE("Corpus: the oracle says of every pair what the file says, and each answer has its proof", "[corpus]") {
  std::set<std::string> names;
  for (const Json& line : kept_lines()) {
    INFO(line["name"]);
    const Pair pair = pair_in(line);
    const Json &answer = line["answer"], &certificate = answer["certificate"];
    const bool meet = truth(pair) == Truth::intersecting;
    REQUIRE(answer["status"] == (meet ? "intersecting" : "separated"));
    REQUIRE(names.insert(line["name"].get<std::string>()).second);
    if (meet != certificate.contains("point")) FAIL("an answer with the proof of another");
    if (meet)
      REQUIRE(
          (contains(pair.a, rational_in(certificate["point"])) && contains(pair.b, rational_in(certificate["point"]))));
    else
      REQUIRE(separates(rational_in(certificate["direction"]), pair));
    if (is_of_points(pair))
      REQUIRE(kit::is_proven(answer, kit::set_in<double>(line["a"]), kit::set_in<double>(line["b"])));
  }
  REQUIRE(names.size() > 440);
}

TEST_CASE("Corpus: notes tell who only touches, and whom rounding to floats changes", "[corpus]") {
  std::map<std::string, int> count;
  for (const Json& line : kept_lines()) {
    INFO(line["name"]);
    const Pair pair = pair_in(line);
    const auto notes = line.value("notes", std::vector<std::string>{});
    for (const std::string& note : notes) ++count[note];
    const bool touching = std::ranges::count(notes, "touching") == 1;
    REQUIRE(touching == (truth(pair) == Truth::intersecting && only_touch(pair)));
  }
  CHECK(count["touching"] > 100);
  CHECK(count["rounded to floats: separated"] > 5);
  CHECK(count["rounded to floats: intersecting"] > 5);
  CHECK(count["floats have no room"] > 5);
  CHECK(count.size() == 4);
}

TEST_CASE("Corpus: every mistake fails on three pairs or more that the report's algorithm answers rightly",
          "[corpus]") {
  std::vector<int> fails(mistakes().size());
  int sound_fails = 0, eager_fails = 0;
  for (const Json& line : kept_lines()) {
    const Pair pair = pair_in(line);
    if (!is_of_points(pair)) continue;
    const Shown shown = shown_by(pair);
    sound_fails += shown.sound_fails;
    for (std::size_t i = 0; i < fails.size(); ++i) fails[i] += shown.by_mistake[i];
    const Run eager = mistakes()[1].ask(gjk::PointSet<double>(std::get<Points>(pair.a)),
                                        gjk::PointSet<double>(std::get<Points>(pair.b)));
    eager_fails += (eager.status == gjk::Status::intersecting) != (truth(pair) == Truth::intersecting);
  }
  for (std::size_t i = 0; i < fails.size(); ++i) {
    INFO(mistakes()[i].name);
    if (i == 1)  // which is none: it finds a proof earlier, and fails only where the report's algorithm does
      CHECK((fails[i] == 0 && eager_fails >= 3));
    else
      CHECK(fails[i] >= 3);
  }
  CHECK(sound_fails >= 10);
}

// Along +x the first P·d is the difference of two numbers, whose sign is exact however it rounds; where it is negative the sets are apart.
TEST_CASE("Corpus: M2, begun along an axis, is wrong on no pair that the report's algorithm answers rightly",
          "[corpus]") {
  int asked = 0;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(family.size.value_or(200), 200); ++i) {
      const Pair pair = family.make(3, i);
      if (!is_of_points(pair)) break;
      INFO(family.name << ", pair " << i);
      CHECK_FALSE(shows(pair, 1));
      ++asked;
    }
  CHECK(asked > 4000);
}

TEST_CASE("Corpus: every family is in it, and at least ten published failures with their threads", "[corpus]") {
  std::map<std::string, int> count;
  for (const Json& line : kept_lines()) {
    ++count[line["family"].get<std::string>()];
    CHECK((line["family"] == "published") == line.contains("source"));
    if (line.contains("source")) CHECK(line["source"].get<std::string>().starts_with("https://"));
  }
  for (const Family& family : families()) CHECK(count[family.name] > 0);
  CHECK(count["published"] == static_cast<int>(published_failures().size()));
  CHECK(count["published"] >= 10);
  CHECK(count["smallest"] > 100);
  const auto readme = walkthroughs::test::bytes_of(GJKSTEP_STUDY_README);
  CHECK(readme.find(std::to_string(kept_lines().size()) + " pairs that show") != std::string::npos);
  CHECK(readme.find(std::to_string(count["published"]) + " failures of other libraries") != std::string::npos);
}

TEST_CASE("Corpus: a pair has its line, its answer and its notes by hand", "[corpus]") {
  CHECK(answered_line(answered({"touch", "mine", {Points{{0, 0, 0}, {2, 0, -0.0}}, Points{{1, 0, 0}}}, "https://x"})) ==
        R"({"name":"touch","family":"mine","a":{"points":[[0,0,0],[2,0,0]]},"b":{"points":[[1,0,0]]},)"
        R"("answer":{"status":"intersecting","certificate":{"simplex":[[1,0],[0,0]],"weights":["1/2","1/2"],)"
        R"("point":["1","0","0"]}},"notes":["touching"],"source":"https://x"})");
  CHECK(answered_line(answered({"balls", "mine", {Ball{{0, 0, 0}, 1}, Ball{{3, 0, 0}, 1}}})) ==
        R"({"name":"balls","family":"mine","a":{"sphere":{"center":[0,0,0],"radius":1}},)"
        R"("b":{"sphere":{"center":[3,0,0],"radius":1}},)"
        R"("answer":{"status":"separated","certificate":{"direction":["1","0","0"]}}})");
  CHECK(question_line({Points{{0.1, 0, 1e100}}, Points{{1, 0, 0}}}) ==
        R"({"a":{"points":[[0.1,0,1e+100]]},"b":{"points":[[1,0,0]]}})");
}

}  // namespace corpus_test
}  // namespace study
