/// gjkstep-study judge and check-steps as their users run them.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/study/program/run_study.hpp"

namespace study::test {
namespace {

const std::string wrong_gjk = quoted(JUDGED_WRONG_GJK), certified = quoted(kit::program()) + " query --certified",
                  always_yes = "sed s/.*/true/";

/// Checks that these parts are there, in this order.
void check_order(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    INFO(part);
    at = text.find(part, at);
    REQUIRE(at != std::string::npos);
  }
}

TEST_CASE("judge: a sound program ends with 0, a wrong one with 1 and what is wrong", "[judge]") {
  const Outcome sound = run("judge -- " + certified);
  INFO(sound.err);
  CHECK(sound.exit_code == 0);
  CHECK(has(sound.out, "query --certified: nothing is wrong: "));
  CHECK(has(sound.err, "(100 %)"));
  const Outcome wrong = run("judge -- " + wrong_gjk);
  CHECK(wrong.exit_code == 1);
  CHECK(has(wrong.out, "* It behaves like M14 (the order is not changed when moving below the triangle): "));
  CHECK(has(wrong.out, "## Asked again after what must not change the answer"));
  CHECK(has(wrong.err, "gjkstep-study: " + std::string(JUDGED_WRONG_GJK) + ": wrong: "));
}

TEST_CASE("judge: families are asked with intervals, and the same seed makes the same pairs", "[judge]") {
  const std::string command = "judge --families triangles,spheres --count 50 --seed 3 -- " + quoted(kit::program()) +
                              " query --rules as-printed";
  const Outcome one = run(command);
  CHECK(one.exit_code == 1);
  CHECK(has(one.out, "wrong, with the 95 % interval"));
  CHECK(has(one.out, "| all | 100 |"));
  CHECK(has(one.out, "made by: `gjkstep-study judge --families triangles,spheres --count 50 --seed 3 -- "));
  CHECK(run(command).out == one.out);
}

TEST_CASE("judge: JSON says the same, with every pair that is not right", "[judge]") {
  const Outcome outcome = run("judge --json -- " + always_yes);
  CHECK(outcome.exit_code == 1);
  const auto said = nlohmann::json::parse(outcome.out);
  CHECK(said["good"] == false);
  CHECK(said["all"]["wrong_yes"] == said["not_right"].size());
  CHECK(said["not_right"][0]["verdict"] == "wrong_yes");
  CHECK(said["not_right"][0]["truth"] == "separated");
  CHECK(said["mistakes"][0]["name"] == "a program that always says yes");
  CHECK(said["changes"].size() == 7);
  CHECK(said["families"].size() > 40);
  CHECK_FALSE(said.contains("steps"));
}

TEST_CASE("judge: what gjkstep-study pairs writes is judged, and pairs that are none are named", "[judge]") {
  const Folder folder;
  const std::string pairs = in(folder, "pairs.jsonl");
  write(folder / "pairs.jsonl", run("pairs --families boxes,cylinders --count 4").out);
  write(folder / "bad.jsonl", "{\"a\":{\"points\":[[0,0,0]]}}\n");
  const Outcome outcome = run("judge --pairs " + pairs + " -- " + quoted(kit::program()) + " query");
  CHECK(has(outcome.out, "of 8 pairs") != has(outcome.out, "wrong: 8 pairs"));
  check_failure("judge --pairs " + in(folder, "bad.jsonl") + " -- cat", 3, {"bad.jsonl:1: ", "b"});
  check_failure("judge --pairs " + in(folder, "nowhere") + " -- cat", 3, {"cannot read ", "nowhere: "});
  check_failure("judge --pairs " + pairs + " --count 3 -- cat", 2, {"--count"});
}

TEST_CASE("judge: failures are saved as scenes that gjkstep render draws", "[judge]") {
  const Folder folder;
  const Outcome outcome = run("judge --save-failures " + in(folder, "wrong") + " --max-failures 1 -- " + wrong_gjk);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, " scene files; gjkstep render draws them"));
  const std::vector<std::string> files = listing(folder / "wrong");
  REQUIRE(files.size() > 5);
  CHECK(std::ranges::count(files, "wrong-no-m14-1.json") == 1);
  CHECK(kit::shell(quoted(kit::program()) + " render " + in(folder, "wrong/" + files.front()) +
                   " --size 160x90 --out " + in(folder, "pictures"))
            .exit_code == 0);
  CHECK_FALSE(listing(folder / "pictures").empty());
}

TEST_CASE("judge: nothing that it writes lies over what it reads, or over what else it writes", "[judge]") {
  const Folder folder;
  const std::filesystem::path mine = write(folder / "f/mine.json", "mine");
  for (const std::string& arguments : {"--pairs " + quoted(mine) + " --save-failures " + in(folder, "f"),
                                       "--html " + in(folder, "f/x.json") + " --save-failures " + in(folder, "f"),
                                       "--html " + in(folder, "g") + " --save-failures " + in(folder, "g")})
    check_failure("judge " + arguments + " -- cat", 2, {"have the same place", "another place"});
  CHECK(bytes_of(mine) == "mine");
}

TEST_CASE("judge: the recipe says what happens", "[judge]") {
  const std::string recipe = bytes_of(JUDGE_ADAPTERS "/../README.md"), code = bytes_of(JUDGE_ADAPTERS "/wrong_gjk.cpp"),
                    out = run("judge -- " + wrong_gjk).out;
  const std::string verdict = lines(out).at(0).substr(2 + std::string(JUDGED_WRONG_GJK).size());
  CHECK(has(recipe, "# ./wrong_gjk" + verdict + "\n"));
  CHECK(has(recipe, "[a GJK of " + std::to_string(lines(code).size()) + " lines]"));
  const std::string sentence = lines(out).at(2);
  CHECK(has(recipe, sentence.substr(0, sentence.find(';')) + "; …\n"));
  const auto line = recipe.find("  if (dot(n, AO) < 0) return s = {C, B, A}, -n;");
  CHECK(has(code, recipe.substr(line, recipe.find(';', line) - line)));
  const auto doubles = run("judge --json -- " + quoted(kit::program()) + " query");
  const auto all = nlohmann::json::parse(doubles.out)["all"];
  const int wrong = all["wrong_yes"].get<int>() + all["wrong_no"].get<int>(), unproved = all["false_evidence"];
  CHECK(has(recipe, "in doubles is wrong on " + std::to_string(wrong) + " of these pairs. " + std::to_string(unproved) +
                        " of its right answers have evidence that proves nothing"));
}

/// Writes the steps of the wrong GJK on a pair of the corpus, as a file. `together`: read and told through one pipe.
std::string steps_of(const Folder& folder, const std::string& pair) {
  const std::string steps = in(folder, "steps.jsonl");
  REQUIRE(kit::shell("grep '\"" + pair + "\"' " + quoted(kit::source("tests/study/corpus.jsonl")) + " >" + steps +
                     " && JUDGE_STEPS=1 " + wrong_gjk + " <" + steps + " >" + steps + ".told && cat " + steps +
                     ".told >>" + steps)
              .exit_code == 0);
  return steps;
}

TEST_CASE("check-steps: the recipe's search has its wrong step named, and drawn", "[judge]") {
  const Folder folder;
  const std::string steps = steps_of(folder, "m14-1");
  const Outcome outcome = run("check-steps " + steps);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, "steps.jsonl: 1 of 1 search has a wrong step"));
  const std::string recipe = bytes_of(JUDGE_ADAPTERS "/../README.md");
  for (const std::string& line : lines(outcome.out)) CHECK(has(recipe, line + "\n"));
  CHECK(lines(outcome.out).size() == 2);
  const Outcome piped = run("check-steps - <" + steps);
  CHECK(piped.out == outcome.out);
  CHECK(has(piped.err, "standard input: 1 of 1 search has a wrong step"));
  const Outcome drawn = run("check-steps " + steps + " --draw " + in(folder, "pictures"));
  CHECK(lines(drawn.out).size() == 2 + listing(folder / "pictures").size());
  CHECK(std::filesystem::exists(folder / "pictures/mistakes/m14-order-below-triangle/014.png"));
  const std::filesystem::path over = folder / "pictures/mistakes/m14-order-below-triangle/000.png";
  std::filesystem::copy_file(folder / "steps.jsonl", over, std::filesystem::copy_options::overwrite_existing);
  const Outcome refused = run("check-steps " + quoted(over) + " --draw " + in(folder, "pictures"));
  CHECK(refused.exit_code == 2);
  CHECK(has(refused.err, "the pictures of --draw have the same place"));
  CHECK(bytes_of(over) == bytes_of(folder / "steps.jsonl"));
  check_failure("check-steps " + steps + " --draw ''", 2, {"--draw '': name a folder"});
  check_failure("check-steps " + steps + " --draw /dev/null/x", 5, {"/dev/null/x"});
}

TEST_CASE("check-steps: who tells steps at their end is not blamed for a no that follows from them", "[judge]") {
  // A right one; and one in a direction that rounds, and is not told.
  for (const std::string name : {"m4-1", "touching-edge-askew-37"}) {
    const Folder folder;
    const std::string steps = steps_of(folder, name);
    REQUIRE(has(bytes_of(folder / "steps.jsonl"), "\nfalse\n"));
    const Outcome outcome = run("check-steps " + steps);
    CHECK(outcome.exit_code == 0);
    CHECK(has(outcome.out, name + ": every step is one that the report's algorithm may make"));
  }
}

TEST_CASE("check-steps: a file without any step is refused, a search without is told, and what rounding may explain",
          "[judge]") {
  const Folder folder;
  const std::string pair = R"({"a":{"points":[[0,0,0]]},"b":{"points":[[0,0,3]]}})",
                    step = R"({"direction":[1,0,0],"simplex":[[0,0,-3]]})";
  write(folder / "none", pair + "\nfalse\n");
  check_failure("check-steps " + in(folder, "none"), 3, {"none: no search tells a step"});
  write(folder / "one", pair + "\nfalse\n" + pair + '\n' + step + "\nfalse\n");
  const Outcome outcome = run("check-steps " + in(folder, "one"));
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "line-1: no step is told\nline-3: every step is one"));
  write(folder / "tiny", R"({"a":{"points":[[0,0,0],[1e-90,0,0]]},"b":{"points":[[5e-90,1e-90,0],[5e-90,-1e-90,0]]}}
{"direction":[1,0,0],"simplex":[[-4e-90,-1e-90,0]]}
{"direction":[4,1,0],"simplex":[[-4e-90,1e-90,0]]}
{"direction":[1,0,0],"simplex":[[-4e-90,1e-90,0]]}
false
)");
  CHECK(has(run("check-steps " + in(folder, "tiny")).err, "has a wrong step; of 1 rounding may be the reason"));
  write(folder / "bad", "true\n");
  check_failure("check-steps " + in(folder, "bad"), 3, {"bad:1: the first line must be a pair"});
}

TEST_CASE("judge: a page has the verdict, families, steps and pictures in it, and nothing from elsewhere", "[judge]") {
  const Folder folder;
  const Outcome outcome = run("judge --steps --json --html " + in(folder, "page.html") + " -- " + wrong_gjk);
  CHECK(outcome.exit_code == 1);
  const auto steps = nlohmann::json::parse(outcome.out).at("steps");
  REQUIRE(steps.size() == 10);
  const auto third = std::ranges::find(steps, nlohmann::json(3), [](const auto& each) { return each["iteration"]; });
  REQUIRE(third != steps.end());
  CHECK(has((*third)["words"].get<std::string>(), "keeps [C, B, A] where the report keeps [C, A, B]"));
  CHECK((*third)["mistakes"] == nlohmann::json{14});
  const std::string page = bytes_of(folder / "page.html");
  check_order(page, {"wrong: ", "It behaves like M14", "<h2>By family", "<h2>Which mistake answers most alike",
                     "<h2>Asked again after what must not change", "<h2>The first wrong step",
                     "M14: the order is not changed when moving below the triangle", "alt=\"Both searches",
                     "<h2>The first failures", "<img width=\"960\"",
                     "<figcaption>wrong no: m14-1. They have a point in common.</figcaption>"});
  CHECK_FALSE(has(page, "http://"));
  CHECK_FALSE(has(page, "https://"));
  CHECK(run("judge --families boxes --count 3 --html " + in(folder, "sound.html") + " -- " + certified).exit_code == 0);
  CHECK_FALSE(has(bytes_of(folder / "sound.html"), "<img"));
}

TEST_CASE("judge: --steps names the first wrong step of failures, where the program tells its steps", "[judge]") {
  const Outcome wrong = run("judge --steps -- " + wrong_gjk);
  CHECK(wrong.exit_code == 1);
  check_order(wrong.out, {"## The first wrong step", "\n| m14-1 | 3 |",  // small whole numbers come first
                          "keeps [C, B, A] where the report keeps [C, A, B]",
                          "| M14: the order is not changed when moving below the triangle |"});
  CHECK(has(wrong.out, " | – | every step is one"));
  CHECK(has(run("judge --steps -- " + always_yes).out, "| it tells no steps |"));
  CHECK_FALSE(has(run("judge --steps -- " + certified).out, "first wrong step"));
}

TEST_CASE("judge: what cannot be done is told with what to write instead", "[judge]") {
  for (const auto& [arguments, exit_code, said] : std::vector<std::tuple<std::string, int, std::string>>{
           {"judge", 2, "PROGRAM"},
           {"judge -- /nowhere/at/all", 2, "the program '/nowhere/at/all' cannot be started: No such file"},
           {"judge --families boxs -- cat", 2, "did you mean 'boxes'?"},
           {"judge --time-limit 0 -- cat", 2, "expected a number from 0.01 to 3600"},
           {"judge --save-failures '' -- cat", 2, "--save-failures '': name a folder"},
           {"judge --pairs '' -- cat", 2, "--pairs ''"},
           {"judge --html '' -- cat", 2, "--html '': name a file"},
           {"judge --save-failures /dev/null/x -- cat", 5, "/dev/null/x"},
           {"judge --html /dev/null/x -- cat", 5, "/dev/null/x"},
           {"judge --html " + std::string(300, 'x') + " -- cat", 5, "File name too long"},
           {"check-steps - </dev/null", 3, "standard input: is empty"},
           {"check-steps", 2, "FILE"},
           {"check-steps /nowhere", 3, "nowhere: No such file"},
           {"check-steps /dev/zero", 3, "is not a regular file"},
       })
    check_failure(arguments, exit_code, {said});
  CHECK(run("judge --families boxes --count 2 -- " + always_yes, "/dev/full").exit_code == 5);
}

/// What is typed leaves nothing running: neither asks, nor what the program has started. `started`: the file with its process.
TEST_CASE("judge: ended or killed while it waits, it leaves nothing running", "[judge]") {
  const std::string anywhere = "setsid sleep 2000 & echo $! >started; sleep 2000",
                    of_its_group = "(sleep 2000 & echo $! >started; wait) & sleep 2000";
  for (const auto& [signal, whom, program] : {std::tuple{"INT", "$!", anywhere},
                                              {"TERM", "$!", anywhere},
                                              {"HUP", "$!", anywhere},
                                              {"KILL", "$!", of_its_group},
                                              {"KILL", "-$!", of_its_group}}) {
    INFO(signal << ' ' << whom);
    const Folder folder;
    write(folder / "script",
          "cd " + quoted(folder.path()) + "\nsetsid env --default-signal=INT " + quoted(kit::built("gjkstep-study")) +
              " judge --time-limit 100 -- sh -c " + quoted(program) +
              " &\nuntil [ -s started ]; do sleep 0.02; done\nkill -" + signal + " " + whom +
              "\nwait $!\n[ $? -gt 128 ] || exit 1\n" +
              "while readlink /proc/$(cat started)/exe; do sleep 0.02; done\n");  // one that has ended has none
    CHECK(kit::shell("timeout 60 sh " + in(folder, "script")).exit_code == 0);
  }
}

TEST_CASE("judge: the headline, the command and the words of the program are told", "[judge]") {
  const std::string boxes = "judge --families boxes --count 2 ",
                    some = "judge --families boxes,triangles --count 2 -- ", longest(5000, 'x');
  for (const auto& [arguments, said] : std::vector<std::pair<std::string, std::string>>{
           {some + "sed s/.*/\\\"undecided\\\"/", ": nothing is wrong, and nothing decided: 4 pairs, 4 undecided\n"},
           {some + "sed s/.*/perhaps/", ": wrong: 4 of 4 pairs, 4 of these without an answer"},
           {some + "true", " without an answer"},
           {"judge --families triangles -- sed s/.*/false/", "It behaves like a program that always says no"},
           // Options behind the program are its own; behind a list, too.
           {boxes + "-- sh -c 'while read x; do echo \"$1\"; done' --json --count",
            "First pair without an answer: boxes-0: "},
           {"judge --count 2 --families boxes -- " + certified, "query --certified: nothing is wrong: 2 pairs\n"},
           // The command can be given to a shell again.
           {boxes + "--time-limit 7.5 -- sh -c 'sed s/.*/true/; exit'",
            "gjkstep-study judge --families boxes --count 2 --seed 1 --time-limit 7.5 -- sh -c 'sed s/.*/true/; "
            "exit'`"},
           {boxes + "-- " + always_yes + " \"$(printf '\\033')\" " + longest, "\\x1b"},
           {"judge --families spheres --count 1 -- " + wrong_gjk, "about points, and this pair has a round shape"},
           {"judge --families spheres --count 1 -- sh -c 'cd " JUDGE_ADAPTERS
            " && exec python3 -B judge_main.py boxes_overlap'",
            "about points, and this pair has a round shape"},
       }) {
    const Outcome outcome = run(arguments);
    INFO(outcome.out);
    CHECK(has(outcome.out, said));
    CHECK_FALSE(has(outcome.out, "\x1b"));
    for (const std::string& line : lines(outcome.out)) CHECK(line.size() < 1000);
  }
}

TEST_CASE("judge: names of pairs are shown escaped, and a pair that has no room to be scaled is not", "[judge]") {
  const Folder folder;
  const std::string pairs =
      "judge --pairs " +
      quoted(write(folder / "pairs.jsonl",
                   R"({"name":"\u001b[31m<b>|n","family":"<b>|\u001b",)"
                   R"("a":{"points":[[0,0,0],[1e308,1e-308,3e-320]]},"b":{"points":[[-1e308,0,5e-324],[1e308,1,1]]}})"
                   "\n")) +
      " -- ";
  const Outcome outcome = run(pairs + "sed s/.*/perhaps/");
  CHECK_FALSE(has(outcome.out, "\x1b"));
  CHECK(has(outcome.out, "| \\<b>\\|\\x1b | 1 |"));
  CHECK(run(pairs + certified).exit_code == 0);
}

}  // namespace
}  // namespace study::test
