/// gjkstep-study judge as its users run it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/study/program/run_study.hpp"

namespace study::test {
namespace {

TEST_CASE("judge: a sound program ends with 0, a wrong one with 1 and what is wrong", "[judge]") {
  const Outcome sound = run("judge -- " + quoted(kit::program()) + " query --certified");
  INFO(sound.err);
  CHECK(sound.exit_code == 0);
  CHECK(has(sound.out, "query --certified: nothing is wrong: "));
  CHECK(has(sound.err, "(100 %)"));
  const Outcome wrong = run("judge -- " + quoted(JUDGED_WRONG_GJK));
  CHECK(wrong.exit_code == 1);
  CHECK(has(wrong.out, "* It behaves like M14 (the order is not changed when moving below the triangle): "));
  CHECK(has(wrong.out, "## Asked again after what must not change the answer"));
  CHECK(has(wrong.err, "gjkstep-study: " + std::string(JUDGED_WRONG_GJK) + ": wrong: "));
}

TEST_CASE("judge: families are asked with intervals, and the same seed makes the same pairs", "[judge]") {
  const std::string command = "judge --families triangles,spheres --count 50 --seed 3 -- ";
  const Outcome one = run(command + quoted(kit::program()) + " query --rules as-printed");
  CHECK(one.exit_code == 1);
  CHECK(has(one.out, "wrong, with the 95 % interval"));
  CHECK(has(one.out, "| all | 100 |"));
  CHECK(has(one.out, "made by: `gjkstep-study " + command));
  CHECK(run(command + quoted(kit::program()) + " query --rules as-printed").out == one.out);
}

TEST_CASE("judge: JSON says the same, with every pair that is not right", "[judge]") {
  const Outcome outcome = run("judge --json -- sed s/.*/true/");
  CHECK(outcome.exit_code == 1);
  const auto said = nlohmann::json::parse(outcome.out);
  CHECK(said["good"] == false);
  CHECK(said["all"]["wrong_yes"] == said["not_right"].size());
  CHECK(said["not_right"][0]["verdict"] == "wrong_yes");
  CHECK(said["not_right"][0]["truth"] == "separated");
  CHECK(said["mistakes"][0]["name"] == "a program that always says yes");
  CHECK(said["changes"].size() == 7);
  CHECK(said["families"].size() > 40);
}

TEST_CASE("judge: what gjkstep-study pairs writes is judged, and pairs that are none are named", "[judge]") {
  const Folder folder;
  std::ofstream(folder.path() / "pairs.jsonl") << run("pairs --families boxes,cylinders --count 4").out;
  std::ofstream(folder.path() / "bad.jsonl") << R"({"a":{"points":[[0,0,0]]}})"
                                             << "\n";
  const Outcome outcome =
      run("judge --pairs " + in(folder, "pairs.jsonl") + " -- " + quoted(kit::program()) + " query");
  CHECK(has(outcome.out, "of 8 pairs") != has(outcome.out, "wrong: 8 pairs"));
  check_failure("judge --pairs " + in(folder, "bad.jsonl") + " -- cat", 3, {"bad.jsonl:1: ", "b"});
  check_failure("judge --pairs " + in(folder, "nowhere") + " -- cat", 3, {"nowhere: cannot be read"});
  check_failure("judge --pairs " + in(folder, "pairs.jsonl") + " --count 3 -- cat", 2, {"--count"});
}

TEST_CASE("judge: failures are saved as scenes that gjkstep render draws", "[judge]") {
  const Folder folder;
  const Outcome outcome =
      run("judge --save-failures " + in(folder, "wrong") + " --max-failures 1 -- " + quoted(JUDGED_WRONG_GJK));
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, " scene files; gjkstep render draws them"));
  const std::vector<std::string> files = listing(folder.path() / "wrong");
  REQUIRE(files.size() > 5);
  CHECK(std::ranges::count(files, "wrong-no-m14-1.json") == 1);
  const std::string render = quoted(kit::program()) + " render " + in(folder, "wrong/" + files.front()) +
                             " --size 160x90 --out " + in(folder, "pictures") + " >/dev/null 2>&1";
  CHECK(std::system(render.c_str()) == 0);
  CHECK_FALSE(listing(folder.path() / "pictures").empty());
}

TEST_CASE("judge: a page has the verdict, families and pictures in it, and nothing from elsewhere", "[judge]") {
  const Folder folder;
  const Outcome outcome = run("judge --html " + in(folder, "page.html") + " -- " + quoted(JUDGED_WRONG_GJK));
  CHECK(outcome.exit_code == 1);
  const std::string page = bytes_of(folder.path() / "page.html");
  CHECK(page.find("wrong: ") < page.find("It behaves like M14"));
  CHECK(page.find("It behaves like M14") < page.find("<h2>By family"));
  CHECK(page.find("<h2>By family") < page.find("<img width=\"960\""));
  CHECK(has(page, "<figcaption>wrong no: m14-1. They have a point in common.</figcaption>"));
  CHECK_FALSE(has(page, "http://"));
  CHECK_FALSE(has(page, "https://"));
  const Outcome sound = run("judge --families boxes --count 3 --html " + in(folder, "sound.html") + " -- " +
                            quoted(kit::program()) + " query --certified");
  CHECK(sound.exit_code == 0);
  CHECK_FALSE(has(bytes_of(folder.path() / "sound.html"), "<img"));
}

TEST_CASE("judge: nothing that it writes lies over what it reads, or over what else it writes", "[judge]") {
  const Folder folder;
  const std::string pairs = in(folder, "f/mine.json");
  std::filesystem::create_directories(folder.path() / "f");
  std::ofstream(folder.path() / "f/mine.json") << "mine";
  const std::string before = bytes_of(folder.path() / "f/mine.json");
  const auto check_refused = [&](const std::string& arguments) {
    check_failure(arguments, 2, {"have the same place", "choose another place"});
  };
  check_refused("judge --pairs " + pairs + " --save-failures " + in(folder, "f") + " -- cat");
  check_refused("judge --html " + in(folder, "f/x.json") + " --save-failures " + in(folder, "f") + " -- cat");
  check_refused("judge --html " + in(folder, "g") + " --save-failures " + in(folder, "g") + " -- cat");
  CHECK(bytes_of(folder.path() / "f/mine.json") == before);
  check_failure("judge --html " + std::string(300, 'x') + " -- cat", 5, {"File name too long"});
}

TEST_CASE("judge: the recipe says what happens", "[judge]") {
  const std::string recipe = bytes_of(JUDGE_ADAPTERS "/../README.md");
  const std::string out = run("judge -- " + quoted(JUDGED_WRONG_GJK)).out;
  const std::string verdict = lines(out).at(0).substr(2 + std::string(JUDGED_WRONG_GJK).size());
  CHECK(has(recipe, "# ./wrong_gjk" + verdict + "\n"));
  CHECK(
      has(recipe, "[a GJK of " + std::to_string(lines(bytes_of(JUDGE_ADAPTERS "/wrong_gjk.cpp")).size()) + " lines]"));
  const std::string sentence = lines(out).at(2);
  CHECK(has(recipe, sentence.substr(0, sentence.find(';')) + "; …\n"));
  const auto line = recipe.find("  if (dot(n, AO) < 0) return s = {C, B, A}, -n;");
  CHECK(has(bytes_of(JUDGE_ADAPTERS "/wrong_gjk.cpp"), recipe.substr(line, recipe.find(';', line) - line)));
  const auto doubles = run("judge --json -- " + quoted(kit::program()) + " query");
  const auto all = nlohmann::json::parse(doubles.out)["all"];
  const int wrong = all["wrong_yes"].get<int>() + all["wrong_no"].get<int>(), unproved = all["false_evidence"];
  CHECK(has(recipe, "in doubles is wrong on " + std::to_string(wrong) + " of these pairs, " + std::to_string(unproved) +
                        " of its right answers have evidence that proves nothing"));
}

TEST_CASE("check-steps: the recipe's search has its wrong step named", "[judge]") {
  const Folder folder;
  const std::string pair = in(folder, "pair.jsonl"), steps = in(folder, "steps.jsonl");
  const std::string make = "grep '\"m14-1\"' " + quoted(kit::source("tests/study/corpus.jsonl")) + " >" + pair +
                           " && (cat " + pair + "; JUDGE_STEPS=1 " + quoted(JUDGED_WRONG_GJK) + " <" + pair + ") >" +
                           steps;
  REQUIRE(std::system(make.c_str()) == 0);
  const Outcome outcome = run("check-steps " + steps);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, "steps.jsonl: 1 of 1 search has a wrong step"));
  const std::string recipe = bytes_of(JUDGE_ADAPTERS "/../README.md");
  for (const std::string& line : lines(outcome.out)) CHECK(has(recipe, line + "\n"));
  CHECK(lines(outcome.out).size() == 2);
  const Outcome drawn = run("check-steps " + steps + " --draw " + in(folder, "pictures"));
  CHECK(lines(drawn.out).size() == 2 + listing(folder.path() / "pictures").size());
  CHECK(std::filesystem::exists(folder.path() / "pictures/mistakes/m14-order-below-triangle/014.png"));
  const std::filesystem::path over = folder.path() / "pictures/mistakes/m14-order-below-triangle/000.png";
  std::filesystem::copy_file(folder.path() / "steps.jsonl", over, std::filesystem::copy_options::overwrite_existing);
  const Outcome refused = run("check-steps " + quoted(over.string()) + " --draw " + in(folder, "pictures"));
  CHECK(refused.exit_code == 2);
  CHECK(has(refused.err, "the pictures of --draw have the same place"));
  CHECK(bytes_of(over) == bytes_of(folder.path() / "steps.jsonl"));
  check_failure("check-steps " + steps + " --draw ''", 2, {"--draw '': name a folder"});
  check_failure("check-steps " + steps + " --draw /dev/null/x", 5, {"/dev/null/x"});
  const Outcome piped = run("check-steps - <" + steps);
  CHECK(piped.out == outcome.out);
  CHECK(has(piped.err, "standard input: 1 of 1 search has a wrong step"));
  std::ofstream(folder.path() / "tiny")
      << R"({"a":{"points":[[0,0,0],[1e-90,0,0]]},"b":{"points":[[5e-90,1e-90,0],[5e-90,-1e-90,0]]}}
{"direction":[1,0,0],"simplex":[[-4e-90,-1e-90,0]]}
{"direction":[4,1,0],"simplex":[[-4e-90,1e-90,0]]}
{"direction":[1,0,0],"simplex":[[-4e-90,1e-90,0]]}
false
)";
  CHECK(has(run("check-steps " + in(folder, "tiny")).err, "has a wrong step; of 1 rounding may be the reason"));
  check_failure("check-steps - </dev/null", 3, {"standard input: is empty"});
  check_failure("check-steps", 2, {"FILE"});
  check_failure("check-steps " + in(folder, "nowhere"), 3, {"nowhere: cannot be read"});
  check_failure("check-steps /dev/zero", 3, {"is not a regular file"});
  std::ofstream(folder.path() / "bad") << "true\n";
  check_failure("check-steps " + in(folder, "bad"), 3, {"bad:1: the first line must be a pair"});
}

TEST_CASE(
    "check-steps: who tells steps at their end, as the adapter does, is not blamed for a no that follows from them",
    "[judge]") {
  // A right one; and one in a direction that rounds, and is not told.
  for (const std::string name : {"m4-1", "touching-edge-askew-37"}) {
    INFO(name);
    const Folder folder;
    const std::string steps = in(folder, "steps.jsonl");
    const std::string make = "grep '\"" + name + "\"' " + quoted(kit::source("tests/study/corpus.jsonl")) + " | tee " +
                             steps + " | JUDGE_STEPS=1 " + quoted(JUDGED_WRONG_GJK) + " >" + steps + ".told && cat " +
                             steps + ".told >>" + steps;
    REQUIRE(std::system(make.c_str()) == 0);
    REQUIRE(has(bytes_of(folder.path() / "steps.jsonl"), "\nfalse\n"));
    const Outcome outcome = run("check-steps " + steps);
    CHECK(outcome.exit_code == 0);
    CHECK(has(outcome.out, name + ": every step is one that the report's algorithm may make"));
  }
}

TEST_CASE("check-steps: a file without any step is refused, a search without is told", "[judge]") {
  const Folder folder;
  const std::string pair = R"({"a":{"points":[[0,0,0]]},"b":{"points":[[0,0,3]]}})",
                    step = R"({"direction":[1,0,0],"simplex":[[0,0,-3]]})";
  std::ofstream(folder.path() / "none") << pair << "\nfalse\n";
  check_failure("check-steps " + in(folder, "none"), 3, {"none: no search tells a step"});
  std::ofstream(folder.path() / "one") << pair << "\nfalse\n" << pair << '\n' << step << "\nfalse\n";
  const Outcome outcome = run("check-steps " + in(folder, "one"));
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "line-1: no step is told\nline-3: every step is one"));
}

TEST_CASE("judge: --steps names the first wrong step of failures, where the program tells its steps", "[judge]") {
  const Outcome wrong = run("judge --steps -- " + quoted(JUDGED_WRONG_GJK));
  CHECK(wrong.exit_code == 1);
  CHECK(has(wrong.out, "## The first wrong step"));
  CHECK(has(wrong.out, "keeps [C, B, A] where the report keeps [C, A, B]"));
  CHECK(has(wrong.out, "| M14: the order is not changed when moving below the triangle |"));
  const std::string table = wrong.out.substr(wrong.out.find("## The first wrong step"));
  CHECK(lines(table).at(4).starts_with("| m14-1 | 3 |"));  // small whole numbers
  CHECK(has(table, " | – | every step is one"));
  CHECK(has(run("judge --steps -- sed s/.*/true/").out, "| it tells no steps |"));
  CHECK_FALSE(has(run("judge --steps -- " + quoted(kit::program()) + " query --certified").out, "first wrong step"));
}

TEST_CASE("judge: --steps is in JSON and on the page, too, where both searches are drawn as they part", "[judge]") {
  const Folder folder;
  const Outcome outcome =
      run("judge --steps --json --html " + in(folder, "page.html") + " -- " + quoted(JUDGED_WRONG_GJK));
  const auto steps = nlohmann::json::parse(outcome.out).at("steps");
  REQUIRE(steps.size() == 10);
  const auto first = std::ranges::find(steps, nlohmann::json(3), [](const auto& each) { return each["iteration"]; });
  REQUIRE(first != steps.end());
  CHECK(has((*first)["words"].get<std::string>(), "keeps [C, B, A] where the report keeps [C, A, B]"));
  CHECK((*first)["mistakes"] == nlohmann::json{14});
  const std::string page = bytes_of(folder.path() / "page.html");
  CHECK(page.find("<h2>By family") < page.find("<h2>Which mistake answers most alike"));
  CHECK(page.find("<h2>Which mistake answers most alike") < page.find("<h2>Asked again after what must not change"));
  CHECK(page.find("<h2>Asked again after what must not change") < page.find("<h2>The first wrong step"));
  CHECK(page.find("M14: the order is not changed when moving below the triangle") < page.find("alt=\"Both searches"));
  CHECK(page.find("alt=\"Both searches") < page.find("<h2>The first failures"));
  CHECK_FALSE(nlohmann::json::parse(run("judge --json -- " + quoted(JUDGED_WRONG_GJK)).out).contains("steps"));
}

TEST_CASE("judge: wrong usage ends with 2, what cannot be written with 5", "[judge]") {
  check_failure("judge", 2, {"PROGRAM"});
  check_failure("judge -- /nowhere/at/all", 2, {"the program '/nowhere/at/all' cannot be started: No such file"});
  check_failure("judge --families boxs -- cat", 2, {"did you mean 'boxes'?"});
  check_failure("judge --time-limit 0 -- cat", 2, {"expected a number from 0.01 to 3600"});
  check_failure("judge --save-failures '' -- cat", 2, {"--save-failures '': name a folder"});
  check_failure("judge --pairs '' -- cat", 2, {"--pairs ''"});
  check_failure("judge --html '' -- cat", 2, {"--html '': name a file"});
  check_failure("judge --save-failures /dev/null/x -- cat", 5, {"/dev/null/x"});
  check_failure("judge --html /dev/null/x -- cat", 5, {"/dev/null/x"});
  const Outcome outcome = run("judge --families boxes --count 2 -- sed s/.*/true/", "/dev/full");
  CHECK(outcome.exit_code == 5);
}

TEST_CASE("judge: ended while it waits, it leaves nothing running", "[judge]") {
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    INFO(signal);
    const Folder folder;
    std::ofstream(folder.path() / "script")
        << "env --default-signal=INT " << quoted(kit::built("gjkstep-study"))
        << " judge --time-limit 100 -- sh -c 'setsid sleep 2000 & echo $! >" << (folder.path() / "started").string()
        << "; sleep 2000' >/dev/null 2>&1 &\nuntil [ -s " << in(folder, "started") << " ]; do sleep 0.02; done\nkill -"
        << signal << " $!\nwait $!\n";
    const int status = std::system(("sh " + in(folder, "script") + " 2>/dev/null").c_str());
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) > 128));
    const std::string started = lines(bytes_of(folder.path() / "started")).at(0);
    std::error_code error;
    CHECK(std::filesystem::read_symlink("/proc/" + started + "/exe", error).empty());
  }
}

TEST_CASE("judge: killed while it waits, it leaves nothing of the program's group running", "[judge]") {
  for (const std::string whom : {"$!", "-$!"}) {  // it alone, or its group
    INFO(whom);
    const Folder folder;
    const std::string started = in(folder, "started");
    std::ofstream(folder.path() / "script")
        << "setsid " << quoted(kit::built("gjkstep-study"))
        << " judge --time-limit 100 -- sh -c '(sleep 2000 & echo $! >" << (folder.path() / "started").string()
        << "; wait) & sleep 2000' >/dev/null 2>&1 &\nuntil [ -s " << started << " ]; do sleep 0.02; done\nkill -KILL "
        << whom << "\nwait $!\n"
        << "while readlink /proc/$(cat " << started << ")/exe; do sleep 0.02; done\n";  // one that has ended has none
    CHECK(std::system(("timeout 60 sh " + in(folder, "script") + " 2>/dev/null").c_str()) == 0);
  }
}

TEST_CASE("judge: options of the program are its own", "[judge]") {
  const Outcome outcome =
      run("judge --families boxes --count 2 -- sh -c 'while read x; do echo \"$1\"; done' --json --count");
  CHECK(has(outcome.out, "First pair without an answer: boxes-0: "));
  CHECK_FALSE(outcome.out.starts_with("{"));
  // Behind a list, too.
  const Outcome own = run("judge --count 2 --families boxes -- " + quoted(kit::program()) + " query --certified");
  CHECK(own.exit_code == 0);
  CHECK(has(own.out, "query --certified: nothing is wrong: 2 pairs\n"));
}

TEST_CASE("judge: the headline says what kind of wrong there is", "[judge]") {
  const auto headline = [](const std::string& program) {
    const Outcome outcome = run("judge --families boxes,triangles --count 2 -- " + program);
    return outcome.out.substr(0, outcome.out.find('\n'));
  };
  CHECK(has(headline("sed s/.*/\\\"undecided\\\"/"), "nothing is wrong, and nothing decided: 4 pairs, 4 undecided"));
  CHECK(has(headline("sed s/.*/perhaps/"), "wrong: 4 of 4 pairs, 4 of these without an answer"));
  CHECK(has(headline("true"), " without an answer"));
}

TEST_CASE("judge: the command that is told can be given to a shell again", "[judge]") {
  const Outcome outcome = run("judge --families boxes --count 1 --time-limit 7.5 -- sh -c 'sed s/.*/true/; exit'");
  CHECK(has(outcome.out,
            "gjkstep-study judge --families boxes --count 1 --seed 1 --time-limit 7.5 -- sh -c "
            "'sed s/.*/true/; exit'`"));
}

TEST_CASE("judge: words of the program are shown escaped, and short in their middle where they are long", "[judge]") {
  const std::string longest(5000, 'x');
  const Outcome outcome = run("judge --families boxes --count 1 -- sed s/.*/true/ \"$(printf '\\033')\" " + longest);
  CHECK_FALSE(has(outcome.out, "\x1b"));
  CHECK(has(outcome.out, "\\x1b"));
  for (const std::string& line : lines(outcome.out)) CHECK(line.size() < 1000);
}

TEST_CASE("judge: names of pairs are shown escaped, in tables too", "[judge]") {
  const Folder folder;
  std::ofstream(folder.path() / "pairs.jsonl")
      << R"({"name":"\u001b[31m<b>|n","family":"<b>|\u001b","a":{"points":[[0,0,0]]},"b":{"points":[[1,0,0]]}})"
      << "\n";
  const Outcome outcome = run("judge --pairs " + in(folder, "pairs.jsonl") + " -- sed s/.*/perhaps/");
  CHECK_FALSE(has(outcome.out, "\x1b"));
  CHECK(has(outcome.out, "| \\<b>\\|\\x1b | 1 |"));
}

TEST_CASE("judge: a pair that has no room to be scaled is not", "[judge]") {
  const Folder folder;
  std::ofstream(folder.path() / "pairs.jsonl")
      << R"({"a":{"points":[[0,0,0],[1e308,1e-308,3e-320]]},"b":{"points":[[-1e308,0,5e-324],[1e308,1,1]]}})"
      << "\n";
  const Outcome outcome =
      run("judge --pairs " + in(folder, "pairs.jsonl") + " -- " + quoted(kit::program()) + " query --certified");
  INFO(outcome.out);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("judge: an adapter that is asked about what it cannot read says so", "[judge]") {
  for (const std::string& program :
       {quoted(JUDGED_WRONG_GJK),
        std::string("sh -c 'cd " JUDGE_ADAPTERS " && exec python3 -B judge_main.py boxes_overlap'")}) {
    const Outcome outcome = run("judge --families spheres --count 1 -- " + program);
    CHECK(outcome.exit_code == 1);
    CHECK(has(outcome.out, "about points, and this pair has a round shape"));
  }
}

TEST_CASE("judge: of two that explain the same the simpler one is named", "[judge]") {
  CHECK(has(run("judge --families triangles -- sed s/.*/false/").out, "It behaves like a program that always says no"));
}

}  // namespace
}  // namespace study::test
