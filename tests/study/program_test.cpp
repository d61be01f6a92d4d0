/// gjkstep-study as its users run it.
#include "tests/walkthroughs/program.hpp"

#include <filesystem>
#include <fstream>

namespace walkthroughs::test {
namespace {

std::string in(const Folder& folder, const std::string& name) { return quoted((folder.path() / name).string()); }

const std::string small = "--pairs 40 --families triangles,cycles --scalar float,double ";

TEST_CASE("study: a run says its seed and leaves tables", "[program]") {
  const Folder folder;
  const Outcome outcome = run("run --seed 5 " + small + "--out " + in(folder, "one"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.err, "seed 5, 2 families, 8 methods"));
  for (const char* const name :
       {"study.json", "study.csv", "timings.csv", "tables.md", "errors.md", "settings.md", "timings.md"}) {
    CHECK(has(outcome.out, name));
    CHECK(std::filesystem::file_size(folder.path() / "one" / name) > 100);
  }
}

TEST_CASE("study: shards merged leave the files of one run byte for byte", "[program]") {
  const Folder folder;
  CHECK(run("run " + small + "--out " + in(folder, "one")).exit_code == 0);
  CHECK(run("run " + small + "--shard 0/2 --out " + in(folder, "s")).exit_code == 0);
  CHECK(run("run " + small + "--shard 1/2 --threads 1 --out " + in(folder, "s")).exit_code == 0);
  CHECK(run("merge " + in(folder, "s/shard-1-of-2.json") + " " + in(folder, "s/shard-0-of-2.json") + " --out " +
            in(folder, "both"))
            .exit_code == 0);
  for (const char* const name : {"study.csv", "tables.md", "errors.md", "settings.md"})
    CHECK(bytes_of(folder.path() / "one" / name) == bytes_of(folder.path() / "both" / name));
}

TEST_CASE("study: what cannot be merged ends with 3 and a sentence", "[program]") {
  const Folder folder;
  CHECK(run("run " + small + "--shard 0/2 --out " + in(folder, "s")).exit_code == 0);
  check_failure("merge " + in(folder, "s/shard-0-of-2.json"), 3, {"shard 1 of 2 is missing"});
  check_failure("merge " + in(folder, "nowhere.json"), 3, {"cannot read", "nowhere.json"});
}

TEST_CASE("study: exact numbers that are wrong end with 1 after everything is written", "[program]") {
  const Folder folder;
  REQUIRE(
      run("run --pairs 50 --families coplanar-axis --scalar exact --shard 0/1 --out " + in(folder, "o")).exit_code ==
      0);
  std::string text = bytes_of(folder.path() / "o" / "study.json");
  const auto exchange = [&](const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
  };
  exchange(R"({"truly_separated")", R"({"truly_what")");
  exchange(R"("truly_intersecting")", R"("truly_separated")");
  exchange(R"("truly_what")", R"("truly_intersecting")");
  std::ofstream(folder.path() / "changed.json") << text;
  const Outcome outcome = run("merge " + in(folder, "changed.json") + " --out " + in(folder, "m"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, "family coplanar-axis: in exact numbers GJK was wrong on 1 of 1 pairs"));
  CHECK(has(outcome.out, "timings.md"));
}

TEST_CASE("study: wrong usage ends with 2", "[program]") {
  check_failure("", 2, {"what to do?"});
  check_failure("run --families tringles", 2, {"did you mean 'triangles'?"});
  check_failure("run --shard 2/2", 2, {"--shard: expected I/N"});
  check_failure("run --quick --full", 2, {"--quick"});
  check_failure("merge", 2, {"FILES"});
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

TEST_CASE("study: families and settings are listed", "[program]") {
  const Outcome outcome = run("list");
  CHECK(outcome.exit_code == 0);
  for (const char* const part : {"  triangles: ", "  as-printed, long-double, relative", "  5 8 10 20 50"})
    CHECK(has(outcome.out, part));
}

}  // namespace
}  // namespace walkthroughs::test
