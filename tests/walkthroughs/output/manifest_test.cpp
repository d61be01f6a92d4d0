// What the program knows to be its own, by the manifest of a folder.

#include "walkthroughs/output/manifest.hpp"

#include <filesystem>
#include <thread>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/text.hpp"

namespace manifest_test {

using namespace walkthroughs::program;
using kit::bytes_of, kit::Folder, kit::has;
namespace fs = std::filesystem;

namespace {

bool is_ours(const fs::path& file) { return files_of_others(file).empty(); }

std::string manifest_of(const Folder& folder) { return bytes_of(folder / manifest_file); }

}  // namespace

TEST_CASE("Patterns take a digit for each #, and any more for the last of a row") {
  for (const auto& [pattern, name] : {std::pair("###.png", "000.png"),
                                      {"###.png", "12345.png"},
                                      {"###-turn-#.png", "001-turn-12.png"},
                                      {"sheet-#.png", "sheet-1.png"},
                                      {"page.css", "page.css"},
                                      {"*.json", "any.json"},
                                      {"#", "7"},
                                      {"", ""}})
    CHECK(fits(pattern, name));
  for (const auto& [pattern, name] : {std::pair("###.png", "04.png"),
                                      {"###.png", "photo.png"},
                                      {"###.png", "000.png.txt"},
                                      {"###.png", "x000.png"},
                                      {"###-turn-#.png", "000-turn-.png"},
                                      {"###-turn-#.png", "000.png"},
                                      {"sheet-#.png", "sheet.png"},
                                      {"sheet-#.png", "sheet-x.png"},
                                      {"page.css", "page"},
                                      {"page", "page.css"},
                                      {"*.json", "any.json.bak"},
                                      {"#", ""},
                                      {"", "7"}})
    CHECK_FALSE(fits(pattern, name));
}

TEST_CASE("A file is ours as it was written, and of others when it was changed, or when somebody else has written it") {
  const Folder folder;
  for (const std::string name : {"a.json", "two\nlines", "no UTF-8 \xff", "#", "with blanks "}) {
    const fs::path file = folder / name;
    CHECK(is_ours(file));
    kit::write(file, "mine");
    CHECK(files_of_others(file) == std::vector{file});
    write_output(file, "ours");
    CHECK(is_ours(file));
    kit::write(file, "our5");
    CHECK_FALSE(is_ours(file));
    adopt(file);
    CHECK(is_ours(file));
    tidy_manifest(folder.path());
    CHECK(is_ours(file));
  }
}

TEST_CASE("Links and files that cannot be read are of others until they are adopted; folders are not lost") {
  const Folder folder;
  fs::create_directories(folder / "000.png/inside");
  CHECK(is_ours(folder / "000.png"));
  fs::create_symlink("nowhere", folder / "001.png");
  CHECK(files_of_others(folder.path(), {"###.png"}) == std::vector{folder / "001.png"});
  adopt(folder / "001.png");
  CHECK(is_ours(folder / "001.png"));
  remove_outputs(folder.path(), {"###.png"});
  CHECK_FALSE(fs::is_symlink(folder / "001.png"));
  CHECK(fs::exists(folder / "000.png/inside"));
}

TEST_CASE("Where a run was killed before it replaced a file the old one and the new one are ours") {
  const Folder folder;
  const fs::path file = folder / "a.json", beside = folder / "a.json.unfinished";
  write_output(file, "old");
  write_output(file, "new");
  kit::write(file, "old");
  kit::write(beside, "new");
  CHECK(is_ours(file));
  kit::write(beside, "mine");
  CHECK(files_of_others(file) == std::vector{beside});
  CHECK(files_of_others(folder.path(), {"a.json"}) == std::vector{beside});
}

TEST_CASE(
    "What is tidied has one line for each file that is there, the lines of one that was changed, and those of others") {
  const Folder folder;
  const std::string foreign = "some words\n12345678 9\n1234567g 9 name\n12345678 x name\nsome words\n";
  kit::write(folder / manifest_file, foreign + "00000000 5 torn");
  for (const char* content : {"first", "second", "third", "third"})
    for (const char* name : {"same", "changed", "gone"}) write_output(folder / name, content);
  kit::write(folder / "changed", "mine");
  fs::remove(folder / "gone");
  tidy_manifest(folder.path());
  const std::string tidied = manifest_of(folder);
  CHECK(tidied.starts_with(foreign));
  CHECK(kit::lines(tidied).size() == 5 + 3 + 1);
  CHECK(has(tidied, "\n24322064 5 same\n"));  // the CRC-32 of "third"
  CHECK(is_ours(folder / "same"));
  CHECK_FALSE(is_ours(folder / "changed"));
  tidy_manifest(folder.path());
  CHECK(manifest_of(folder) == tidied);
}

TEST_CASE("A folder without a manifest gets none from tidying, and where none can be written nothing is") {
  const Folder folder;
  tidy_manifest(folder.path());
  CHECK(fs::is_empty(folder.path()));
  fs::create_directories(folder / manifest_file);
  CHECK_THROWS_WITH(write_output(folder / "a.json", "ours"), kit::contains((folder / manifest_file).string()));
  CHECK_FALSE(fs::exists(folder / "a.json"));
}

TEST_CASE("A line that a full disk has cut short is no harm to the next one") {
  const Folder folder;
  kit::write(folder / manifest_file, "0123");
  write_output(folder / "a.json", "ours");
  CHECK(is_ours(folder / "a.json"));
}

TEST_CASE("Removed is what fits, is ours and is not kept") {
  const Folder folder;
  for (const char* name : {"000.png", "001.png", "050.png", "notes.txt"}) write_output(folder / name, "ours");
  kit::write(folder / "002.png", "mine");
  kit::write(folder / "050.png", "changed");
  write_output(folder / "003.png", "ours");
  remove_outputs(folder.path(), {"###.png"}, {"000.png"});
  CHECK(kit::listing(folder.path()) == std::vector<std::string>{"000.png", "002.png", "050.png", "notes.txt"});
}

TEST_CASE("Runs that write to one folder at once, and tidy it, know all files of both") {
  const Folder folder;
  const auto run = [&](const std::string& content) {
    for (int i = 0; i < 100; ++i) {
      for (const char* name : {"000.png", "001.png", "002.png"})
        write_output(folder / name, content + std::to_string(i));
      tidy_manifest(folder.path());
    }
  };
  std::thread other(run, "other");
  run("one");
  other.join();
  CHECK(files_of_others(folder.path(), {"###.png"}).empty());
  CHECK(kit::lines(manifest_of(folder)).size() == 3);
}

}  // namespace manifest_test
