// Files that the program has not written, or that were changed since, in the places of its outputs: none is lost.

#include <filesystem>
#include <map>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/output/manifest.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

/// A folder with a scene, into which all formats of one kind of page are written, and what stands there then.
struct Place {
  Folder folder;
  fs::path out = folder / "out";
  std::string scene = quoted(scene_file(folder / "mine.json"));

  std::string command(const std::string& options) const {
    return "render " + scene + " --size 32x18 --out " + quoted(out) + " " + options;
  }
  std::string all(const std::string& kind) const {
    const std::string sheet = kind == "single" ? " --sheet=a4" : " --sheet";
    return command("--strip --apng --rendered-by --turn 1 --captions " + quoted(out / "captions.json") + sheet +
                   " --page=" + kind);
  }
  std::map<std::string, std::string> content() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      files.emplace(entry.path().string(), entry.is_directory() ? "" : bytes_of(entry.path()));
    return files;
  }
  void expect_refused(const std::string& arguments, const fs::path& file,
                      const std::string& elsewhere = "--out") const {
    const std::map<std::string, std::string> before = content();
    check_failure(arguments, 2, {file.string() + " is not of gjkstep, or was changed since", elsewhere, "--force"});
    CHECK(content() == before);
  }
};

}  // namespace

TEST_CASE("Whatever is written anywhere is not written over what others have there, and --force writes it") {
  const std::string kind = GENERATE(as<std::string>(), "beside", "single");
  const Place model;
  REQUIRE(run(model.all(kind)).exit_code == 0);
  std::vector<std::string> names = kit::listing(model.out);
  CHECK(names.size() > 12);
  for (const char* beyond :
       {"mine/099.png", "mine/000-turn-9.png", "mine/page.css", "mine/000.png.unfinished", "compare.html"})
    names.emplace_back(beyond);
  if (kind == "single") names.insert(names.end(), {"mine/sheet-7.png", "mine/trace.jsonl", "mine/mine.json"});
  const Place place;
  for (const std::string& name : names) {
    INFO(name);
    const fs::path foreign = kit::write(place.out / name, "somebody else's");
    place.expect_refused(place.all(kind), foreign);
    fs::remove_all(place.out);
  }
  for (const std::string& name : names) kit::write(place.out / name, "somebody else's");
  check_failure(place.all(kind), 2, {", ", " more are not of gjkstep"});
  kit::write(place.out / "mine/notes.txt", "notes");
  CHECK(run(place.all(kind) + " --force").exit_code == 0);
  CHECK(bytes_of(place.out / "mine/notes.txt") == "notes");
  fs::remove(place.out / "mine/notes.txt");
  CHECK(kit::listing(place.out) == kit::listing(model.out));
  for (const std::string& name : kit::listing(place.out)) CHECK(bytes_of(place.out / name) != "somebody else's");
  CHECK(run(place.all(kind)).exit_code == 0);
  CHECK(lines(bytes_of(place.out / "mine/.gjkstep")).size() == kit::listing(place.out / "mine").size());
}

TEST_CASE("What was changed is not written over, what was not is, also with other options") {
  const Place place;
  for (const char* kind : {"beside", "single", "beside"}) REQUIRE(run(place.all(kind)).exit_code == 0);
  for (const std::string& name : kit::listing(place.out)) {
    INFO(name);
    const std::string before = bytes_of(place.out / name);
    if (name.starts_with("mine/sheet") && name != "mine/sheet.png") continue;  // which nothing here writes
    kit::write(place.out / name, before + "\n");
    place.expect_refused(place.all("beside"), place.out / name);
    kit::write(place.out / name, before);
  }
  for (const char* file : {"mine/notes.txt", "mine/photo.png", "mine/4.png", "mine/animation.mp4", "notes.txt"})
    kit::write(place.out / file, "in nobody's way");
  CHECK(run(place.command("--sheet=a4 --movie mp4 --detail step")).exit_code == 0);
  CHECK(run(place.all("single"), "", {.out = kit::write(place.folder / "log", "an older one"), .err = ""}).exit_code ==
        0);
  for (const char* file : {"mine/notes.txt", "mine/photo.png", "mine/4.png", "mine/animation.mp4", "notes.txt"})
    CHECK(bytes_of(place.out / file) == "in nobody's way");
}

TEST_CASE("Pictures and pages of earlier versions, which kept no manifest, are written over and removed") {
  const Place place;
  const std::string command = place.command("--strip --apng --sheet=a4 --turn 1 --page=single");
  REQUIRE(run(command).exit_code == 0);
  const std::vector<std::string> before = kit::listing(place.out);
  fs::copy_file(place.out / "mine/000.png", place.out / "mine/123.png");
  fs::copy_file(place.out / "mine/000.png", place.out / "mine/000-turn-5.png");
  fs::copy_file(place.out / "mine/sheet-1.png", place.out / "mine/sheet-8.png");
  for (const char* manifest : {".gjkstep", "mine/.gjkstep"}) fs::remove(place.out / manifest);
  place.expect_refused(command, place.out / "mine/sheet.pdf");  // which bears no mark
  fs::remove(place.out / "mine/sheet.pdf");
  CHECK(run(command).exit_code == 0);
  CHECK(kit::listing(place.out) == before);
}

TEST_CASE("Captions and reports elsewhere are not written over what others have there") {
  const Place place;
  const fs::path captions = kit::write(place.folder / "scene1.json", "{}"), other = place.folder / "scene#.json";
  place.expect_refused(place.command("--captions " + quoted(captions)), captions, "--captions");
  for (int i = 0; i < 2; ++i) CHECK(run(place.command("--captions " + quoted(other))).exit_code == 0);
  check_failure(place.command("--captions " + quoted(place.out / "mine/.gjkstep")), 2, {"--captions", ".gjkstep"});

  const std::string pictures = quoted(place.out) + " ", report = "compare " + pictures + pictures + "--report ";
  const fs::path page = kit::write(place.folder / "report/index.html", "<title>mine</title>");
  place.expect_refused(report + quoted(page.parent_path()), page, "--report");
  CHECK(run(report + quoted(page.parent_path()) + " --force").exit_code == 0);
  CHECK(run(report + quoted(page.parent_path())).exit_code == 0);
  kit::write(page, bytes_of(page) + "<!-- mine -->");
  place.expect_refused(report + quoted(page.parent_path()), page, "--report");
}

TEST_CASE("Two runs that share a folder know all files of both") {
  const Place place;
  const std::string program = quoted(kit::program()) + " ";
  const std::string one = place.all("beside"), other = place.command("--strip --page --theme dark");
  CHECK(shell(program + one + " & " + program + other + "; code=$?; wait $!; exit $code").exit_code == 0);
  CHECK(run(one).exit_code == 0);
}

TEST_CASE("Where no manifest can be written nothing else is, and a folder that is none of ours is named") {
  const Place place;
  fs::create_directories(place.out / "mine/.gjkstep");
  check_failure(place.command(""), 5, {(place.out / "mine/.gjkstep").string(), "Is a directory"});
  CHECK(kit::listing(place.out).empty());
}
