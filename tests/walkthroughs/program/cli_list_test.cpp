// gjkstep list: the catalogue, as lines and as tables.

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

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
            return line.starts_with(w.name + "  ") && line.ends_with(" " + w.summary);
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

TEST_CASE("gjkstep list WORD finds names, titles and cases, whatever the capitals") {
  for (const std::string word : {"R7", "r7"}) {
    const Outcome outcome = run("list " + word);
    CHECK(outcome.exit_code == 0);
    const std::vector<std::string> printed = lines(outcome.out);
    CHECK(printed.size() > 1);
    CHECK(std::ranges::count_if(printed, [](const std::string& l) { return l.starts_with("regions/2-simplex-r7 "); }) ==
          1);
    CHECK(std::ranges::none_of(printed, [](const std::string& l) { return l.starts_with("figure-4"); }));
  }
  CHECK(lines(run("list overflowed").out).size() == 3);  // a heading; failures/…, certified/…
  // Also who searches the whole list finds each case by the report's number.
  for (const std::string& line : lines(run("list").out))
    if (line.starts_with("regions/2-simplex-r7 ")) CHECK(has(line, " R7: "));
}

TEST_CASE("A blank word is no word to look for") {
  check_failure("list ''", 2, {"'' is no word to look for; leave it out"});
  check_failure("list '  '", 2, {"'  ' is no word to look for"});
}

TEST_CASE("A word that no walkthrough says, and a name without its folder, get the name that was meant") {
  const Outcome unknown = run("list figrue-4");
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.out.empty());
  CHECK(has(unknown.err, "no walkthrough has or says 'figrue-4'; did you mean 'figure-4'?"));
  CHECK(has(run("render 2-simplex-r7").err, "did you mean 'regions/2-simplex-r7'?"));
  CHECK(has(run("render R7").err, "did you mean 'regions/2-simplex-r7'?"));
  CHECK(has(run("trace 2-simplex-r8").err, "did you mean 'regions/2-simplex-r"));
  CHECK(has(run("trace regions/2-simplex-r8").err, "did you mean 'regions/2-simplex-r"));
}
