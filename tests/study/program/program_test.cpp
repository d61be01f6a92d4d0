/// gjkstep-study as its users run it.
#include "tests/walkthroughs/program/program.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/study/report/results.hpp"
#include "tests/study/sweep/checksum.hpp"

namespace walkthroughs::test {
namespace {

std::string in(const Folder& folder, const std::string& name) { return quoted((folder.path() / name).string()); }

/// Runs the program with no more than so many MiB to use.
Outcome within_memory(int mebibytes, const std::string& arguments) {
  const Folder folder;
  const std::string script = (folder.path() / "script").string();
  std::ofstream(script) << "ulimit -v " << mebibytes * 1024 << "\nexec " << quoted(GJKSTEP_PROGRAM) << " " << arguments
                        << "\n";
  const std::string err = (folder.path() / "stderr").string();
  const int status = std::system(("sh " + quoted(script) + " >/dev/null 2>" + quoted(err)).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", bytes_of(err)};
}

const std::string small = "--pairs 40 --families triangles,cycles --scalar float,double ";

TEST_CASE("study: a run says its seed and leaves tables", "[program]") {
  const Folder folder;
  const Outcome outcome = run("run --seed 5 " + small + "--out " + in(folder, "one"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.err, "seed 5, 2 families, 20 methods"));
  for (const char* const name : {"study.json", "study.csv", "timings.csv", "tables.md", "errors.md", "settings.md",
                                 "timings.md", "certified.md"}) {
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
  check_failure("merge " + in(folder, "nowhere.json"), 3, {"cannot be read", "nowhere.json"});
}

TEST_CASE("study: a shard in which a count has changed ends with 3, its file and the reason", "[program]") {
  const Folder folder;
  CHECK(run("run " + small + "--shard 0/1 --out " + in(folder, "s")).exit_code == 0);
  std::string text = bytes_of(folder.path() / "s" / "study.json");
  text.replace(text.find("\"truth_changed\":0"), 17, "\"truth_changed\":1");
  std::ofstream(folder.path() / "changed.json") << text;
  const Untouched untouched;
  check_failure("merge " + in(folder, "changed.json") + untouched.option, 3,
                {"changed.json is damaged: its checksum is not that of what it says"});
}

/// A program called gnuplot that writes half of a picture where it is told to, and does not end.
std::string slow_gnuplot(const Folder& folder) {
  const std::filesystem::path program = folder.path() / "gnuplot";
  std::ofstream(program) << "#!/bin/sh\n"
                            "file=$(sed -n \"s/^set output '\\(.*\\)'$/\\1/p\")\n"
                            "echo half >${file:-/dev/stdout}\n"
                            "echo $$ >'"
                         << (folder.path() / "started").string()
                         << "'\n"
                            "exec sleep 100\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return "\"PATH=" + folder.path().string() + ":$PATH\"";
}

/// A process that has ended has no program, even while nobody has asked how it ended.
bool is_running(const std::string& process) {
  std::error_code error;
  return !std::filesystem::read_symlink("/proc/" + process + "/exe", error).empty();
}

TEST_CASE("study: a run that is ended while it draws leaves no part of a picture and no gnuplot", "[program]") {
  for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
    INFO(signal);
    const Folder folder;
    std::ofstream(folder.path() / "script")
        << "env --default-signal=INT " << slow_gnuplot(folder) << " " << quoted(GJKSTEP_PROGRAM) << " run " << small
        << "--out " << in(folder, "out") << " >/dev/null 2>&1 &\nuntil [ -s " << in(folder, "started")
        << " ]; do sleep 0.02; done\nkill -" << signal << " $!\nwait $!\n";
    const int status = std::system(("sh " + in(folder, "script") + " 2>/dev/null").c_str());
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 128 + signal));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
      INFO(entry.path());
      CHECK((entry.path().extension() == ".json" || entry.path().extension() == ".csv" ||
             entry.path().extension() == ".md"));
    }
    const std::string gnuplot = lines(bytes_of(folder.path() / "started")).at(0);
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (is_running(gnuplot) && std::chrono::steady_clock::now() < late) std::this_thread::yield();
    CHECK_FALSE(is_running(gnuplot));
  }
}

TEST_CASE("study: what is no regular file is not read, though it may never end", "[program]") {
  check_failure("merge /dev/zero", 3, {"/dev/zero: is not a regular file"});
  check_failure("merge /tmp", 3, {"/tmp: is a folder"});
}

TEST_CASE("study: a file that is far too large is not read", "[program]") {
  const Folder folder;
  const std::filesystem::path file = folder.path() / "large.json";
  std::ofstream(file) << "{";
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // of holes
  check_failure("merge " + quoted(file.string()), 3, {"large.json: is larger than 64 MiB"});
}

TEST_CASE("study: memory that is not there is told in one line", "[program]") {
  if (within_memory(300, "list").exit_code != 0) {
    WARN("skipped: sanitizers reserve more memory than there is");
    return;
  }
  const Folder folder;
  const std::filesystem::path file = folder.path() / "long.json";
  std::ofstream(file) << std::string(std::size_t{60} << 20, '[');
  const Outcome outcome = within_memory(300, "merge " + quoted(file.string()));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, "gjkstep-study: out of memory; "));
  CHECK(lines(outcome.err).size() == 1);
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
  std::ofstream(folder.path() / "changed.json") << study::with_checksum(text.substr(0, text.rfind(',')) + "}");
  const Outcome outcome = run("merge " + in(folder, "changed.json") + " --out " + in(folder, "m"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.err, "family coplanar-axis: in exact numbers GJK was wrong on 1 of 1 pairs"));
  CHECK(has(outcome.out, "timings.md"));
}

TEST_CASE("study: a run of certified answers is about balls and cylinders, too, and finds nothing wrong", "[program]") {
  const Folder folder;
  const Outcome outcome =
      run("run --pairs 40 --families touching-face-askew,spheres,cylinders --rules certified --save-failures " + in(folder, "f") +
          " --out " + in(folder, "o"));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "f: 0 scene files"));
  CHECK(has(bytes_of(folder.path() / "o" / "tables.md"), "Balls and cylinders take no second search"));
}

TEST_CASE("study: wrong usage ends with 2", "[program]") {
  check_failure("", 2, {"what to do?"});
  check_failure("run --families tringles", 2, {"did you mean 'triangles'?"});
  check_failure("run --shard 2/2", 2, {"--shard: expected I/N"});
  check_failure("run --quick --full", 2, {"--quick"});
  check_failure("merge", 2, {"FILES"});
  check_failure("merge ''", 2, {"name files"});
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
  CHECK(has(bytes_of(folder.path() / "o" / "tables.md"), "--limit 5,10,8"));
}

TEST_CASE("study: a folder without a name is wrong usage", "[program]") {
  const std::string few = "run --pairs 1 --families cycles ";
  check_failure(few + "--out ''", 2, {"--out '': name a folder"});
  check_failure(few + "--out --seed", 2, {"--out '--seed': name a folder"});
  check_failure(few + "--save-failures ''", 2, {"--save-failures '': name a folder"});
  check_failure("merge x --out ''", 2, {"--out '': name a folder"});
}

TEST_CASE("study: results leave the files that are known before, and no others", "[program]") {
  const Folder folder;
  const std::string few = "run --pairs 1 --families cycles ", out = (folder.path() / "out").string();
  CHECK(run(few + "--out " + quoted(out)).exit_code == 0);
  CHECK(run(few + "--shard 1/3 --out " + quoted(out)).exit_code == 0);
  std::vector<std::filesystem::path> files = study::result_files(out);
  files.push_back(study::shard_file(out, {1, 3}));
  for (const auto& file : files) CHECK(std::filesystem::exists(file));
  CHECK(files.size() == listing(out).size());
}

TEST_CASE("study: what would be written over what is read is refused", "[program]") {
  const Folder folder;
  const std::string few = "run --pairs 1 --families cycles ", out = (folder.path() / "out").string();
  CHECK(run(few + "--shard 0/2 --out " + quoted(out)).exit_code == 0);
  CHECK(run(few + "--shard 1/2 --out " + quoted(out)).exit_code == 0);
  std::filesystem::rename(out + "/shard-0-of-2.json", out + "/study.json");
  const std::string before = bytes_of(out + "/study.json");
  const std::string both =
      "merge " + quoted(out + "/study.json") + " " + quoted(out + "/shard-1-of-2.json") + " --out ";
  check_failure(both + quoted(out), 2, {"the study ", "have the same place", "study.json"});
  CHECK(bytes_of(out + "/study.json") == before);
  const std::string whole = (folder.path() / "whole").string();
  CHECK(run(both + quoted(whole)).exit_code == 0);
  CHECK(run("merge " + quoted(whole + "/study.json") + " --out " + quoted(whole)).exit_code == 0);  // draws it again
  std::filesystem::create_directories(folder.path() / "o");
  const Outcome outcome =
      run(few + "--out " + in(folder, "o"), "", {.out = (folder.path() / "o/study.csv").string(), .err = ""});
  CHECK(outcome.exit_code == 2);
  CHECK(has(outcome.err, "standard output"));
  for (const char* failures : {"o", "o/study.json"})
    check_failure(few + "--out " + in(folder, "o") + " --save-failures " + in(folder, failures), 2,
                  {"the scenes of --save-failures", "have the same place"});
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
  const Outcome outcome = run("pairs --families boxes", "", {.out = "/dev/full", .err = ""});
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
}  // namespace walkthroughs::test
