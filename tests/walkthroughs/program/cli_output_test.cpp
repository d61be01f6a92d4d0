// What cannot be read or written: the fonts, folders, frames, captions, standard output.

#include <filesystem>
#include <fstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

TEST_CASE("Missing fonts are exit code 3 and the message names the package, and nothing is written") {
  const Untouched out;
  const Folder empty;
  check_failure("render figure-5" + out.option, 3,
                {(empty.path() / "DejaVuSans.ttf").string(), "fonts-dejavu-core", "GJKSTEP_FONT_DIR"},
                "GJKSTEP_FONT_DIR=" + quoted(empty.path().string()));
}

TEST_CASE("A folder that cannot be made is exit code 5 and the message names it") {
  const Folder folder;
  const fs::path file = folder.path() / "a file";
  std::ofstream(file) << "mine";
  check_failure("render figure-5 --out " + quoted(file.string()), 5, {file.string(), "--out"});
  CHECK(bytes_of(file) == "mine");
  CHECK(listing(folder.path()) == std::vector<std::string>{"a file"});
}

TEST_CASE("A frame that cannot be written is exit code 5, and nothing half-written is left") {
  const Folder folder;
  fs::create_directories(folder.path() / "figure-5" / "000.png" / "in the way");
  check_failure("render figure-5 --size 32x18 --out " + quoted(folder.path().string()), 5, {"000.png"});
  CHECK(listing(folder.path()).empty());
}

TEST_CASE("A frame that is larger than files may be is exit code 5, and nothing is left of it") {
  const Folder folder;
  const std::string out = quoted(folder.path().string());
  const int status = std::system(
      ("ulimit -f 1; " + quoted(kit::program()) + " render figure-5 --size 640x360 --out " + out + " >/dev/null 2>&1")
          .c_str());
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 5);
  CHECK(listing(folder.path()).empty());
}

TEST_CASE("Captions that cannot be written are exit code 5 before anything is drawn") {
  const Folder folder;
  for (const std::string& captions : {(folder.path() / "no" / "where").string(), std::string("/dev/full")}) {
    const Outcome outcome =
        run("render figure-5 --size 32x18 --captions " + quoted(captions) + " --out " + quoted(folder.path().string()));
    CHECK(outcome.exit_code == 5);
    CHECK(has(outcome.err, "cannot write " + captions));
    CHECK(listing(folder.path()).empty());
  }
}

TEST_CASE("Captions may lie beside the pictures, in a folder that the run makes") {
  const Folder folder;
  const std::string out = (folder.path() / "out").string();
  CHECK(run("render figure-5 --size 32x18 --captions " + quoted(out + "/figure-5/captions.json") + " --out " +
            quoted(out))
            .exit_code == 0);
  CHECK(std::filesystem::exists(out + "/figure-5/captions.json"));
}

TEST_CASE("Standard output that is full is exit code 5") {
  for (const char* command : {"trace figure-4-left", "list", "--version", "--help"}) {
    INFO(command);
    const Outcome outcome = run(command, "", {.out = "/dev/full", .err = ""});
    CHECK(outcome.exit_code == 5);
    CHECK(outcome.err ==
          "gjkstep: cannot write to standard output: No space left on device; make room on the disk, or "
          "write to another one\n");
  }
}

namespace {

/// Runs the program with nobody who reads what it prints.
Outcome run_unread(const std::string& arguments) {
  const Folder folder;
  const fs::path err = folder.path() / "stderr", code = folder.path() / "code";
  // The reader has ended before the program begins.
  const std::string command = "{ sleep 0.1; " + quoted(kit::program()) + " " + arguments + " 2>" +
                              quoted(err.string()) + "; echo $? >" + quoted(code.string()) + "; } | true";
  REQUIRE(std::system(command.c_str()) == 0);
  return {std::stoi(bytes_of(code)), "", bytes_of(err)};
}

}  // namespace

TEST_CASE("Who does not read what is printed is told so, and what was asked for ends") {
  const Folder folder;
  const std::string out = " --out " + quoted(folder.path().string());
  for (const std::string& command : {std::string("trace cycle-intersecting"), std::string("list"),
                                     std::string("--help"), "render --all --size 32x18" + out}) {
    INFO(command);
    const Outcome outcome = run_unread(command);
    CHECK(outcome.exit_code == 5);
    CHECK(outcome.err ==
          "gjkstep: cannot write to standard output: Broken pipe; who reads it has left before the end; "
          "let it read all\n");
  }
  CHECK(listing(folder.path()).size() < 20);
}

TEST_CASE("Folders whose names are no UTF-8 are no obstacle to any format, and captions show U+FFFD in their place") {
  const Folder folder;
  const std::string captions = (folder.path() / "captions.json").string(), out = folder.path().string() + "/o\xff";
  const Outcome outcome = run("render figure-5 --size 32x18 --rendered-by --page --captions " + quoted(captions) +
                              " --movie mp4 --out " + quoted(out));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(bytes_of(captions), "/o\ufffd/figure-5/000.png\""));
  CHECK_FALSE(has(outcome.out, "\xff"));
  CHECK(has(outcome.out, R"-(/o'"$(printf '\377')"'/figure-5/%03d.png')-"));
}
