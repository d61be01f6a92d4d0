// Help, and what is refused as wrong usage: exit code 2.

#include "tests/catch.hpp"
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

TEST_CASE("The option --version prints the version and the OpenGL renderer") {
  const Outcome outcome = run("--version");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.starts_with("gjkstep 0."));
  CHECK(has(outcome.out, "OpenGL "));
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

TEST_CASE(
    "A movie that there is not, a time that is none, a theme or a number of turns that there is not are refused") {
  for (const char* option : {"--movie avi", "--frame-time 0", "--frame-time 0.01", "--frame-time -1", "--frame-time 61",
                             "--frame-time nan", "--frame-time inf", "--frame-time two", "--theme blue", "--turn 73",
                             "--turn -1", "--turn some", "--turn 1.5"}) {
    const Untouched untouched;
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    check_failure("render figure-5 " + std::string(option) + untouched.option, 2, {name});
  }
}
