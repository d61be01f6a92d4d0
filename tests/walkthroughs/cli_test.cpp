// The program as its users run it. GJKSTEP_PROGRAM is its path, given by the build.

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& text) { return "'" + text + "'"; }  // no test needs a ' inside

struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Where standard output and standard error go.
struct Streams {
  std::string out, err;  ///< files; where empty, to be read back
};

Outcome run(const std::string& arguments, const std::string& environment = "", const Streams& streams = {}) {
  const Folder folder;
  const std::string out = (folder.path() / "stdout").string(), err = (folder.path() / "stderr").string();
  const std::string command = "env " + environment + " " + quoted(GJKSTEP_PROGRAM) + " " + arguments + " >" +
                              quoted(streams.out.empty() ? out : streams.out) + " 2>" +
                              quoted(streams.err.empty() ? err : streams.err);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out), bytes_of(err)};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    list.push_back(text.substr(at, end - at));
  return list;
}

/// Checks that the command fails with that code, says each of `expected` on standard error and nothing on standard output.
void check_failure(const std::string& arguments, int exit_code, const std::vector<std::string>& expected,
                   const std::string& environment = "") {
  INFO(environment << " gjkstep " << arguments);
  const Outcome outcome = run(arguments, environment);
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  for (const std::string& part : expected) CHECK(has(outcome.err, part));
  CHECK(lines(outcome.err).size() <= 2);
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

TEST_CASE("gjkstep list prints each walkthrough with its summary, one line each") {
  const Outcome outcome = run("list");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const std::vector<std::string> printed = lines(outcome.out);
  REQUIRE(printed.size() == catalogue().size());
  for (std::size_t i = 0; i < printed.size(); ++i) {
    CHECK(printed[i].starts_with(catalogue()[i].name + "  "));
    CHECK(printed[i].ends_with("  " + catalogue()[i].summary));
  }
}

TEST_CASE("The option --help names every command, the exit codes and the variable for the fonts") {
  for (const char* option : {"--help", "-h"}) {
    const Outcome outcome = run(option);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    for (const char* word : {"list", "render", "trace", "--version", "Exit codes", "GJKSTEP_FONT_DIR"})
      CHECK(has(outcome.out, word));
  }
  for (const char* word : {"--all", "--strip", "--out", "--size", "1280x720"})
    CHECK(has(run("render --help").out, word));
}

TEST_CASE("The option --version prints the version and the OpenGL renderer") {
  const Outcome outcome = run("--version");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.starts_with("gjkstep 0."));
  CHECK(has(outcome.out, "OpenGL "));
}

TEST_CASE("gjkstep trace prints JSON Lines on standard output") {
  for (const Walkthrough& w : catalogue()) {
    const Outcome outcome = run("trace " + w.name);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    std::size_t events = 0;
    for (const Scene& scene : w.scenes) events += run(scene).events.size();
    const std::vector<std::string> printed = lines(outcome.out);
    CHECK(printed.size() == 1 + events);
    CHECK(printed.front().starts_with(R"({"schema":"gjkstep-trace","version":1,"walkthrough":")" + w.name + '"'));
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
  CHECK(lines(outcome.out).size() == 18 + 6 + 12 + 3);
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
    if (!line.starts_with("out/figure-") && !line.starts_with("figure-")) continue;
    INFO(line);
    CHECK(printed.count(line) == 1);
    ++shown;
  }
  CHECK(shown >= 8);
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

// -- Wrong usage: exit code 2 -----------------------------------------------------------------------------------------

TEST_CASE("Without a command, or with one that there is not, the program says where to find help") {
  check_failure("", 2, {"gjkstep --help"});
  check_failure("rendr figure-5", 2, {"rendr", "--help"});
  check_failure("--bogus", 2, {"--bogus", "--help"});
  check_failure("render --bogus figure-5", 2, {"--bogus", "--help"});
  check_failure("list more", 2, {"more"});
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
  const Untouched out;
  const std::string old = "MESA_GL_VERSION_OVERRIDE=2.1";
  check_failure("render figure-5" + out.option, 4, {"OpenGL 3.3", old}, old);
  CHECK(run("--version", old).exit_code == 4);
}

TEST_CASE("Settings under which Mesa would crash are exit code 4 and the message says what to choose") {
  for (const std::string setting :
       {"GALLIUM_DRIVER=bogus", "LP_NATIVE_VECTOR_WIDTH=512", "DRAW_USE_LLVM=0", "MESA_GLSL_VERSION_OVERRIDE=110"}) {
    const Untouched out;
    check_failure("render figure-5" + out.option, 4, {setting, "unset it"}, setting);
  }
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
