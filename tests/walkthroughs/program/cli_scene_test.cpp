// Scene files on the command line.

#include <filesystem>
#include <fstream>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/text/scene_texts.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

render::Size size_of(const fs::path& picture) { return render::read_png(picture).size(); }

}  // namespace

TEST_CASE("A scene file is rendered at the size that it asks for, beside walkthroughs at theirs") {
  const Folder folder;
  const fs::path scene = scene_file(folder.path() / "mine.json"), out = folder.path() / "out";
  const std::string words = "render figure-5 " + quoted(scene.string()) + " " + quoted(scene.string());
  const Outcome outcome = run(words + " --out " + quoted(out.string()));
  CHECK(outcome.exit_code == 0);
  CHECK(lines(outcome.out).size() == listing(out).size());  // once, though named twice
  CHECK(size_of(out / "mine" / "000.png") == render::Size{48, 27});
  CHECK(size_of(out / "figure-5" / "000.png") == render::Size{1280, 720});
  CHECK(run(words + " --size 64x36 --out " + quoted(out.string())).exit_code == 0);
  CHECK(size_of(out / "mine" / "000.png") == render::Size{64, 36});
}

TEST_CASE("A scene file may end in capitals") {
  const Folder folder;
  const fs::path scene = scene_file(folder.path() / "MINE.JSON"), out = folder.path() / "out";
  CHECK(run("trace " + quoted(scene.string())).exit_code == 0);
  CHECK(run("render " + quoted(scene.string()) + " --out " + quoted(out.string())).exit_code == 0);
  CHECK(fs::exists(out / "MINE" / "000.png"));
}

TEST_CASE("Two scene files that would write to the same folder are refused, and nothing is written") {
  const Folder folder;
  const std::string one = quoted(scene_file(folder.path() / "mine.json").string());
  const std::string other = quoted(scene_file(folder.path() / "other" / "mine.json").string());
  const std::string taken = quoted(scene_file(folder.path() / "figure-5.json").string());
  const Untouched untouched;
  check_failure("render " + one + " " + other + untouched.option, 2, {"other/mine.json", "--out"});
  check_failure("render --all " + taken + untouched.option, 2, {"figure-5", "--out"});
}

TEST_CASE("A scene file that is not there or says nothing is exit code 3, and nothing is written") {
  const Folder folder;
  const fs::path empty = folder.path() / "empty.json", missing = folder.path() / "missing.json";
  std::ofstream(empty).close();
  for (const fs::path& file : {empty, missing}) {
    const Untouched untouched;
    check_failure("render figure-5 " + quoted(file.string()) + untouched.option, 3, {file.filename().string()});
    check_failure("trace " + quoted(file.string()), 3, {file.filename().string()});
  }
}

TEST_CASE("gjkstep scene --example prints a scene that gjkstep scene --check accepts") {
  const Outcome example = run("scene --example");
  CHECK(example.exit_code == 0);
  CHECK(example.out == example_scene());
  const Written file(example.out);
  const Outcome checked = run("scene --check " + quoted(file.path.string()));
  CHECK(checked.exit_code == 0);
  CHECK(checked.out == file.path.string() + ": ok: " + summary(read_scene(file.path)) + "\n");
  CHECK(checked.err.empty());
}

TEST_CASE("gjkstep scene --check answers a bad scene with exit code 3 and the complaint alone") {
  const Written file(scene_text(corner, "{}"));
  const Outcome checked = run("scene --check " + quoted(file.path.string()));
  CHECK(checked.exit_code == 3);
  CHECK(checked.out.empty());
  CHECK(checked.err == "gjkstep: " + complaint_about_file(file.path) + "\n");
}

TEST_CASE("gjkstep scene says what it can do") {
  for (const char* arguments : {"", "--example --check x", "--check"}) {
    const Outcome outcome = run(std::string("scene ") + arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("--check") != std::string::npos);
  }
}
