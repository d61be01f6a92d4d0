/// gjkstep-study as its users run it.
#include <filesystem>

#include "tests/study/program/run_study.hpp"

namespace study::test {
namespace {

const std::string small = "--pairs 40 --families triangles,cycles --scalar float,double ";

TEST_CASE("study: a run says its seed and leaves CSV files, a shard of it those of its own", "[program]") {
  const Folder folder;
  const Outcome outcome = run("run --seed 5 " + small + "--out " + in(folder, "one"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.err, "seed 5, 2 families, 20 methods"));
  CHECK(lines(outcome.out).size() == 5);
  for (const std::string& file : lines(outcome.out)) CHECK(std::filesystem::file_size(file) > 100);
  CHECK(run("run --seed 5 " + small + "--shard 1/2 --threads 1 --out " + in(folder, "one")).exit_code == 0);
  CHECK(listing(folder.path() / "one").size() == 10);
  CHECK(has(bytes_of(folder.path() / "one/shard-1-of-2/counts.csv"), "# shard: 1 of 2\n"));
}

TEST_CASE("study: claims are counted and leave CSV files", "[program]") {
  const Folder folder;
  const Outcome outcome = run("claims --pairs 20 --out " + in(folder, "c"));
  CHECK(outcome.exit_code == 0);
  CHECK(lines(outcome.out).size() == 3);
  for (const std::string& file : lines(outcome.out)) CHECK(std::filesystem::exists(file));
}

TEST_CASE("study: what would be written over what else is written is refused", "[program]") {
  const Folder folder;
  const std::string few = "run --pairs 1 --families cycles ";
  std::filesystem::create_directories(folder.path() / "o");
  const Outcome outcome = run(few + "--out " + in(folder, "o"), (folder.path() / "o/counts.csv").string());
  CHECK(outcome.exit_code == 2);
  CHECK(has(outcome.err, "standard output"));
  check_failure(few + "--out " + in(folder, "o") + " --save-failures " + in(folder, "o/counts.csv"), 2,
                {"the scenes of --save-failures", "have the same place"});
}

TEST_CASE("study: a run of certified answers is about balls and cylinders, too, and finds nothing wrong", "[program]") {
  const Folder folder;
  const Outcome outcome =
      run("run --pairs 40 --families touching-face-askew,spheres,cylinders --rules certified --save-failures " +
          in(folder, "f") + " --out " + in(folder, "o"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "f: 0 scene files"));
  CHECK(has(bytes_of(folder.path() / "o/iterations.csv"), "\nspheres,certified,double,exact,second searches,0:40\n"));
}

TEST_CASE("study: wrong usage ends with 2", "[program]") {
  check_failure("", 2, {"what to do?"});
  check_failure("run --families tringles", 2, {"did you mean 'triangles'?"});
  check_failure("run --shard 2/2", 2, {"--shard: expected I/N"});
  check_failure("run --quick --full", 2, {"--quick"});
  check_failure("merge", 2, {"merge"});
}

TEST_CASE("study: numbers are digits, and none is taken for another", "[program]") {
  const std::string seeds = "from 0 to 18446744073709551615", pairs = "from 1 to 1000000000000";
  for (const auto& [option, range] :
       {std::pair{"run --seed", seeds},
        {"claims --seed", seeds},
        {"run --pairs", pairs},
        {"claims --pairs", pairs},
        {"run --threads", std::string("from 0 to 1024")},
        {"claims --threads", std::string("from 0 to 1024")},
        {"run --save-failures f --max-failures", std::string("from 0 to 1000000000000")}}) {
    for (const std::string number : {"-1", "+1", "1e3", "0x10", "18446744073709551616", "''"})
      check_failure(option + (" " + number), 2, {"expected a whole number " + range});
    CHECK(has(run(std::string(option).substr(0, std::string(option).find(' ')) + " --help").out, range));
  }
  const Folder folder;
  const Outcome outcome = run("run --seed 010 --pairs 1 --families cycles --out " + in(folder, "o"));
  CHECK(has(outcome.err, "seed 10, "));
}

TEST_CASE("study: a list takes no other option for one of its names", "[program]") {
  for (const std::string list : {"--families", "--rules", "--scalar", "--zero-test"})
    for (const std::string names : {",", "--out", "''", "a,,b", ",a", "a,"})
      check_failure("run " + list + " " + names, 2, {list + " '", "expected names, divided by single commas"});
  for (const std::string numbers : {",", "--out", "''", "5,", "-5", "5,x", "99999999999"})
    check_failure("run --limit " + numbers, 2, {"--limit '", "expected whole numbers from 1 to 1000, such as 5,20"});
}

TEST_CASE("study: a list may be given in parts", "[program]") {
  const Folder folder;
  const Outcome outcome = run(
      "run --families cycles --families boxes,triangles --limit 5,010 --limit 8 --pairs 1 --out " + in(folder, "o"));
  CHECK(has(outcome.err, "3 families"));
  CHECK(has(bytes_of(folder.path() / "o/counts.csv"), "--limit 5,10,8\n"));
}

TEST_CASE("study: a folder without a name is wrong usage", "[program]") {
  const std::string few = "run --pairs 1 --families cycles ";
  check_failure(few + "--out ''", 2, {"--out '': name a folder"});
  check_failure(few + "--out --seed", 2, {"--out '--seed': name a folder"});
  check_failure(few + "--save-failures ''", 2, {"--save-failures '': name a folder"});
  check_failure("claims --pairs 1 --out ''", 2, {"--out '': name a folder"});
}

TEST_CASE("study: a folder that cannot be made ends with 5", "[program]") {
  check_failure("run --pairs 1 --families triangles --out /dev/null/x", 5, {"/dev/null/x"});
}

TEST_CASE("study: failures are saved as scenes", "[program]") {
  const Folder folder;
  const Outcome outcome =
      run("run " + small + "--save-failures " + in(folder, "f") + " --max-failures 2 --out " + in(folder, "o"));
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, " scene files"));
  CHECK(std::filesystem::exists(folder.path() / "f" / "cycles-as-intended-double-exact-undecided-0.json"));
}

TEST_CASE("study: pairs are written with their answers, those of a seed always the same", "[program]") {
  const Outcome outcome = run("pairs --families boxes,grid-segments,spheres --count 3 --seed 9");
  CHECK(outcome.exit_code == 0);
  const std::vector<std::string> all = lines(outcome.out);
  REQUIRE(all.size() == 9);
  CHECK(all[0].starts_with(R"({"name":"boxes-0","family":"boxes","a":{"points":[[)"));
  CHECK(all[8].starts_with(R"({"name":"spheres-2","family":"spheres","a":{"sphere":{)"));
  for (const std::string& line : all) CHECK(has(line, R"(},"answer":{"status":")"));
  CHECK(run("pairs --families boxes,grid-segments,spheres --count 3 --seed 9 --families boxes").out == outcome.out);
  CHECK(run("pairs --families boxes,grid-segments,spheres --count 3 --seed 10").out != outcome.out);
  CHECK(lines(run("pairs --families cycles --count 100").out).size() == 48);  // all that there are
}

TEST_CASE("study: pairs that there are not are wrong usage, and a reader who leaves is told", "[program]") {
  check_failure("pairs --families boxs", 2, {"there is no family 'boxs'; did you mean 'boxes'?"});
  check_failure("pairs --corpus --count 3", 2, {"--corpus"});
  check_failure("pairs --count 0", 2, {"expected a whole number from 1 to "});
  const Outcome outcome = run("pairs --families boxes", "/dev/full");
  CHECK(outcome.exit_code == 5);
  CHECK(has(outcome.err, "cannot write to standard output"));
}

TEST_CASE("study: families and settings are listed", "[program]") {
  const Outcome outcome = run("list");
  CHECK(outcome.exit_code == 0);
  for (const char* const part :
       {"  triangles: ", "  as-printed, long-double, relative", "  certified, double, exact", "  5 8 10 20 50"})
    CHECK(has(outcome.out, part));
}

}  // namespace
}  // namespace study::test
