// gjkstep render: which files are written, and what is said of them.

#include <poll.h>
#include <pty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

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

TEST_CASE(
    "gjkstep render says which objects have too many corners for their edges to be drawn, and what takes its time") {
  const Folder folder;
  const fs::path file = folder.path() / "rough.json";
  std::ofstream scene(file);
  scene << R"({"size": "32x18", "a": {"name": "pebble", "points": [[0, 0, 2])";
  for (int i = 0; i < 4000; ++i) scene << ", [" << std::cos(i) << ", " << std::sin(i) << ", 0]";
  scene << R"(]}, "b": {"points": [[3, 0, 0], [3, 1, 0], [3, 0, 1], [4, 0, 0]]}})";
  scene.close();
  const std::string arguments =
      "render " + quoted(file.string()) + " --out " + quoted((folder.path() / "out").string());
  const Outcome outcome = run(arguments);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err ==
        "gjkstep: rough: 'pebble' has more than 1000 corners: it is drawn without its edges, which would "
        "cover it\n"
        "gjkstep: rough: the difference has more than 1000 corners: it is drawn without its edges, which would cover "
        "it\n");
  Terminal terminal;
  CHECK(run(arguments, "", {.out = "", .err = terminal.name()}).exit_code == 0);
  CHECK(terminal.shows("reading " + file.string()));
  CHECK(terminal.shows("rough: searching"));
  CHECK(terminal.shows("rough: looking for hulls"));
  CHECK(terminal.shows("rough: drawing"));
  CHECK(terminal.shows("frame 1 of"));
}

TEST_CASE("gjkstep render names the letters that the font lacks, once") {
  const Folder folder;
  const fs::path file = folder.path() / "signs.json";
  std::ofstream(file) << R"({"title": "漢字", "size": "32x18", "a": {"name": "立", "points": [[0, 0, 0]]},
                             "b": {"points": [[1, 0, 0]]}})";
  const Outcome outcome = run("render " + quoted(file.string()) + " --out " + quoted((folder.path() / "out").string()));
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err ==
        "gjkstep: the font has no sign for 字 (U+5B57), 漢 (U+6F22), 立 (U+7ACB): boxes stand in their "
        "place\n");
}

TEST_CASE("gjkstep render --all renders every walkthrough") {
  const Folder folder;
  const Outcome outcome = run("render --all --frames 1 --size 32x18 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  CHECK(lines(outcome.out).size() == listing(folder.path()).size());
  for (const Walkthrough& w : catalogue()) CHECK(fs::exists(folder.path() / w.name / "000.png"));
}

TEST_CASE("A folder names all of its walkthroughs, which are written into folders of folders") {
  const std::string name = some_folder();
  if (name.empty()) return;
  const Folder folder;
  const Outcome outcome = run("render " + name + " --detail step --size 32x18 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  for (const Walkthrough* w : find_walkthroughs(name)) CHECK(fs::exists(folder.path() / w->name / "000.png"));
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("A walkthrough named twice is rendered once", "[unsanitized]") {
  const Folder folder;
  const Outcome outcome =
      run("render figure-5 --all figure-5 --frames 1 --size 32x18 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  const std::string file = "figure-5/000.png";
  const auto first = outcome.out.find(file);
  REQUIRE(first != std::string::npos);
  CHECK(outcome.out.find(file, first + 1) == std::string::npos);
}

TEST_CASE("Who draws pictures anew is told what an earlier run has left beside them, and how it is made anew") {
  const Folder folder;
  const std::string command = "render figure-5 --frames 1 --size 640x360 --out " + quoted(folder.path().string());
  const auto note = [](const std::string& file, const std::string& option) {
    return "gjkstep: figure-5: " + file + " is of an earlier run, and may tell of other pictures; " + option +
           " writes it anew\n";
  };
  CHECK(run(command).err.empty());
  CHECK(run(command + " --page").err.empty());
  CHECK(run(command + " --page").err.empty());
  CHECK(run(command + " --strip --apng --sheet").err == note("index.html", "--page"));
  CHECK(run(command + " --sheet=a4 --page").err ==
        note("strip.png", "--strip") + note("animation.png", "--apng") + note("sheet.png", "--sheet"));
  CHECK(run(command + " --page --strip --apng --sheet").err == note("sheet.pdf", "--sheet=a4"));
}

TEST_CASE("gjkstep render --letters fixed gives each vertex one letter, and corners keep theirs") {
  const Folder folder;
  const std::string out = " --size 32x18 --out " + quoted(folder.path().string());
  const Outcome fixed = run("render regions/2-simplex-r3 --letters fixed" + out);
  CHECK(has(fixed.out, "C joins the simplex as its newest vertex."));
  CHECK(has(run("render regions/2-simplex-r3 --letters roles" + out).out,
            "P joins the simplex as its newest vertex, A."));
  CHECK(run("render figure-4-left --letters fixed" + out).out == run("render figure-4-left" + out).out);
  check_failure("render figure-4-left --letters greek" + out, 2, {"--letters"});
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

TEST_CASE("The theme decides the colour of the paper") {
  const Folder folder;
  for (const std::string theme : {"report", "slides", "dark"}) {
    const fs::path out = folder.path() / theme;
    CHECK(run("render figure-5 --size 64x36 --theme " + theme + " --out " + quoted(out.string())).exit_code == 0);
    const render::Color paper = theme == "dark" ? render::themes::dark.paper : render::palette::white;
    CHECK(render::read_png(out / "figure-5" / "000.png").pixel(0, 0) == paper);
  }
}

TEST_CASE("The smallest size is accepted") {
  const Folder folder;
  CHECK(run("render figure-5 --size 16x16 --out " + quoted(folder.path().string())).exit_code == 0);
  CHECK(listing(folder.path() / "figure-5").size() == 3);
}

TEST_CASE("What the README shows is what the program prints", "[unsanitized]") {
  const Folder folder;
  std::set<std::string> printed;
  for (const std::string& line : lines(run("list").out)) printed.insert(line);
  const std::string out = folder.path().string();
  for (const std::string& line : lines(run("render --all --strip --size 32x18 --out " + quoted(out)).out))
    printed.insert("out" + line.substr(out.size()));
  std::ifstream readme(kit::source("README.md"));
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

TEST_CASE("The option --text-scale is heeded, also where a scene file or a theme says otherwise") {
  const Folder folder;
  const fs::path scene = scene_file(folder.path() / "scene.json");
  std::string text = bytes_of(scene);
  text.insert(1, "\"text_scale\": 1.5, ");
  fs::create_directories(folder.path() / "large");
  std::ofstream(folder.path() / "large" / "scene.json") << text;
  const auto first_frame = [&](const std::string& arguments) {
    const Folder out;
    CHECK(run("render " + arguments + " --frames 2 --size 320x180 --out " + quoted(out.path().string())).exit_code ==
          0);
    return bytes_of(out.path() / "scene" / "000.png");
  };
  const std::string usual = quoted(scene.string()), large = quoted((folder.path() / "large" / "scene.json").string());
  CHECK(first_frame(usual) == first_frame(usual + " --text-scale 1"));
  CHECK(first_frame(usual) != first_frame(usual + " --text-scale 1.5"));
  CHECK(first_frame(large) == first_frame(usual + " --text-scale 1.5"));
  CHECK(first_frame(large + " --text-scale 1") == first_frame(usual));
  CHECK(first_frame(usual + " --theme slides") == first_frame(usual + " --theme slides --text-scale 1.25"));
}

TEST_CASE("A scale of text out of its range is told with the range") {
  for (const char* scale : {"0.74", "1.51", "0", "-1", "nan", "1,5", "large", ""}) {
    const Untouched untouched;
    check_failure("render figure-5 --text-scale '" + std::string(scale) + "'" + untouched.option, 2,
                  {"--text-scale", "expected a number from 0.75 to 1.5"});
  }
}
