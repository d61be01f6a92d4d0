/// gjkstep-study as its users run it.
#include <filesystem>

#include "tests/study/program/run_study.hpp"

namespace study::test {
namespace program_test {

const std::string small = "--pairs 40 --families triangles,cycles --scalar float,double ";

TEST_CASE("study: a run says its seed and leaves CSV files, a shard of it those of its own", "[program]") {
  const Folder folder;
  const Outcome outcome = run("run --seed 5 " + small + "--out " + in(folder, "one"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.err, "seed 5, 2 families, 20 methods"));
  CHECK(lines(outcome.out).size() == 5);
  CHECK(listing(folder / "one") ==
        std::vector<std::string>{"alone.csv", "counts.csv", "families.csv", "iterations.csv", "timings.csv"});
  CHECK(run("run --seed 5 " + small + "--shard 1/2 --threads 1 --out " + in(folder, "one")).exit_code == 0);
  CHECK(listing(folder / "one").size() == 10);
  CHECK(has(bytes_of(folder / "one/shard-1-of-2/counts.csv"), "# shard: 1 of 2\n"));
}

TEST_CASE("study: what would be written over what else is written is refused", "[program]") {
  const Folder folder;
  std::filesystem::create_directories(folder / "o");
  const Outcome outcome = run("run --pairs 1 --families cycles --out " + in(folder, "o"), folder / "o/counts.csv");
  CHECK(outcome.exit_code == 2);
  CHECK(has(outcome.err, "standard output and the CSV files of --out have the same place"));
}

TEST_CASE("study: what cannot be done is told with what to write instead", "[program]") {
  const std::string few = "run --pairs 1 --families cycles ", seeds = "a whole number from 0 to 18446744073709551615",
                    pairs = "a whole number from 1 to 1000000000000";
  for (const auto& [arguments, exit_code, said] : std::vector<std::tuple<std::string, int, std::string>>{
           {"", 2, "what to do?"},
           {"merge", 2, "merge"},
           {"run --families tringles", 2, "did you mean 'triangles'?"},
           {"run --shard 2/2", 2, "--shard: expected I/N"},
           {"run --quick --full", 2, "--quick"},
           {"run --seed -1", 2, seeds},
           {"claims --seed 1e3", 2, seeds},
           {"run --pairs 0", 2, pairs},
           {"claims --pairs 0", 2, pairs},
           {"pairs --count 0", 2, pairs},
           {"run --threads 1025", 2, "a whole number from 0 to 1024"},
           {"claims --threads 1025", 2, "a whole number from 0 to 1024"},
           {few + "--out ''", 2, "--out '': name a folder"},
           {few + "--out --seed", 2, "--out '--seed': name a folder"},
           {"claims --pairs 1 --out ''", 2, "--out '': name a folder"},
           {few + "--out /dev/null/x", 5, "/dev/null/x"},
           {"pairs --families boxs", 2, "there is no family 'boxs'; did you mean 'boxes'?"},
           {"pairs --corpus --count 3", 2, "--corpus"},
       })
    check_failure(arguments, exit_code, {said});
}

TEST_CASE("study: a list may be given in parts, and takes no other option for one of its names", "[program]") {
  const Folder folder;
  const Outcome outcome =
      run("run --seed 010 --families cycles --families boxes,triangles --limit 5,010 --limit 8 "
          "--pairs 1 --out " +
          in(folder, "o"));
  CHECK(has(outcome.err, "seed 10, 3 families"));
  CHECK(has(bytes_of(folder / "o/counts.csv"), "--limit 5,10,8\n"));
  for (const std::string list : {"--families", "--rules", "--scalar", "--zero-test"})
    check_failure("run " + list + " a,", 2, {list + " '", "expected names, divided by single commas"});
  for (const std::string names : {",", "--out", "''", "a,,b", ",a"})
    check_failure("run --rules " + names, 2, {"expected names, divided by single commas"});
  for (const std::string numbers : {"0", "1001", "-5", "5,x", "99999999999"})
    check_failure("run --limit " + numbers, 2, {"--limit '", "expected whole numbers from 1 to 1000, such as 5,20"});
}

TEST_CASE("study: pairs are written with their answers, those of a seed always the same", "[program]") {
  const std::string some = "pairs --families boxes,grid-segments,spheres --count 3 --seed ";
  const Outcome outcome = run(some + "9");
  CHECK(outcome.exit_code == 0);
  const std::vector<std::string> all = lines(outcome.out);
  REQUIRE(all.size() == 9);
  CHECK(all[0].starts_with(R"({"name":"boxes-0","family":"boxes","a":{"points":[[)"));
  CHECK(all[8].starts_with(R"({"name":"spheres-2","family":"spheres","a":{"sphere":{)"));
  for (const std::string& line : all) CHECK(has(line, R"(},"answer":{"status":")"));
  CHECK(run(some + "9 --families boxes").out == outcome.out);
  CHECK(run(some + "10").out != outcome.out);
  CHECK(lines(run("pairs --families cycles --count 100").out).size() == 48);  // all that there are
  const Outcome left = run("pairs --families boxes", "/dev/full");
  CHECK(left.exit_code == 5);
  CHECK(has(left.err, "cannot write to standard output"));
}

TEST_CASE("study: families and settings are listed", "[program]") {
  const Outcome outcome = run("list");
  CHECK(outcome.exit_code == 0);
  for (const char* const part :
       {"  triangles: ", "  as-printed, long-double, relative", "  certified, double, exact", "  5 8 10 20 50"})
    CHECK(has(outcome.out, part));
}

}  // namespace program_test
}  // namespace study::test
