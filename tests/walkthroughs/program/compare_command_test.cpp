// gjkstep compare, as its users run it.

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "render/image.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

void draw(const fs::path& file, render::Color color, render::Size size = {16, 9}) {
  fs::create_directories(file.parent_path());
  render::Image image(size);
  image.fill(color);
  render::write_png(file, image, {});
}

constexpr render::Color one{10, 20, 30}, other{90, 20, 30}, nearly{12, 20, 30};

/// Names that a shell would take for something else.
constexpr std::array odd_names{"it's <1> & \"2\".png", "-rf $HOME `x`.png", "a\nb' && exit 1 #.png", "*.png"};

/// Two folders of pictures, and a name for a third one.
struct Sides {
  Folder root;
  fs::path expected = root.path() / "expected side", actual = root.path() / "it's actual",
           report = root.path() / "to/report";

  Sides() {
    fs::create_directories(expected);
    fs::create_directories(actual);
  }
  Outcome compare(const std::string& options = "") const {
    return run("compare " + quoted(expected.string()) + " \"" + actual.string() + "\" " + options);
  }
  Outcome compare_with_report() const { return compare("--report " + quoted(report.string())); }
  std::string page() const { return bytes_of(report / "index.html"); }
  void draw_both(const std::string& name, render::Color e, render::Color a) const {
    draw(expected / name, e);
    draw(actual / name, a);
  }
};

std::string unescaped(std::string html) {
  for (const auto& [from, to] : {std::pair{"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    for (std::size_t at; (at = html.find(from)) != std::string::npos;) html.replace(at, std::string(from).size(), to);
  return html;
}

/// Returns: the commands of the page that accept new pictures.
std::vector<std::string> accept_commands(const std::string& page) {
  std::vector<std::string> commands;
  const std::string begin = ":<code>", end = "</code></div>";
  for (std::size_t at = 0; (at = page.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    commands.push_back(unescaped(page.substr(at, page.find(end, at) - at)));
  }
  return commands;
}

/// Returns: `text` with # for each number.
std::string without_numbers(const std::string& text) { return std::regex_replace(text, std::regex("[0-9]+"), "#"); }

}  // namespace

TEST_CASE("gjkstep compare says in one line that two files are the same whatever their bytes") {
  const Sides sides;
  draw(sides.expected / "a.png", one);
  render::Image image({16, 9});
  image.fill(one);
  render::write_png(sides.actual / "b.png", image, {.title = "other bytes", .description = "same pixels"});
  const Outcome outcome =
      run("compare " + quoted((sides.expected / "a.png").string()) + " \"" + (sides.actual / "b.png").string() + "\"");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "1 picture is the same\n");
  CHECK(outcome.err.empty());
}

TEST_CASE("gjkstep compare prints a line for each pair that differs and a summary and is exit code 1") {
  const Sides sides;
  sides.draw_both("1.png", one, one);
  sides.draw_both("2.png", one, other);
  sides.draw_both("3.png", one, nearly);
  draw(sides.expected / "sub/4.png", one);
  draw(sides.actual / "sub/5.png", one);
  draw(sides.expected / "6.png", one, {16, 9});
  draw(sides.actual / "6.png", one, {9, 16});
  const Outcome outcome = sides.compare();
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err.empty());
  CHECK(lines(outcome.out) == std::vector<std::string>{
                                  "2.png: different: 144 pixels are off (1 may be); the largest group is 144 pixels (4 "
                                  "may be); all within 16x9 "
                                  "at (0, 0)",
                                  "3.png: within the tolerance: no pixel is off; channels differ by up to 2 (2 may be)",
                                  "6.png: another size: expected 16x9 pixels, actual 9x16",
                                  "sub/4.png: missing: only the expected side has it",
                                  "sub/5.png: extra: only the actual side has it",
                                  "4 of 6 pictures differ (1 different, 1 another size, 1 missing, 1 extra)",
                              });
}

TEST_CASE("Differences within the tolerance are exit code 0 and told") {
  const Sides sides;
  sides.draw_both("1.png", one, nearly);
  sides.draw_both("2.png", one, one);
  const Outcome outcome = sides.compare();
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "2 pictures are the same, 1 of them within the tolerance\n"));
}

TEST_CASE("A picture that cannot be read is exit code 3 and the others are compared") {
  const Sides sides;
  sides.draw_both("1.png", one, other);
  sides.draw_both("2.png", one, one);
  sides.draw_both("3.png", one, other);
  std::ofstream(sides.actual / "2.png") << "no picture";
  const Outcome outcome = sides.compare_with_report();
  CHECK(outcome.exit_code == 3);
  CHECK(has(outcome.err, "cannot read " + (sides.actual / "2.png").string()));
  CHECK(has(outcome.err, "replace it"));
  CHECK(has(outcome.out, "3 of 3 pictures differ (2 different, 1 unreadable)"));
  CHECK(accept_commands(sides.page()).size() == 3);  // of two pictures, and of both
}

TEST_CASE("What never ends and what is far too large is exit code 3 with the reason, and nobody waits") {
  const Sides sides;
  draw(sides.expected / "a.png", one);
  const std::string a = quoted((sides.expected / "a.png").string());
  REQUIRE(mkfifo((sides.actual / "pipe").c_str(), 0600) == 0);
  std::ofstream(sides.actual / "large").flush();
  fs::resize_file(sides.actual / "large", std::uintmax_t{3} << 30);
  for (const auto& [file, reason] : {std::pair{fs::path("/dev/zero"), "it is not a regular file"},
                                     {sides.actual / "pipe", "it is not a regular file"},
                                     {sides.actual / "large", "it is not a PNG file"}}) {
    const Outcome outcome = run("compare " + a + " \"" + file.string() + "\"");
    CHECK(outcome.exit_code == 3);
    CHECK(has(outcome.err, "cannot read " + file.string() + ": " + reason));
  }
}

TEST_CASE("A side that is not there is exit code 3 and the message names it") {
  const Sides sides;
  check_failure("compare " + quoted(sides.expected.string()) + " nowhere", 3,
                {"cannot read nowhere", "name a PNG file"});
  check_failure("compare nowhere.png nowhere.png", 3, {"cannot read nowhere.png"});
}

TEST_CASE("A file with a folder and folders without pictures and missing words are exit code 2") {
  const Sides sides;
  draw(sides.root.path() / "a.png", one);
  const std::string file = quoted((sides.root.path() / "a.png").string()), folder = quoted(sides.expected.string());
  check_failure("compare " + file + " " + folder, 2, {"is a folder", "two files or two folders"});
  check_failure("compare " + folder + " " + file, 2, {"is a folder", "two files or two folders"});
  check_failure("compare " + folder + " " + folder, 2, {"there is no .png file"});
  check_failure("compare " + folder, 2, {"ACTUAL"});
  check_failure("compare " + file + " " + file + " --report ''", 2, {"--report"});
}

TEST_CASE("An empty folder lacks every picture of the other one") {
  const Sides sides;
  draw(sides.expected / "a.png", one);
  CHECK(sides.compare().exit_code == 1);
}

TEST_CASE("The commands of the report make the actual pictures the expected ones") {
  const Sides sides;
  const bool at_once = GENERATE(false, true);
  CAPTURE(at_once);
  for (const char* name : odd_names) sides.draw_both(name, one, other);
  draw(sides.expected / "gone.png", one);
  draw(sides.actual / "new folder/1.png", one);
  draw(sides.actual / "new folder/2.png", one);
  REQUIRE(sides.compare_with_report().exit_code == 1);
  std::vector<std::string> commands = accept_commands(sides.page());
  REQUIRE(commands.size() == 1 + odd_names.size() + 3);  // the first is all others in one
  commands.erase(at_once ? commands.begin() + 1 : commands.begin(), at_once ? commands.end() : commands.begin() + 1);
  for (const std::string& command : commands) {
    INFO(command);
    CHECK(std::system(command.c_str()) == 0);
  }
  CHECK(sides.compare().exit_code == 0);
}

TEST_CASE("The command that accepts all of many stops at the first that fails, and its exit code says so") {
  const Sides sides;
  for (int i = 100; i < 300; ++i) sides.draw_both(std::to_string(i) + ".png", one, other);
  REQUIRE(sides.compare_with_report().exit_code == 1);
  const std::string all = accept_commands(sides.page()).at(0);
  fs::rename(sides.actual / "298.png", sides.root.path() / "away");
  CHECK(std::system(("{ " + all + "\n} 2>/dev/null").c_str()) != 0);
  fs::rename(sides.root.path() / "away", sides.actual / "298.png");
  CHECK(has(sides.compare().out, "2 of 200 pictures differ"));
  CHECK(std::system(all.c_str()) == 0);
  CHECK(sides.compare().exit_code == 0);
}

TEST_CASE("The report says what rendered each side of folders and of files") {
  const Sides sides;
  sides.draw_both("a.png", one, other);
  std::ofstream(sides.expected / "rendered-by.json") << R"({"cpu": "AVX2"})";
  std::ofstream(sides.actual / "rendered-by.json") << R"({"cpu": "none"})";
  const std::string cells = "<td>AVX2</td><td>none</td><td>≠ differs</td>";
  const Outcome outcome = sides.compare_with_report();
  CHECK(outcome.exit_code == 1);
  CHECK(lines(outcome.out).back() == "report: " + (sides.report / "index.html").string());
  CHECK(has(sides.page(), cells));
  fs::remove_all(sides.report);
  run("compare --report " + quoted(sides.report.string()) + " " + quoted((sides.expected / "a.png").string()) + " \"" +
      (sides.actual / "a.png").string() + "\"");
  CHECK(has(sides.page(), cells));
}

TEST_CASE("A page that others have written is not replaced by a report, one of an earlier run is") {
  const Sides sides;
  sides.draw_both("a.png", one, other);
  fs::create_directories(sides.report);
  std::ofstream(sides.report / "index.html") << "mine";
  CHECK(sides.compare_with_report().exit_code == 2);
  CHECK(has(sides.compare_with_report().err, "index.html is not of gjkstep"));
  CHECK(sides.page() == "mine");
  fs::remove(sides.report / "index.html");
  for (int i = 0; i < 2; ++i) CHECK(sides.compare_with_report().exit_code == 1);
}

TEST_CASE("A report that cannot be written is exit code 5") {
  const Sides sides;
  sides.draw_both("a.png", one, other);
  std::ofstream(sides.root.path() / "to") << "in the way";
  const Outcome outcome = sides.compare_with_report();
  CHECK(outcome.exit_code == 5);
  CHECK(has(outcome.err, "--report"));
  CHECK(bytes_of(sides.root.path() / "to") == "in the way");
  CHECK(outcome.out.empty());  // not after all that is compared
  check_failure("compare " + quoted((sides.expected / "a.png").string()) + " " +
                    quoted((sides.expected / "a.png").string()) + " --report /dev/full",
                5, {"/dev/full", "--report"});
}

/// Runs gjkstep with no more than so many MiB to use.
Outcome within_memory(int mebibytes, const std::string& arguments) {
  const Folder folder;
  const std::string err = (folder.path() / "stderr").string();
  const std::string command = "ulimit -v " + std::to_string(mebibytes * 1024) + "; " + quoted(kit::program()) + " " +
                              arguments + " >/dev/null 2>" + quoted(err);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", bytes_of(err)};
}

TEST_CASE("Where memory is limited, a large file is looked at before it is read, and large pictures name the limit") {
  constexpr int limit = 400;
  const Folder folder;
  const fs::path file = folder.path() / "x.png";
  const std::string both = "compare " + quoted(file.string()) + " " + quoted(file.string());
  draw(file, one);
  if (within_memory(limit, both).exit_code != 0) {
    WARN("skipped: the program itself takes more, as with sanitizers");
    return;
  }
  std::ofstream(file) << "no picture";
  fs::resize_file(file, 1'000'000'000);  // with a hole, which takes no room
  const Outcome hole = within_memory(limit, both);
  CHECK(hole.exit_code == 3);
  CHECK(has(hole.err, "it is not a PNG file"));
  draw(file, one, {8192, 8192});
  const Outcome large = within_memory(limit, both);
  CHECK(large.exit_code == 3);
  CHECK(has(large.err, "compare smaller pictures; only 400 MiB of memory are allowed (ulimit -v)"));
}

TEST_CASE("Names of files cannot write more lines than their own") {
  const Sides sides;
  sides.draw_both("a\nb\033[2Jc.png", one, other);
  CHECK(lines(sides.compare().out).size() == 2);
  CHECK(has(sides.compare().out, "a\\x0ab\\x1b[2Jc.png: different"));
}

TEST_CASE("gjkstep compare --help tells the rule and the exit codes") {
  const std::string help = run("compare --help").out;
  for (const char* part :
       {"EXPECTED", "ACTUAL", "--report", "more than 2", "one in 50,000", "one in 100", "larger than 4", "3 a picture"})
    CHECK(has(help, part));
}

TEST_CASE("What the README shows of gjkstep compare is what the program prints but for the numbers") {
  const Sides sides;
  sides.draw_both("000.png", one, other);
  sides.draw_both("001.png", one, one);
  const std::vector<std::string> printed = lines(sides.compare_with_report().out);
  REQUIRE(printed.size() == 3);
  const std::string readme = without_numbers(bytes_of(kit::source("README.md")));
  for (std::size_t i : {0u, 1u}) {
    INFO(printed[i]);
    CHECK(has(readme, "\n" + without_numbers(printed[i]) + "\n"));
  }
  CHECK(has(readme, "\nreport: differences/index.html\n"));
}
