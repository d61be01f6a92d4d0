// Help, and what is refused as wrong usage: exit code 2.

#include <filesystem>
#include <fstream>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

TEST_CASE("The option --help names every command, the exit codes and the variables of the environment") {
  for (const char* option : {"--help", "-h"}) {
    const Outcome outcome = run(option);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    for (const char* word :
         {"list", "render", "trace", "--version", "--gl", "Exit codes", "GJKSTEP_FONT_DIR", "GJKSTEP_GL"})
      CHECK(has(outcome.out, word));
  }
  for (const char* word :
       {"--all", "--strip", "--out", "--size", "1280x720", "--apng", "--movie", "--theme", "--turn", "--gl"})
    CHECK(has(run("render --help").out, word));
}

TEST_CASE("What is to be written needs a name that is not that of the next option") {
  for (const std::string name : {"''", "--strip"}) {
    check_failure("render figure-5 --size 32x18 --out " + name, 2, {"--out '", "': name a folder to write to"});
    check_failure("render figure-5 --size 32x18 --captions " + name, 2, {"--captions '", "': name a file to write"});
    check_failure("compare x y --report " + name, 2, {"--report '", "': name a folder to write to"});
  }
}

TEST_CASE("What is to be written is not written to standard output where its name is a hyphen") {
  for (const char* command :
       {"render figure-5 --size 32x18 --out -", "render figure-5 --size 32x18 --captions -", "compare x y --report -"})
    check_failure(command, 2, {" '-': this is not written to standard output", ", or ./- if you mean it"});
}

TEST_CASE("An option without its value, or given twice, is told in one sentence of ours") {
  for (const char* command : {"query --max-iterations=", "query --max-iterations"})
    check_failure(command, 2, {"gjkstep: --max-iterations has no value; give it one; 'gjkstep --help'"});
  check_failure("render figure-5 --theme dark --theme slides", 2,
                {"gjkstep: --theme is given more than once; give it once; 'gjkstep --help'"});
}

TEST_CASE("The option --gl is refused where nothing is drawn") {
  for (const std::string command : {"list", "trace figure-5", "scene --example"})
    check_failure("--gl osmesa " + command, 2,
                  {"--gl: '" + command.substr(0, command.find(' ')) + "' draws nothing; leave --gl out"});
}

TEST_CASE("The option --version prints the version and the OpenGL renderer") {
  const Outcome outcome = run("--version");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.starts_with("gjkstep 0."));
  CHECK(has(outcome.out, "OpenGL "));
}

TEST_CASE("The option --version stands alone") {
  check_failure("--version list", 2, {"--version stands alone; leave it out, or 'list'"});
  check_failure("--version trace figure-5", 2, {"or 'trace'"});
}

TEST_CASE("Without a command, or with one that there is not, the program says where to find help") {
  check_failure("", 2, {"gjkstep --help"});
  check_failure("rendr figure-5", 2, {"rendr", "--help"});
  check_failure("--bogus", 2, {"--bogus", "--help"});
  check_failure("render --bogus figure-5", 2, {"--bogus", "--help"});
  check_failure("list mroe", 2, {"mroe", "gjkstep list"});
  check_failure("list figure-5 figure-4-left", 2, {"figure-4-left"});
}

TEST_CASE("gjkstep render needs a name, gjkstep trace exactly one") {
  const Untouched out;
  check_failure("render" + out.option, 2, {"--all", "gjkstep list"});
  check_failure("trace", 2, {"NAME"});
  check_failure("trace figure-5 figure-4-left", 2, {"figure-4-left"});
}

TEST_CASE("An unknown walkthrough gets the nearest name for an answer, and nothing is written") {
  const Untouched out;
  check_failure("render figur-4-lefd" + out.option, 2,
                {"'figur-4-lefd'", "did you mean 'figure-4-left'?", "gjkstep list"});
  check_failure("trace figure5", 2, {"'figure5'", "did you mean 'figure-5'?", "gjkstep list"});
}

TEST_CASE(
    "A file that is named as a walkthrough gets what to do with it for an answer, and is checked as a scene all the "
    "same") {
  const Untouched out;
  const std::string file = scene_file(out.parent.path() / "plain").string();
  for (const std::string& command : {"render " + quoted(file) + out.option, "trace " + quoted(file)})
    check_failure(command, 2, {"' is a file, not a walkthrough", "ends in .json", "--from-trace FILE"});
  CHECK(has(run("scene --check " + quoted(file)).out, "; before it is drawn, give it a name that ends in .json\n"));
  const std::string named = scene_file(out.parent.path() / "s.json").string();
  CHECK_FALSE(has(run("scene --check " + quoted(named)).out, "before it is drawn"));
}

TEST_CASE("One bad name among good ones writes nothing") {
  const Untouched out;
  check_failure("render figure-5 figure-4-rite figure-4-left" + out.option, 2, {"'figure-4-rite'", "'figure-4-right'"});
  check_failure("render --all nonsense" + out.option, 2, {"'nonsense'"});
}

TEST_CASE("A size that is not WIDTHxHEIGHT within the limits is refused, and nothing is written") {
  for (const char* size :
       {"0x0",          "100000x100000", "12x",           "x12",   "-5x5",          "5x-5",     "1280X720",
        "1280x720junk", "99999999999x5", "5x99999999999", "",      " 640x480",      "640 x480", "640x480 ",
        "+640x480",     "640x480x3",     "640",           "15x16", "16x15",         "8193x720", "720x8193",
        "0x10x20",      "1e3x1e3",       "640.5x480",     "x",     "sixteen x nine"}) {
    const Untouched out;
    check_failure("render figure-5 --size " + quoted(size) + out.option, 2,
                  {quoted(size), "WIDTHxHEIGHT", "1280x720", "16", "8192"});
  }
}

TEST_CASE("A movie or a theme that there is not is refused") {
  for (const std::string option : {"--movie", "--theme"}) {
    const Untouched untouched;
    check_failure("render figure-5 " + option + " blue" + untouched.option, 2, {option});
  }
}

TEST_CASE("Numbers on the command line are decimal and each option has one range and one reason") {
  const Untouched untouched;
  const std::string render = "render figure-5" + untouched.option + " ";
  for (const auto& [option, expected] : std::vector<std::pair<std::string, std::string>>{
           {render + "--turn", "--turn: expected a whole number from 0 to 72, found "},
           {render + "--frame-time", "--frame-time: expected a number from 0.02 to 60, found "},
           {"query --max-iterations", "--max-iterations: expected a whole number from 1 to 1000, found "}})
    for (const char* const number : {"-1", "1001", "2147483648", "99999999999999999999", "1e400", "", " ", "0x10", "x",
                                     "+5", "5 ", "5,5", "nan", "inf", "ten"})
      check_failure(option + " " + quoted(number), 2, {expected + quoted(number)});
  for (const std::string option : {"--turn", "--max-iterations"})
    check_failure((option == "--turn" ? render : "query ") + option + " 1.5", 2,
                  {option + ": expected a whole number"});
  for (const char* const time : {"0", "0.01", "60.1", "0x1p1"})
    check_failure(render + "--frame-time " + time, 2, {"from 0.02 to 60, found " + quoted(time)});
}

TEST_CASE("A number on the command line that begins with 0 is decimal, too") {
  const Folder folder;
  const Outcome outcome =
      run("render cycle-separated --detail step --size 32x18 --turn 010 --out " + quoted(folder.path().string()));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "000-turn-10.png"));
}

TEST_CASE("Whatever a word of the command line holds is told in one line that a terminal shows as it is") {
  const Folder folder;
  const std::string hostile = "\x1b[31m\xe2\x80\xaex\xff\n", escaped = "\\x1b[31m\\u202ex\\xff\\x0a";
  std::ofstream(folder.path() / (hostile + ".json")) << "{}";
  const std::string bad_scene = "'" + folder.path().string() + "/$.json'";
  for (const std::string& words : std::vector<std::string>{"list '$'",
                                                           "render '$'",
                                                           "trace '$'",
                                                           "'$'",
                                                           "--'$'",
                                                           "list --'$'",
                                                           "render figure-5 --theme '$'",
                                                           "render figure-5 --size '$'",
                                                           "render figure-5 --turn '$'",
                                                           "render figure-5 --movie '$'",
                                                           "render figure-5 --gl '$'",
                                                           "query --rules '$'",
                                                           "query --max-iterations '$'",
                                                           "query --start '$'",
                                                           "query --first-direction '$'",
                                                           "query '$'",
                                                           "scene --check '$'",
                                                           "scene --check " + bad_scene,
                                                           "render " + bad_scene,
                                                           "render '$.json'",
                                                           "trace '$.json'",
                                                           "render --from-trace '$'",
                                                           "compare '$' '$'"}) {
    std::string arguments = words;
    for (std::size_t at; (at = arguments.find('$')) != std::string::npos;) arguments.replace(at, 1, hostile);
    const Outcome outcome = run(arguments);
    INFO(words << ": " << outcome.err);
    CHECK((outcome.exit_code == 2 || outcome.exit_code == 3));
    CHECK(has(outcome.err, escaped));
    CHECK(lines(outcome.err).size() == 1);
  }
}

TEST_CASE("A long word of the command line is told shortened") {
  const std::string longest(100'000, 'y');
  for (const std::string words : {"list ", "render ", "trace ", "", "--", "query --rules ", "render figure-5 --size ",
                                  "render figure-5 --turn ", "render figure-5 --theme ", "scene --check "}) {
    const Outcome outcome = run(words + longest);
    INFO(words << outcome.err.substr(0, 1000));
    CHECK((outcome.exit_code == 2 || outcome.exit_code == 3));
    CHECK(outcome.err.size() < 1000);
    CHECK(has(outcome.err, "yyy…"));
  }
}
