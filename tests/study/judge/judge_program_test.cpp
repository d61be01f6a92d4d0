#include "tests/study/judge/judge_program.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "tests/kit/catch.hpp"
#include "tests/study/judge/judged_scenes.hpp"
#include "tests/study/judge/judged_text.hpp"
#include "tests/study/judge/pairs_file.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/sweep/plan.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

std::vector<NamedPair> corpus_of_points() {
  std::vector<NamedPair> all = kept_pairs();
  std::erase_if(all, [](const NamedPair& each) { return !std::holds_alternative<Points>(each.pair.a); });
  return all;
}

/// The limit is for programs that answer: however busy the machine is, they are in time.
ProgramJudged judged(const std::vector<std::string>& words, const std::vector<NamedPair>& pairs = corpus_of_points(),
                     std::chrono::milliseconds limit = std::chrono::seconds(60)) {
  return judge_program({.words = words, .limit = limit}, pairs);
}

/// The implementation of the report with that mistake; 0: without one.
ProgramJudged judged_mistake(std::size_t number) {
  return judged({"env", "GJKSTEP_MISTAKE=" + std::to_string(number), JUDGED_MISTAKE});
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string told(const ProgramJudged& judged) {
  return judged_markdown(judged, {.program = "it", .command = "judge it"});
}

TEST_CASE("Judge: of the study's mistakes, as programs, each that shows is named first", "[judge][unsanitized]") {
  std::size_t named = 0;
  for (std::size_t m = 0; m < mistakes().size(); ++m) {
    INFO(mistakes()[m].name);
    const ProgramJudged found = judged_mistake(m + 1);
    CHECK_FALSE(found.is_good());
    REQUIRE_FALSE(found.resemblances.empty());
    const bool is_first = found.resemblances.front().mistake == m && found.resemblances.front().share() == 1;
    named += is_first;
    if (is_first)
      CHECK(has(told(found), "It behaves like M" + std::to_string(m + 1) + " ("));
    else  // it is right wherever the report's algorithm is
      CHECK((m == 1 && found.resemblances.front().sound_in));
  }
  CHECK(named >= 18);
}

const std::string only_rounding = "Nothing but rounding and cycles need be wrong with it: in doubles they explain all";
const std::string not_rounding = "Rounding and cycles do not explain all of it: in doubles ";

TEST_CASE("Judge: without a mistake only rounding and cycles are found, and told as that", "[judge]") {
  const ProgramJudged found = judged_mistake(0);
  CHECK(found.resemblances.front().sound_in == Numbers::doubles);
  CHECK(found.rounding.wrong > 20);
  CHECK(found.rounding.in_doubles == found.rounding.wrong);
  CHECK(has(told(found), "It answers most like the report's algorithm in doubles (without a mistake)"));
  CHECK(has(told(found), only_rounding));
}

TEST_CASE("Judge: somebody else's sound search in doubles is told as that on hard families", "[judge]") {
  std::vector<NamedPair> pairs;
  for (const Family* const family : families_called({"touching-vertex-askew", "touching-face-askew", "cycles",
                                                     "near-parallel-edges", "one-ulp-askew", "flat-1e-9-turned"}))
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(200, family->size.value_or(200)); ++i)
      pairs.push_back({family->name, family->name, family->make(1, i)});
  const ProgramJudged found = judged({JUDGED_SOUND_GJK}, pairs);
  CHECK(found.rounding.wrong > 30);
  CHECK(has(told(found), only_rounding));
}

TEST_CASE("Judge: a limit of iterations and a tolerance are laid neither to rounding nor to a mistake", "[judge]") {
  const auto check_told = [](const std::vector<std::string>& words) {
    const ProgramJudged found = judged(words);
    INFO(told(found));
    CHECK(has(told(found), not_rounding));
    CHECK(has(told(found), "a limit of iterations, or a tolerance, is not among the mistakes, and may be the reason"));
    CHECK_FALSE(has(told(found), "It behaves like"));
    CHECK_FALSE(has(told(found), only_rounding));
  };
  for (const std::string limit : {"4", "5", "6"}) check_told({"env", "JUDGED_LIMIT=" + limit, JUDGED_LIMITED});
  for (const std::string tolerance : {"1e-2", "1e-5", "1e-8"})
    check_told({"env", "JUDGED_TOLERANCE=" + tolerance, JUDGED_TOLERANT});
}

TEST_CASE("Judge: no mistake is named for fewer than three wrong pairs", "[judge]") {
  ProgramJudged found;
  found.all.counts[static_cast<std::size_t>(Verdict::wrong_no)] = 9;
  found.resemblances = {{.mistake = 12U, .name = "M13", .both = 2, .either = 2}};
  CHECK(has(told(found), "Too few pairs to name a mistake; the nearest is M13: 2 pairs in common"));
  found.resemblances[0].both = found.resemblances[0].either = 3;
  CHECK(has(told(found), "It behaves like M13: 3 pairs in common"));
}

TEST_CASE("Judge: it is told of how many failing families the first have their wrong step", "[judge]") {
  ProgramJudged found;
  const Pair pair{Points{{0, 0, 0}}, Points{{5, 0, 0}}};
  for (const char* const family : {"f", "f", "g", "h"})
    found.pairs.push_back({.named = {"p", family, pair}, .verdict = Verdict::wrong_yes});
  found.pairs.push_back(
      {.named = {"q", "round", {Ball{{0, 0, 0}, 1}, Ball{{0, 0, 0}, 1}}}, .verdict = Verdict::wrong_no});
  found.steps = {{.pair = "p", .iteration = 1, .words = "it is wrong"}};
  CHECK(has(told(found), "Of 3 families with failures that of the smallest pair is told."));
}

TEST_CASE("Judge: a sound program passes, its evidence with it", "[judge]") {
  const ProgramJudged found = judged({GJKSTEP_ITSELF, "query", "--certified"});
  CHECK(found.is_good());
  CHECK(found.all.of(Verdict::right) == found.all.pairs);
  CHECK(found.all.evidence == found.all.pairs);
  CHECK(found.changes.size() == 7);
  for (const Change& change : found.changes) CHECK(change.asked > 400);
  CHECK(told(found).starts_with("# it: nothing is wrong: " + std::to_string(found.all.pairs) + " pairs\n"));
}

TEST_CASE("Judge: an implementation of somebody else with a mistake is told which", "[judge]") {
  CHECK(judged({JUDGED_WRONG_GJK}).resemblances.front().mistake == 13U);  // M14: the order below the triangle
}

#ifdef JUDGED_LIBCCD
TEST_CASE("Judge: libccd is judged through its adapter", "[judge]") {
  const ProgramJudged found = judged({JUDGED_LIBCCD});
  CHECK(found.all.of(Verdict::right) > 200);
  CHECK(found.all.of(Verdict::wrong_no) > 10);
  CHECK(found.all.of(Verdict::ended) == 0);
}
#endif

TEST_CASE("Judge: Python is judged through its adapter", "[judge]") {
  const ProgramJudged found =
      judged({"sh", "-c", "cd " JUDGE_ADAPTERS " && exec python3 -B judge_main.py boxes_overlap"});
  CHECK(found.all.of(Verdict::wrong_no) == 0);  // whoever meets has boxes that meet
  CHECK(found.all.of(Verdict::wrong_yes) > 10);
  CHECK(found.all.of(Verdict::undecided) == 0);
}

TEST_CASE("Judge: Python tells its steps where they are asked for, and only there", "[judge]") {
  const walkthroughs::test::Folder folder;
  std::ofstream(folder.path() / "stepping.py") << "from judge_main import step\n"
                                                  "def collide(a, b):\n"
                                                  "    step((1, 0, 0), [a[0]])\n"
                                                  "    return True\n";
  const std::string question = R"({"a":{"points":[[1,2,3]]},"b":{"points":[[0,0,0]]}})";
  const auto lines = [&](const std::string& wanted) {
    const std::string script =
        "cd " + folder.path().string() + " && " + wanted + " exec python3 -B " JUDGE_ADAPTERS "/judge_main.py stepping";
    return run_program({"sh", "-c", script}, std::vector{question}, std::chrono::seconds(60), 2).lines;
  };
  CHECK(lines("") == std::vector<std::string>{"true"});
  CHECK(lines("export JUDGE_STEPS=1;") ==
        std::vector<std::string>{R"({"direction": [1.0, 0.0, 0.0], "simplex": [[1.0, 2.0, 3.0]]})", "true"});
}

TEST_CASE("Judge: a program that always says yes is told as that, and so is no", "[judge]") {
  for (const auto& [script, words] : {std::pair<std::string, std::string>{"sed s/.*/true/", "always says yes"},
                                      {"sed s/.*/false/", "always says no"}}) {
    const ProgramJudged found = judged({"sh", "-c", script});
    CHECK(has(told(found), "It behaves like a program that " + words));
  }
}

TEST_CASE("Judge: what is no right answer is told apart", "[judge]") {
  const std::vector<NamedPair> pairs{{"p0", "apart", {Points{{0, 0, 0}}, Points{{5, 0, 0}}}},
                                     {"p1", "apart", {Points{{0, 0, 0}}, Points{{0, 5, 0}}}},
                                     {"p2", "meet", {Points{{0, 0, 0}}, Points{{0, 0, 0}}}},
                                     {"p3", "meet", {Points{{1, 0, 0}}, Points{{1, 0, 0}}}}};
  const std::string before = "while read x; do case $x in *'[[5,0,0]]'*) ";
  const std::string after = ";; *'[[0,5,0]]'*) echo false;; *) echo true;; esac; done";
  const auto first_says = [&](const std::string& first) { return judged({"sh", "-c", before + first + after}, pairs); };
  const auto verdict = [&](const std::string& first) { return first_says(first).pairs[0].verdict; };
  CHECK(verdict("echo false") == Verdict::right);
  CHECK(verdict("echo true") == Verdict::wrong_yes);
  CHECK(verdict("echo '\"undecided\"'") == Verdict::undecided);
  CHECK(verdict("echo garbage") == Verdict::unreadable);
  CHECK(verdict("exit 1") == Verdict::ended);
  CHECK(verdict("kill -SEGV $$") == Verdict::ended);
  const std::vector<std::string> late{"sh", "-c", before + "sleep 100" + after};
  CHECK(judged(late, pairs, std::chrono::seconds(2)).pairs[0].verdict == Verdict::late);
  const ProgramJudged false_evidence = first_says("echo '{\"status\":\"separated\",\"direction\":[-1,0,0]}'");
  CHECK((false_evidence.pairs[0].verdict == Verdict::right && false_evidence.pairs[0].false_evidence));
  CHECK(false_evidence.all.false_evidence == 1);
  CHECK_FALSE(false_evidence.is_good());
  CHECK(has(told(false_evidence), "something is wrong: 4 pairs; 1 right answer has evidence that proves nothing"));
  CHECK(false_evidence.families[0].wrong.count == 0);
  CHECK(false_evidence.families[0].wrong.trials == 2);
  CHECK(has(told(first_says("exit 9")), "First pair without an answer: p0: exit code 9."));
  CHECK(first_says("echo '\"undecided\"'").all.wrong.count == 0);
}

TEST_CASE("Judge: who hangs now and then, whichever the pair, is not called good", "[judge]") {
  const std::vector<NamedPair> pairs(12, {"p", "f", {Points{{0, 0, 0}}, Points{{5, 0, 0}}}});
  const ProgramJudged found =
      judged({"sh", "-c", "n=0; while read x; do n=$((n+1)); [ $n = 4 ] && sleep 100; echo false; done"}, pairs,
             std::chrono::milliseconds(300));
  CHECK(found.all.wrong.count == 0);
  CHECK_FALSE(found.is_good());
  CHECK(has(told(found), "It was too late "));
  CHECK(has(told(found), "the first time after 3 answers of a run. If it keeps answers back, let it flush"));
}

TEST_CASE("Judge: an answer that changes where nothing may is found without any truth", "[judge]") {
  const std::vector<NamedPair> pairs{{"p", "f", {Points{{0, 0, 0}, {1, 0, 0}}, Points{{0, 0, 0}, {0, 1, 0}}}}};
  // Right about this pair, and wrong once B comes first.
  const ProgramJudged found = judged({"sh", "-c",
                                      "while read x; do case $x in '{\"a\":{\"points\":[[0,0,0],[1,0,0]]}'*) echo "
                                      "true;; *) echo false;; esac; done"},
                                     pairs);
  CHECK(found.all.of(Verdict::right) == 1);
  CHECK_FALSE(found.is_good());
  CHECK(found.changes[0].what == "A and B exchanged");
  CHECK(found.changes[0].other_answers == 1);
  CHECK(found.changes[0].first == "p");
  CHECK(found.changes[6].other_answers == 0);  // A with itself
  const std::vector<JudgedScene> scenes = judged_scenes(found, "sh", 1);
  const auto has_changed = [](const Change& change) { return change.other_answers > 0; };
  REQUIRE(static_cast<std::ptrdiff_t>(scenes.size()) == std::ranges::count_if(found.changes, has_changed));
  CHECK(scenes[0].name == "other-answer--A-and-B-exchanged-p.json");
  const Pair exchanged{pairs[0].pair.b, pairs[0].pair.a};
  CHECK(scenes[0].text.find(question_line(exchanged).substr(1)) != std::string::npos);
  CHECK_NOTHROW(walkthroughs::text::parse_scene(scenes[0].text, scenes[0].name));
}

TEST_CASE("Judge: a no to a set and itself is told as a wrong no", "[judge]") {
  const std::vector<NamedPair> pairs{{"p", "f", {Points{{0, 0, 0}}, Points{{5, 0, 0}}}},
                                     {"q", "f", {Points{{0, 0, 0}}, Points{{0, 5, 0}}}}};
  const ProgramJudged found = judged({"sed", "s/.*/false/"}, pairs);
  CHECK(found.changes[6].wrong_no == 2);
  CHECK(has(told(found), "# it: something is wrong: 2 pairs; 2 wrong no's of a set with itself\n"));
  CHECK(has(told(found), "of the last line 2 answers are wrong no's."));
}

TEST_CASE("Judge: failures become scenes that can be read, those of others' names, too", "[judge]") {
  const std::vector<NamedPair> pairs{{"../../a \"b\"\n", "f", {Points{{0, 0, 0}}, Points{{5, 0, 0}}}},
                                     {"large", "f", {Points{{1e200, 0, 0}}, Points{{5, 0, 0}}}},
                                     {"balls", "g", {Ball{{0, 0, 0}, 1}, Ball{{9, 0, 0}, 1}}}};
  const std::vector<JudgedScene> scenes = judged_scenes(judged({"sed", "s/.*/true/"}, pairs), "sed\n", 5);
  REQUIRE(scenes.size() == 2);
  CHECK(scenes[0].name == "wrong-yes-..-..-a--b--.json");
  for (const JudgedScene& scene : scenes) CHECK_NOTHROW(walkthroughs::text::parse_scene(scene.text, scene.name));
  CHECK(judged_scenes(judged({"sed", "s/.*/true/"}, pairs), "sed", 0).empty());
}

TEST_CASE("Judge: pairs of others are read as gjkstep query reads them, and bad ones named by their line", "[judge]") {
  const std::string good = R"({"a":{"points":[[0,0]]},"b":{"points":[[1,0,0]]}})";
  const auto pairs =
      read_pairs(good + "\r\n" + R"({"name":"n","family":"f","a":{"sphere":{"center":[0,0,0],"radius":1}},)" +
                     R"("b":{"sphere":{"center":[3,0,0],"radius":1}}})" + "\n",
                 "mine");
  REQUIRE(pairs.size() == 2);
  CHECK((pairs[0].name == "line-1" && pairs[0].family == "yours" && pairs[1].name == "n" && pairs[1].family == "f"));
  const auto check_fails = [&](const std::string& line, const std::string& words) {
    INFO(line);
    CHECK_THROWS_WITH(read_pairs(good + "\n" + line, "mine"), kit::contains("mine:2: ") && kit::contains(words));
  };
  check_fails("{", "");
  check_fails(" ", "blank");
  check_fails(R"({"a":{"points":[[0,0,0]],"pose":{"translation":[1,0,0]}},"b":{"points":[[0,0,0]]}})",
              "a.pose: is not judged");
  check_fails(R"({"a":{"sum":[{"points":[[0,0,0]]},{"points":[[0,0,0]]}]},"b":{"points":[[0,0,0]]}})", "a: is a sum");
  check_fails(R"({"a":{"sphere":{"center":[0,0,0],"radius":1}},"b":{"points":[[0,0,0]]}})", "cannot judge");
  CHECK_THROWS_WITH(read_pairs("", "mine"), kit::contains("holds no pair"));
  CHECK(kept_pairs().size() > 440);
}

}  // namespace
}  // namespace study
