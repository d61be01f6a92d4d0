// The program as its users run it. GJKSTEP_PROGRAM is its path, given by the build.

#include <poll.h>
#include <pty.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "render/image.hpp"
#include "render/offscreen_context.hpp"
#include "tests/catch.hpp"
#include "tests/walkthroughs/program.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// A folder that must not come into being.
struct Untouched {
  Folder parent;
  fs::path folder = parent.path() / "out";
  std::string option = " --out " + quoted(folder.string());
  ~Untouched() { CHECK_FALSE(fs::exists(folder)); }
};

/// A terminal without a screen.
class Terminal {
 public:
  Terminal() {
    char name[64];
    if (openpty(&controller_, &terminal_, name, nullptr, nullptr) != 0)
      throw std::runtime_error("no pseudo terminal: is /dev/pts mounted?");
    name_ = name;
  }
  ~Terminal() {
    close(terminal_);
    close(controller_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  const std::string& name() const { return name_; }

  /// Returns: whether `part` was written. What was written may still be on its way when the writer has ended.
  bool shows(const std::string& part) {
    constexpr int milliseconds = 10000;
    pollfd ready{.fd = controller_, .events = POLLIN, .revents = 0};
    char more[256];
    while (!has(text_, part) && poll(&ready, 1, milliseconds) == 1) {
      const ssize_t length = read(controller_, more, sizeof more);
      if (length <= 0) break;
      text_.append(more, static_cast<std::size_t>(length));
    }
    return has(text_, part);
  }

 private:
  int controller_ = -1, terminal_ = -1;
  std::string name_, text_;
};

}  // namespace

// -- What works -------------------------------------------------------------------------------------------------------

TEST_CASE("gjkstep list prints each walkthrough with its summary, one line each, folder by folder") {
  const Outcome outcome = run("list");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  std::vector<std::string> printed = lines(outcome.out);
  std::set<std::string> folders;
  for (const Walkthrough& w : catalogue()) folders.insert(fs::path(w.name).parent_path().string());
  CHECK(std::erase(printed, "") == folders.size() - 1);
  REQUIRE(printed.size() == catalogue().size());
  for (const Walkthrough& w : catalogue())
    CHECK(std::ranges::count_if(printed, [&](const std::string& line) {
            return line.starts_with(w.name + "  ") && line.ends_with("  " + w.summary);
          }) == 1);
}

TEST_CASE("gjkstep list NAME prints a table: name, case, section, how the search ends, number of frames") {
  const std::vector<std::string> printed = lines(run("list figure-4-right").out);
  REQUIRE(printed.size() == 2);
  CHECK(words(printed[0]) == std::vector<std::string>{"name", "case", "section", "status", "frames"});
  CHECK(printed[1].starts_with("figure-4-right  the origin is not crossed at E"));
  CHECK(words(printed[1]).at(words(printed[1]).size() - 2) == "separated");
  CHECK(words(printed[1]).back() == "6");
  CHECK(printed[0].size() == printed[1].size());
}

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

TEST_CASE("The option --version prints the version and the OpenGL renderer") {
  const Outcome outcome = run("--version");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.starts_with("gjkstep 0."));
  CHECK(has(outcome.out, "OpenGL "));
}

TEST_CASE("The option --gl chooses what draws, and beats the variable GJKSTEP_GL, which beats the default") {
  const auto titled = [](render::Backend backend) {
    return backend == render::Backend::osmesa ? ", OSMesa\n" : ", EGL surfaceless\n";
  };
  CHECK(run("--version").out.ends_with(titled(render::default_backend())));
  CHECK(run("--version", "GJKSTEP_GL=").out.ends_with(titled(render::default_backend())));
  for (const render::Backend backend : render::built_in_backends()) {
    const std::string name(render::name_of(backend));
    CHECK(run("--version --gl " + name).out.ends_with(titled(backend)));
    CHECK(run("--version", "GJKSTEP_GL=" + name).out.ends_with(titled(backend)));
    for (const std::string other : {"osmesa", "egl", "nonsense"})
      CHECK(run("--version --gl " + name, "GJKSTEP_GL=" + other).out.ends_with(titled(backend)));
  }
}

TEST_CASE("The same frames are drawn, whatever draws them") {
  const Folder folder;
  const std::string names = "render figure-2 figure-4-left regions/3-simplex-inside --strip --sheet --size 640x360 ";
  const auto drawn_with = [&](render::Backend backend) {
    const fs::path out = folder.path() / render::name_of(backend);
    CHECK(run(names + "--gl " + std::string(render::name_of(backend)) + " --out " + quoted(out.string())).exit_code ==
          0);
    return out;
  };
  const fs::path expected = drawn_with(render::default_backend());
  for (const render::Backend backend : render::built_in_backends()) {
    const fs::path actual = drawn_with(backend);
    REQUIRE(listing(actual) == listing(expected));
    for (const std::string& file : listing(expected)) {
      INFO(actual / file);
      CHECK(bytes_of(actual / file) == bytes_of(expected / file));
    }
  }
}

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

TEST_CASE("gjkstep render prints each file with its caption, and no progress without a terminal, and repeats itself") {
  const Folder first, second;
  const std::string names = "render figure-5 figure-4-right --strip --size 320x180 --out ";
  const Outcome outcome = run(names + quoted(first.path().string()));
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const std::vector<std::string> printed = lines(outcome.out);
  REQUIRE(printed.size() == 3 + 1 + 6 + 1);
  CHECK(printed[0] == (first.path() / "figure-5" / "000.png").string() +
                          "  In both sets the search goes from A along d, toward the origin.");
  CHECK(printed[4] == (first.path() / "figure-4-right" / "000.png").string() +
                          "  Along +x the farthest point of the difference is A.");
  CHECK(printed[10].starts_with((first.path() / "figure-4-right" / "strip.png").string() + "  "));
  CHECK(listing(first.path()).size() == printed.size());

  CHECK(run(names + quoted(second.path().string())).exit_code == 0);
  CHECK(listing(second.path()) == listing(first.path()));
  for (const std::string& file : listing(first.path()))
    CHECK(bytes_of(second.path() / file) == bytes_of(first.path() / file));
}

TEST_CASE("gjkstep render --all renders every walkthrough") {
  const Folder folder;
  const Outcome outcome = run("render --all --size 32x18 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  CHECK(lines(outcome.out).size() == listing(folder.path()).size());
  for (const Walkthrough& w : catalogue()) CHECK(fs::exists(folder.path() / w.name / "000.png"));
}

TEST_CASE("gjkstep render --detail step --captions writes a frame for each iteration, and all of them in words") {
  const Folder folder;
  const std::string out = quoted(folder.path().string()), json = quoted((folder.path() / "captions.json").string());
  const Outcome outcome =
      run("render figure-4-left --detail step --no-captions --size 64x36 --captions " + json + " --out " + out);
  CHECK(outcome.exit_code == 0);
  CHECK(listing(folder.path()).size() == 5);  // four frames and the file of captions
  CHECK(bytes_of(folder.path() / "captions.json").find("\"alternative_text\"") != std::string::npos);
  const Untouched untouched;
  check_failure("render figure-5 --detail both" + untouched.option, 2, {"--detail", "decision", "step"});
}

TEST_CASE("Captions that cannot be written are exit code 5") {
  const Folder folder;
  const Outcome outcome =
      run("render figure-5 --size 32x18 --captions " + quoted((folder.path() / "no" / "where").string()) + " --out " +
          quoted(folder.path().string()));
  CHECK(outcome.exit_code == 5);
  CHECK(has(outcome.err, "where"));
}

TEST_CASE("What the README shows is what the program prints") {
  const Folder folder;
  std::set<std::string> printed;
  for (const std::string& line : lines(run("list").out)) printed.insert(line);
  const std::string out = folder.path().string();
  for (const std::string& line : lines(run("render --all --strip --size 32x18 --out " + quoted(out)).out))
    printed.insert("out" + line.substr(out.size()));
  std::ifstream readme(GJKSTEP_README);
  int shown = 0;
  for (std::string line; std::getline(readme, line);) {
    const auto begins = [&](const char* start) { return line.starts_with(start); };
    if (!std::ranges::any_of(std::array{"out/figure-", "figure-", "cycle-", "as-printed", "regions/"}, begins))
      continue;
    INFO(line);
    CHECK(printed.count(line) == 1);
    ++shown;
  }
  CHECK(shown >= 9);
}

TEST_CASE("gjkstep render shows its progress on a terminal") {
  const Folder folder;
  Terminal terminal;
  const Outcome outcome = run("render figure-5 --size 32x18 --out " + quoted(folder.path().string()), "",
                              {.out = "", .err = terminal.name()});
  CHECK(outcome.exit_code == 0);
  CHECK(lines(outcome.out).size() == 3);
  CHECK(terminal.shows("figure-5: frame 1 of 3"));
  CHECK(terminal.shows("figure-5: frame 2 of 3"));
}

// -- Folders ----------------------------------------------------------------------------------------------------------

namespace {

/// Returns: a folder of the catalogue, or nothing where it has none.
std::string some_folder() {
  for (const Walkthrough& w : catalogue())
    if (const std::size_t slash = w.name.find('/'); slash != std::string::npos) return w.name.substr(0, slash);
  return "";
}

}  // namespace

TEST_CASE("A folder names all of its walkthroughs, which are written into folders of folders") {
  const std::string name = some_folder();
  if (name.empty()) return;
  const Folder folder;
  const Outcome outcome = run("render " + name + " --detail step --size 32x18 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  for (const Walkthrough* w : find_walkthroughs(name)) CHECK(fs::exists(folder.path() / w->name / "000.png"));
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("gjkstep list FOLDER prints a row for each walkthrough of the folder, the columns aligned") {
  const std::string name = some_folder();
  if (name.empty()) return;
  const Outcome outcome = run("list " + name);
  CHECK(outcome.exit_code == 0);
  const std::vector<std::string> printed = lines(outcome.out);
  const auto expected = find_walkthroughs(name);
  REQUIRE(printed.size() == 1 + expected.size());
  const std::size_t column = printed[0].find("case");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO(printed[i + 1]);
    CHECK(printed[i + 1].starts_with(expected[i]->name + " "));
    CHECK(printed[i + 1].substr(column - 2, 2) == "  ");
    CHECK(printed[i + 1][column] != ' ');
    if (expected[i]->region_case) CHECK(has(printed[i + 1], " " + expected[i]->region_case->section + " "));
  }
}

TEST_CASE("A folder has no trace, and neither has a diagram") {
  if (const std::string name = some_folder(); !name.empty())
    check_failure("trace " + name, 2, {quoted(name), "gjkstep list " + name});
  for (const Walkthrough& w : catalogue())
    if (w.layout == Layout::diagrams) check_failure("trace " + w.name, 2, {quoted(w.name), "diagram"});
}

// -- Animations and movies --------------------------------------------------------------------------------------------

namespace {

/// Returns: how often `part` stands in `text`.
int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

bool there_is(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// Returns: what a command for the shell prints.
std::string printed_by(const std::string& command) {
  const Folder folder;
  const std::string file = (folder.path() / "stdout").string();
  CHECK(std::system(("( " + command + " ) >" + quoted(file)).c_str()) == 0);
  return bytes_of(file);
}

}  // namespace

TEST_CASE("gjkstep render --apng writes an animation of all frames, the last one shown longer") {
  const Folder folder;
  const Outcome outcome =
      run("render figure-5 --apng --frame-time 0.5 --turn 2 --size 64x36 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  const fs::path own = folder.path() / "figure-5", animation = own / "animation.png";
  CHECK(listing(own) ==
        std::vector<std::string>{"000.png", "001.png", "002.png", "animation.png"});  // no views: planar
  REQUIRE(lines(outcome.out).size() == 4);
  CHECK(lines(outcome.out)[3].starts_with(animation.string() + "  "));
  CHECK(render::read_png(animation) == render::read_png(own / "000.png"));
  const std::string bytes = bytes_of(animation);
  CHECK(count(bytes, "fcTL") == 3);
  CHECK(count(bytes, std::string("\x01\xF4\x03\xE8", 4)) == 2);  // 500/1000 s
  CHECK(count(bytes, std::string("\x03\xE8\x03\xE8", 4)) == 1);  // 1000/1000 s
}

TEST_CASE("gjkstep render --movie prints a line for ffmpeg for each walkthrough, after the files") {
  const Folder folder;
  const fs::path out = folder.path() / "it's 100% mine";
  const std::string arguments = "render figure-5 figure-4-right --frame-time 0.4 --size 33x35 --theme dark --out ";
  const std::string shell_out = "'" + folder.path().string() + "/it'\\''s 100% mine";
  for (const std::string kind : {"mp4", "gif"}) {
    const Outcome outcome = run(arguments + shell_out + "' --movie " + kind);
    CHECK(outcome.exit_code == 0);
    const std::vector<std::string> printed = lines(outcome.out);
    REQUIRE(printed.size() == 3 + 6 + 2);
    for (const std::size_t i : {9u, 10u}) {
      const std::string name = i == 9 ? "figure-5" : "figure-4-right";
      CHECK(printed[i].starts_with("ffmpeg -y "));
      CHECK(has(printed[i], " -framerate 1000/400 "));
      CHECK(has(printed[i], "/it'\\''s 100%% mine/" + name + "/%03d.png'"));
      CHECK(printed[i].ends_with("/it'\\''s 100% mine/" + name + "/animation." + kind + "'"));
      CHECK(has(printed[i], kind == "gif" ? "palettegen" : "color=0x16191f"));
      if (there_is("ffmpeg")) {
        CHECK(printed_by(printed[i]).empty());
        CHECK(fs::file_size(out / name / ("animation." + kind)) > 0);
      }
    }
  }
  if (!there_is("ffmpeg") || !there_is("ffprobe")) return;
  const std::string probe = "ffprobe -v error -show_entries stream=width,height,pix_fmt:format=duration -of csv=p=0 ";
  const std::string mp4 = printed_by(probe + shell_out + "/figure-5/animation.mp4'");
  CHECK(has(mp4, "34,36,yuv420p"));
  CHECK(has(mp4, "1.6"));  // three frames, the last one twice as long
  CHECK(has(printed_by(probe + shell_out + "/figure-5/animation.gif'"), "1.6"));
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

TEST_CASE("The theme decides the colour of the paper") {
  const Folder folder;
  for (const std::string theme : {"report", "slides", "dark"}) {
    const fs::path out = folder.path() / theme;
    CHECK(run("render figure-5 --size 64x36 --theme " + theme + " --out " + quoted(out.string())).exit_code == 0);
    const render::Color paper = theme == "dark" ? render::themes::dark.paper : render::palette::white;
    CHECK(render::read_png(out / "figure-5" / "000.png").pixel(0, 0) == paper);
  }
}

TEST_CASE("gjkstep render --turn adds views of frames in space, and removes those of an earlier run with more") {
  const auto& all = catalogue();
  const auto space = std::ranges::find_if(
      all, [](const Walkthrough& w) { return !w.scenes.empty() && w.scenes[0].dimension == Dimension::space; });
  if (space == all.end()) return;
  const Folder folder;
  const fs::path own = folder.path() / space->name;
  const std::string command = "render " + space->name + " --size 160x90 --out " + quoted(folder.path().string());
  const std::size_t frames = tell(*space).frames.size();
  for (const int turns : {3, 1, 0}) {
    CHECK(run(command + " --turn " + std::to_string(turns)).exit_code == 0);
    CHECK(listing(own).size() == frames * static_cast<std::size_t>(1 + turns));
    for (int turn = 1; turn <= turns; ++turn) {
      const fs::path view = own / ("000-turn-" + std::to_string(turn) + ".png");
      REQUIRE(fs::exists(view));
      CHECK(render::read_png(view) != render::read_png(own / "000.png"));
    }
  }
}

// -- Scene files ------------------------------------------------------------------------------------------------------

namespace {

/// A scene file of that name: a square and a triangle in the plane, to be drawn at 48x27.
fs::path scene_file(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << R"({"dimension": 2, "size": "48x27",
    "a": {"points": [[0, 0], [2, 0], [2, 2], [0, 2]]}, "b": {"points": [[1, 1], [3, 1], [3, 3]]}})";
  return file;
}

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

TEST_CASE("A scene file has a trace") {
  const Folder folder;
  const Outcome outcome = run("trace " + quoted(scene_file(folder.path() / "mine.json").string()));
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, R"("walkthrough":"mine")"));
  CHECK(lines(outcome.out).size() > 3);
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
  CHECK(has(bytes_of(GJKSTEP_README), "gjkstep: " + said.substr(0, said.find("itself:") + 7)));
}

TEST_CASE("gjkstep trace --schema prints a JSON Schema") {
  const Outcome outcome = run("trace --schema");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.starts_with("{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\""));
  check_failure("trace --schema figure-5", 2, {"--schema"});
}

TEST_CASE("A trace that is not there, is cut off or contradicts itself is exit code 3, and nothing is written") {
  for (const std::string file : {"missing", "bad-cut-in-line", "bad-version-1", "bad-not-a-minus-b"}) {
    const Untouched untouched;
    const fs::path trace = fs::path(GJKSTEP_TRACES) / (file + ".jsonl");
    check_failure("render figure-5 --from-trace " + quoted(trace.string()) + untouched.option, 3, {file + ".jsonl"});
  }
}

// -- Wrong usage: exit code 2 -----------------------------------------------------------------------------------------

TEST_CASE("Without a command, or with one that there is not, the program says where to find help") {
  check_failure("", 2, {"gjkstep --help"});
  check_failure("rendr figure-5", 2, {"rendr", "--help"});
  check_failure("--bogus", 2, {"--bogus", "--help"});
  check_failure("render --bogus figure-5", 2, {"--bogus", "--help"});
  check_failure("list more", 2, {"more", "gjkstep list"});
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

TEST_CASE("A backend that there is not is refused with the names of those that there are, and nothing is written") {
  for (const char* name : {"nonsense", "OSMesa", "egl ", ""}) {
    const Untouched out;
    check_failure("render figure-5 --gl " + quoted(name) + out.option, 2, {"--gl " + quoted(name), "osmesa or egl"});
    check_failure("--version --gl " + quoted(name), 2, {"--gl " + quoted(name), "osmesa or egl"});
  }
  const Untouched out;
  check_failure("render figure-5" + out.option, 2, {"GJKSTEP_GL 'glx'", "osmesa or egl"}, "GJKSTEP_GL=glx");
}

TEST_CASE("The smallest size is accepted") {
  const Folder folder;
  CHECK(run("render figure-5 --size 16x16 --out " + quoted(folder.path().string())).exit_code == 0);
  CHECK(listing(folder.path() / "figure-5").size() == 3);
}

// -- What the machine lacks: exit codes 3, 4, 5 -----------------------------------------------------------------------

TEST_CASE("Missing fonts are exit code 3 and the message names the package, and nothing is written") {
  const Untouched out;
  const Folder empty;
  check_failure("render figure-5" + out.option, 3,
                {(empty.path() / "DejaVuSans.ttf").string(), "fonts-dejavu-core", "GJKSTEP_FONT_DIR"},
                "GJKSTEP_FONT_DIR=" + quoted(empty.path().string()));
}

TEST_CASE("No OpenGL context is exit code 4 and the message names what stands in the way, and nothing is written") {
  for (const render::Backend backend : render::built_in_backends()) {
    const Untouched out;
    const std::string gl = " --gl " + std::string(render::name_of(backend)), old = "MESA_GL_VERSION_OVERRIDE=2.1";
    check_failure("render figure-5" + gl + out.option, 4, {"OpenGL 3.3", old}, old);
    CHECK(run("--version" + gl, old).exit_code == 4);
  }
}

TEST_CASE(
    "Settings under which Mesa would crash or draw other pixels are exit code 4 and the message says what to choose") {
  for (const render::Backend backend : render::built_in_backends()) {
    const std::string gl = " --gl " + std::string(render::name_of(backend));
    for (const std::string setting : {"GALLIUM_DRIVER=bogus", "GALLIUM_DRIVER=softpipe", "LP_NATIVE_VECTOR_WIDTH=512",
                                      "DRAW_USE_LLVM=0", "LP_PERF=no_tex", "MESA_GLSL_VERSION_OVERRIDE=110"}) {
      const Untouched out;
      check_failure("render figure-5" + gl + out.option, 4, {setting, "unset it"}, setting);
    }
  }
}

TEST_CASE("A backend that this build lacks is exit code 4 and the message names its package, and nothing is written") {
  for (const render::Backend backend : render::all_backends()) {
    if (std::ranges::count(render::built_in_backends(), backend) > 0) continue;
    const std::string name(render::name_of(backend));
    for (const bool by_variable : {false, true}) {
      const Untouched out;
      check_failure("render figure-5" + (by_variable ? "" : " --gl " + name) + out.option, 4,
                    {"'" + name + "'", "lib" + name, "-dev"}, by_variable ? "GJKSTEP_GL=" + name : "");
    }
  }
}

TEST_CASE("EGL that has no software renderer is exit code 4 and the message names its package") {
  if (std::ranges::count(render::built_in_backends(), render::Backend::egl) == 0) return;
  const Untouched out;
  const std::string none = "__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere";
  check_failure("render figure-5 --gl egl" + out.option, 4, {none, "libegl-mesa0"}, none);
}

TEST_CASE("EGL that is told to draw with another driver is exit code 4 and the message says so") {
  if (std::ranges::count(render::built_in_backends(), render::Backend::egl) == 0) return;
  const Untouched out;
  const std::string other = "MESA_LOADER_DRIVER_OVERRIDE=zink";
  // Mesa complains as well; and what it leaks when it gives up is not ours.
  const Outcome outcome = run("render figure-5 --gl egl" + out.option, other + " ASAN_OPTIONS=detect_leaks=0");
  CHECK(outcome.exit_code == 4);
  CHECK(has(outcome.err, other));
}

TEST_CASE("A walkthrough named twice is rendered once") {
  const Folder folder;
  const Outcome outcome = run("render figure-5 --all figure-5 --size 32x18 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  const std::string file = "figure-5/000.png";
  const auto first = outcome.out.find(file);
  REQUIRE(first != std::string::npos);
  CHECK(outcome.out.find(file, first + 1) == std::string::npos);
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

TEST_CASE("Standard output that is full is exit code 5") {
  for (const char* command : {"trace figure-4-left", "list", "--version", "--help"}) {
    INFO(command);
    const Outcome outcome = run(command, "", {.out = "/dev/full", .err = ""});
    CHECK(outcome.exit_code == 5);
    CHECK(has(outcome.err, "standard output"));
  }
}
