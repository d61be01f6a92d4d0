// Two files of one run at one place: refused before anything is written, however the places are spelt.

#include "walkthroughs/program/places.hpp"

#include <filesystem>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/program/exit_code.hpp"

namespace places_test {

using namespace walkthroughs::program;
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
  kit::write(file, "mine");
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

}  // namespace places_test
