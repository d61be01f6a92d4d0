// Two files of one run at one place: refused before anything is written, however the places are spelt.

#include "walkthroughs/program/places.hpp"

#include <filesystem>
#include <fstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/program/exit_code.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

/// Whether what is written to `file` would be refused beside the pictures in `folder`.
bool is_refused(const fs::path& folder, const fs::path& file) {
  Places places;
  places.write_into(folder, {"###.png", "###-turn-#.png", "sheet.pdf"}, "the pictures");
  places.write(file, "the captions");
  try {
    places.expect_apart();
    return false;
  } catch (const UsageError& error) {
    CHECK(has(error.what(), "the pictures"));
    CHECK(has(error.what(), "the captions"));
    return true;
  }
}

}  // namespace

TEST_CASE(
    "Where pictures are written nothing else may be named as one, and nothing may take the place of the folders") {
  for (const char* file : {"out/a/000.png", "out/a/999-turn-2.png", "out/a/sheet.pdf", "out/a/sheet.pdf/b", "out/a",
                           "out", "./out/b/../a/000.png", "out//a/./000.png"}) {
    INFO(file);
    CHECK(is_refused("out/a", file));
  }
  for (const char* file :
       {"captions.json", "out/captions.json", "out/a/captions.json", "out/000.png", "out/a/my-sheet.pdf",
        "out/a/photo.png", "out/b/000.png", "out/a/b/000.png", "ou", "out/aa"}) {
    INFO(file);
    CHECK_FALSE(is_refused("out/a", file));
  }
}

TEST_CASE("Links to folders are followed, also to those that are not there yet, and links in a ring do no harm") {
  const Folder folder;
  const fs::path root = folder.path();
  fs::create_directory_symlink(root / "out", root / "link");
  fs::create_directory_symlink("../" + root.filename().string() + "/link", root / "again");
  fs::create_directory_symlink("ring/ring", root / "ring");
  fs::create_symlink("out/a/000.png", root / "picture");
  CHECK(is_refused(root / "out/a", root / "link/a/000.png"));
  CHECK(is_refused(root / "again/a", root / "link/a/000.png"));
  CHECK_FALSE(is_refused(root / "out/a", root / "ring/a/000.png"));
  CHECK(is_refused(root / "out/a", root / "picture"));
}

TEST_CASE("A link to what else is written is not written over, such as /dev/stdout where that is a file") {
  const Folder folder;
  fs::create_symlink("printed", folder.path() / "stdout");
  Places places;
  places.write(folder.path() / "printed", "standard output");
  places.expect_apart();
  places.write(folder.path() / "stdout", "the captions");
  CHECK_THROWS_AS(places.expect_apart(), UsageError);
}

TEST_CASE("What is read is not written over, by neither of its names, and may be read twice") {
  const Folder folder;
  const fs::path file = folder.path() / "file", link = folder.path() / "link";
  std::ofstream(file) << "mine";
  fs::create_symlink(file, link);
  for (const fs::path& written : {file, link}) {
    Places places;
    places.read(link, "the scene");
    places.read(link, "the scene");
    places.expect_apart();
    places.write(written, "the captions");
    CHECK_THROWS_AS(places.expect_apart(), UsageError);
  }
}

TEST_CASE("Two files, two folders of pictures, or a file and the folder of another have not the same place") {
  const auto expect_refused = [](const auto& add) {
    Places places;
    add(places);
    CHECK_THROWS_AS(places.expect_apart(), UsageError);
  };
  expect_refused([](Places& p) { p.write("a", "one"), p.write("./a", "two"); });
  expect_refused([](Places& p) { p.write("a", "one"), p.write("a/b", "two"); });
  expect_refused([](Places& p) { p.read("a", "one"), p.write("a/b", "two"); });
  expect_refused([](Places& p) { p.write_into("a", {}, "one"), p.write_into("b/../a", {}, "two"); });
  expect_refused([](Places& p) { p.write_into("a", {"###.png"}, "one"), p.write_into("a/100.png", {}, "two"); });
  expect_refused([](Places& p) { p.read("a/000.png", "one"), p.write_into("a", {"###.png"}, "two"); });
}

TEST_CASE(
    "Captions in the place of a picture, a note, a scene, a trace or the output are exit code 2 before a picture") {
  const Folder folder;
  const std::string root = folder.path().string(), scene = quoted(scene_file(folder.path() / "s.json").string());
  CHECK(run("trace " + scene, "", {.out = root + "/t", .err = ""}).exit_code == 0);
  const std::string before = bytes_of(root + "/s.json");
  const auto expect_refused = [&](const std::string& words, const std::string& captions, const Streams& streams = {}) {
    const Outcome outcome = run("render --rendered-by --strip --apng --out " + quoted(root + "/out") + " --captions " +
                                    quoted(root + captions) + " " + words,
                                "", streams);
    INFO(captions << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "have the same place, "));
    CHECK(has(outcome.err, "--captions"));
    CHECK_FALSE(fs::exists(root + "/out"));
  };
  for (const char* name : {"000.png", "animation.png", "strip.png", "../figure-5/000.png"})
    expect_refused("figure-5", std::string("/out/figure-5/") + name);
  expect_refused("figure-5", "/./out/rendered-by.json");
  expect_refused(scene, "/s.json");
  expect_refused("--from-trace " + quoted(root + "/t"), "/t");
  expect_refused("figure-5", "/log", {.out = root + "/log", .err = ""});
  CHECK(bytes_of(root + "/s.json") == before);
}

TEST_CASE("Captions in the place of any file that any format writes are exit code 2, and the file stays") {
  const Folder folder;
  const std::string root = folder.path().string(), scene = quoted(scene_file(folder.path() / "s.json").string());
  for (const std::string formats : {"--sheet=a4 --page", "--sheet --page=single"}) {
    const std::string command = "render " + scene + " --strip --apng --rendered-by --turn 1 " + formats + " --out " +
                                quoted(root + "/out") + " --captions ";
    REQUIRE(run(command + quoted(root + "/captions.json")).exit_code == 0);
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root + "/out")) {
      if (!entry.is_regular_file()) continue;
      ++files;
      const std::string before = bytes_of(entry.path());
      check_failure(command + quoted(entry.path().string()), 2, {"--captions", entry.path().string()});
      CHECK(bytes_of(entry.path()) == before);
    }
    CHECK(files > 5);
    fs::remove_all(root + "/out");
  }
}

TEST_CASE("The sheets of an earlier run are exit code 2 where they are the trace that is read, or the output") {
  const Folder folder;
  const std::string root = folder.path().string(), pdf = root + "/figure-5/sheet.pdf";
  fs::create_directories(folder.path() / "figure-5");
  REQUIRE(run("trace figure-5", "", {.out = pdf, .err = ""}).exit_code == 0);
  const std::string before = bytes_of(pdf), sheets = " --sheet=a4 --out " + quoted(root);
  check_failure("render --from-trace " + quoted(pdf) + sheets, 2, {"the trace ", pdf});
  CHECK(bytes_of(pdf) == before);
  CHECK(run("render figure-5" + sheets, "", {.out = pdf, .err = ""}).exit_code == 2);
}

TEST_CASE("Two walkthroughs whose folders are one, by a link, are exit code 2 before a picture") {
  const Folder folder;
  fs::create_directory_symlink("figure-5", folder.path() / "figure-6");
  check_failure("render figure-5 figure-6 --out " + quoted(folder.path().string()), 2, {"figure-5", "figure-6"});
  CHECK(fs::is_symlink(folder.path() / "figure-6"));
  CHECK_FALSE(fs::exists(folder.path() / "figure-5"));
}

TEST_CASE("Standard output that is the file to be read is exit code 2, and the file stays") {
  const Folder folder;
  const std::string scene = scene_file(folder.path() / "s.json").string(), before = bytes_of(scene);
  for (const std::string command : {"trace ", "scene --check "}) {
    const int status = std::system(
        (quoted(kit::program()) + " " + command + quoted(scene) + " >>" + quoted(scene) + " 2>/dev/null").c_str());
    CHECK(WEXITSTATUS(status) == 2);
  }
  const int status = std::system(
      (quoted(kit::program()) + " query <" + quoted(scene) + " >>" + quoted(scene) + " 2>/dev/null").c_str());
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(bytes_of(scene) == before);
}

TEST_CASE("A report in the place of a picture that is compared is exit code 2, and the picture stays") {
  const Folder folder;
  const fs::path one = folder.path() / "one", page = folder.path() / "index.html";
  CHECK(run("render figure-5 --size 32x18 --out " + quoted(one.string())).exit_code == 0);
  fs::copy_file(one / "figure-5/000.png", page);
  const std::string before = bytes_of(page);
  for (const std::string& report : {folder.path().string(), page.string()}) {
    check_failure("compare " + quoted((one / "figure-5/000.png").string()) + " " + quoted(page.string()) +
                      " --report " + quoted(report),
                  2, {"--report", page.string()});
    CHECK(bytes_of(page) == before);
  }
}
