// gjkstep trace, and gjkstep render --from-trace.

#include <filesystem>
#include <fstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

TEST_CASE("gjkstep trace prints JSON Lines on standard output") {
  for (const Walkthrough& w : catalogue()) {
    if (w.layout == Layout::diagrams) continue;
    const Outcome outcome = run("trace " + w.name);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    std::size_t events = 0;
    for (const Scene& scene : w.scenes) events += run(scene).events.size();
    const std::vector<std::string> printed = lines(outcome.out);
    CHECK(printed.size() == 1 + events);
    CHECK(printed.front().starts_with(R"({"schema":"gjkstep-trace","version":2,"walkthrough":")" + w.name + '"'));
    for (const std::string& line : printed) CHECK((line.starts_with('{') && line.ends_with('}')));
  }
}

TEST_CASE("A scene file has a trace") {
  const Folder folder;
  const Outcome outcome = run("trace " + quoted(scene_file(folder.path() / "mine.json").string()));
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, R"("walkthrough":"mine")"));
  CHECK(lines(outcome.out).size() > 3);
}

TEST_CASE("A folder has no trace, and neither has a diagram") {
  if (const std::string name = some_folder(); !name.empty())
    check_failure("trace " + name, 2, {quoted(name), "gjkstep list " + name});
  for (const Walkthrough& w : catalogue())
    if (w.layout == Layout::diagrams) check_failure("trace " + w.name, 2, {quoted(w.name), "diagram"});
}

TEST_CASE("gjkstep trace --schema prints a JSON Schema") {
  const Outcome outcome = run("trace --schema");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.starts_with("{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\""));
  check_failure("trace --schema figure-5", 2, {"--schema"});
}

TEST_CASE("gjkstep render --from-trace draws the files that the walkthrough itself has") {
  const Folder folder;
  const fs::path trace = folder.path() / "trace.jsonl", first = folder.path() / "first",
                 second = folder.path() / "second";
  const std::string scene = quoted(scene_file(folder.path() / "mine.json").string());
  for (const std::string& name : {std::string("figure-5"), std::string("regions/3-simplex-face-acd"), scene}) {
    const std::string options = " --strip --size 96x54 --out ";
    REQUIRE(run("trace " + name, "", {.out = trace.string(), .err = ""}).exit_code == 0);
    REQUIRE(run("render " + name + options + quoted(first.string())).exit_code == 0);
    REQUIRE(run("render --from-trace " + quoted(trace.string()) + options + quoted(second.string())).exit_code == 0);
    CHECK(listing(second) == listing(first));
    for (const std::string& file : listing(first)) CHECK(bytes_of(second / file) == bytes_of(first / file));
  }
}

TEST_CASE("gjkstep render --from-trace takes the trace of a scene file of whatever name") {
  const Folder folder;
  const fs::path trace = folder.path() / "trace.jsonl", out = folder.path() / "out";
  for (const std::string& stem : {std::string("_"), std::string(".s"), std::string("- -"), std::string("größe\x1b[2J"),
                                  std::string("\xff"), std::string(250, 'x')}) {
    INFO(stem);
    const fs::path scene = scene_file(folder.path() / (stem + ".json"));
    REQUIRE(run("trace " + quoted(scene.string()), "", {.out = trace.string(), .err = ""}).exit_code == 0);
    const Outcome drawn = run("render --size 32x18 --detail step --from-trace " + quoted(trace.string()) + " --out " +
                              quoted(out.string()));
    CHECK(drawn.exit_code == 0);
    CHECK(drawn.err.empty());
  }
  CHECK(fs::exists(out / "s" / "000.png"));
}

TEST_CASE("The changed trace in the README is refused as the README says") {
  std::string text = run("trace figure-4-right").out;
  const std::string verdict = "\"verdict\":\"not-crossed\"";
  text.replace(text.find(verdict), verdict.size(), "\"verdict\":\"crossed\"");
  const Folder folder;
  std::ofstream(folder.path() / "changed") << text;
  const Untouched untouched;
  const Outcome outcome = run("render --from-trace " + quoted((folder.path() / "changed").string()) + untouched.option);
  const std::string said = outcome.err.substr(outcome.err.find("changed:"));
  CHECK(outcome.exit_code == 3);
  CHECK(has(bytes_of(kit::source("README.md")), "gjkstep: " + said.substr(0, said.find("itself:") + 7)));
}

TEST_CASE("A trace that is not there, is cut off or contradicts itself is exit code 3, and nothing is written") {
  for (const std::string file : {"missing", "bad-cut-in-line", "bad-version-1", "bad-not-a-minus-b"}) {
    const Untouched untouched;
    const fs::path trace = kit::source("tests/fuzz/traces") / (file + ".jsonl");
    check_failure("render figure-5 --from-trace " + quoted(trace.string()) + untouched.option, 3, {file + ".jsonl"});
  }
}
