#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "render/compare.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/pictures.hpp"
#include "tests/kit/text.hpp"

namespace compare_files_test {

using namespace render;
using kit::has, kit::write;
namespace fs = std::filesystem;

namespace {

/// Two empty folders.
struct Folders {
  kit::Folder root;
  fs::path expected = root / "expected", actual = root / "actual";

  Folders() {
    fs::create_directories(expected);
    fs::create_directories(actual);
  }
};

void draw(const fs::path& file, Color color, Size size = {16, 9}) {
  fs::create_directories(file.parent_path());
  write_file(file, encode_png(kit::plain(size, color), {}));
}

std::vector<Verdict> verdicts(const Folders& folders) {
  std::vector<Verdict> list;
  for (const FilePair& pair : file_pairs(folders.expected, folders.actual)) list.push_back(compare_files(pair).verdict);
  return list;
}

}  // namespace

// -- Folders ------------------------------------------------------------------------------------------------------------

TEST_CASE("The pictures of a folder are its .png and .PNG files and those of folders below by name") {
  const Folders folders;
  for (const char* name : {"b.png", "a/z.png", "a/deep/er.PNG", "c.Png", ".png.png"})
    draw(folders.expected / name, {1, 2, 3});
  for (const char* name : {"notes.txt", "rendered-by.json", "png", "a.png.bak", ".png"})
    write(folders.expected / name, "{}");
  fs::create_directories(folders.expected / "folder.png");
  const std::vector<std::string> names{".png.png", "a/deep/er.PNG", "a/z.png", "b.png", "c.Png"};
  CHECK(pictures_in(folders.expected) == names);
  CHECK(pictures_in(folders.expected.string() + "/") == names);
}

TEST_CASE("Links to folders are followed, and what is in them is compared") {
  const Folders folders;
  for (const auto& [side, color] : {std::pair{folders.expected, Color{10, 10, 10}}, {folders.actual, {10, 10, 20}}}) {
    const fs::path elsewhere = folders.root / (side.filename().string() + " elsewhere");
    draw(elsewhere / "deep" / "a.png", color);
    fs::create_directory_symlink(elsewhere, side / "one");
    fs::create_directory_symlink(elsewhere / "deep", side / "other.png");
  }
  CHECK(pictures_in(folders.expected) == std::vector<std::string>{"one/deep/a.png", "other.png/a.png"});
  CHECK(verdicts(folders) == std::vector{Verdict::different, Verdict::different});
}

TEST_CASE("A link that leads back to a folder around it is refused by name, and the other pictures are compared") {
  const Folders folders;
  const fs::path elsewhere = folders.root / "elsewhere";
  for (const fs::path& side : {folders.expected, folders.actual}) draw(side / "sub/a.png", {1, 2, 3});
  fs::create_directory_symlink(".", folders.expected / "here");
  fs::create_directory_symlink(folders.expected, folders.expected / "sub/up");
  fs::create_directory_symlink(elsewhere, folders.actual / "away");
  fs::create_directories(elsewhere);
  fs::create_directory_symlink(folders.actual, elsewhere / "back");
  CHECK(pictures_in(folders.expected) == std::vector<std::string>{"here", "sub/a.png", "sub/up"});
  CHECK(pictures_in(folders.actual) == std::vector<std::string>{"away/back", "sub/a.png"});
  fs::create_directory_symlink(folders.root.path(), elsewhere / "above");  // which is not around it, but holds what is
  CHECK(std::ranges::count(pictures_in(folders.actual), "away/above/actual") == 1);
  fs::remove(elsewhere / "above");
  for (const FilePair& pair : file_pairs(folders.expected, folders.actual)) {
    const ComparedFiles compared = compare_files(pair);
    INFO(compared.words);
    CHECK(compared.verdict == (pair.name == "sub/a.png" ? Verdict::same : Verdict::unreadable));
    CHECK(has(compared.words, pair.name == "sub/a.png" ? "equal" : pair.name + ": a link makes it lead back"));
  }
}

TEST_CASE("Links to folders of links cannot make a walk without end") {
  const Folders folders;
  for (int i = 0; i < 12; ++i) {  // 4096 ways
    const fs::path folder = folders.root / std::to_string(i), next = folders.root / std::to_string(i + 1);
    fs::create_directories(folder);
    for (const char* name : {"a", "b"}) fs::create_directory_symlink(next, folder / name);
  }
  fs::create_directories(folders.root / "12");
  CHECK_THROWS_AS(pictures_in(folders.root / "0"), ReadError);
}

TEST_CASE("A link that leads nowhere is told whatever its name is, as it may have led to a folder") {
  const Folders folders;
  for (const fs::path& side : {folders.expected, folders.actual}) {
    draw(side / "a.png", {1, 2, 3});
    fs::create_symlink("gone", side / "link");
    fs::create_symlink("round", side / "round");
    fs::create_symlink("/gone/sub", side / "figures.old");
    fs::create_symlink("self.v2", side / "self.v2");
    write(side / "notes.txt", "no picture");
    fs::create_symlink("notes.txt", side / "linked-notes.txt");
  }
  CHECK(pictures_in(folders.actual) == std::vector<std::string>{"a.png", "figures.old", "link", "round", "self.v2"});
  CHECK(verdicts(folders) ==
        std::vector{Verdict::same, Verdict::unreadable, Verdict::unreadable, Verdict::unreadable, Verdict::unreadable});
}

/// Root may read everything.
class NotRoot {
 public:
  NotRoot() {
    constexpr uid_t nobody = 65534;
    if (was_root_) REQUIRE(seteuid(nobody) == 0);
  }
  ~NotRoot() {
    if (was_root_ && seteuid(0) != 0) std::abort();
  }
  NotRoot(const NotRoot&) = delete;
  NotRoot& operator=(const NotRoot&) = delete;

 private:
  const bool was_root_ = geteuid() == 0;
};

TEST_CASE("A folder that may not be read is told by its name, and the other pictures are compared") {
  const Folders folders;
  for (const fs::path& side : {folders.expected, folders.actual}) {
    draw(side / "a.png", {1, 2, 3});
    draw(side / "sub/b.png", {1, 2, 3});
    fs::permissions(side / "sub", fs::perms::none);
  }
  fs::permissions(folders.root.path(), fs::perms::all);
  {
    const NotRoot not_root;
    CHECK(verdicts(folders) == std::vector{Verdict::same, Verdict::unreadable});
    CHECK(has(compare_files(file_pairs(folders.expected, folders.actual)[1]).words,
              "sub: Permission denied; check that it may be read"));
  }
  for (const fs::path& side : {folders.expected, folders.actual}) fs::permissions(side / "sub", fs::perms::owner_all);
}

TEST_CASE("Folders in one another, more than files may be open, are walked") {
  const Folders folders;
  fs::path deep = folders.expected;
  for (int i = 0; i < 100; ++i) deep /= "d";
  draw(deep / "a.png", {1, 2, 3});
  rlimit before;
  getrlimit(RLIMIT_NOFILE, &before);
  const rlimit few{40, before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &few);
  CHECK(pictures_in(folders.expected) == std::vector{(deep / "a.png").lexically_relative(folders.expected).string()});
  setrlimit(RLIMIT_NOFILE, &before);
}

TEST_CASE("What cannot be read is told so whatever it is and the other pictures are compared") {
  const Folders folders;
  for (const fs::path& side : {folders.expected, folders.actual}) draw(side / "good.png", {1, 2, 3});
  for (const char* name : {"damaged.png", "dangling.png", "empty.png", "loop.png", "pipe.png", "to-folder.png"})
    draw(folders.expected / name, {1, 2, 3});
  draw(folders.actual / "damaged.png", {1, 2, 3});
  fs::resize_file(folders.actual / "damaged.png", fs::file_size(folders.actual / "damaged.png") / 2);
  fs::create_symlink("nowhere.png", folders.actual / "dangling.png");
  write(folders.actual / "empty.png", "");
  fs::create_symlink("loop.png", folders.actual / "loop.png");
  REQUIRE(mkfifo((folders.actual / "pipe.png").c_str(), 0600) == 0);
  fs::create_directory_symlink(folders.actual, folders.actual / "to-folder.png");
  int unreadable = 0;
  for (const FilePair& pair : file_pairs(folders.expected, folders.actual)) {
    const ComparedFiles compared = compare_files(pair);
    INFO(pair.name << ": " << compared.words);
    CHECK(compared.verdict == (pair.name == "good.png" ? Verdict::same : Verdict::unreadable));
    if (compared.verdict != Verdict::unreadable) continue;
    ++unreadable;
    CHECK(has(compared.words, pair.actual.string()));
  }
  CHECK(unreadable == 6);
}

TEST_CASE("A picture that only one side has is read all the same and may be unreadable") {
  const Folders folders;
  write(folders.expected / "a.png", "no picture");
  draw(folders.actual / "b.png", {1, 2, 3});
  CHECK(verdicts(folders) == std::vector{Verdict::unreadable, Verdict::extra});
}

}  // namespace compare_files_test
