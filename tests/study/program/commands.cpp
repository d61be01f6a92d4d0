#include "tests/study/program/commands.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "render/file.hpp"
#include "tests/study/methods/all_methods.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"
#include "tests/study/report/results.hpp"
#include "tests/study/sweep/failure_files.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/program/places.hpp"

namespace study {

using walkthroughs::expect_number;

namespace {

void list() {
  std::cout << "families\n";
  for (const Family& family : families()) std::cout << "  " << family.name << ": " << family.what << '\n';
  std::cout << "rules, scalar and zero test (--rules, --scalar, --zero-test)\n";
  for (const Method& method : all_methods())
    std::cout << "  " << method.rules << ", " << method.scalar.name << ", " << method.zero_test << '\n';
  std::cout << "iteration limits (--limit; certified answers have none)\n ";
  for (const int limit : limits) std::cout << ' ' << limit;
  std::cout << '\n';
}

/// So that a shard is not written over by what it is merged into. A whole study may be, by itself. `failures`: a folder of
/// scenes.
void expect_apart(const std::vector<std::string>& read, const std::vector<std::filesystem::path>& written,
                  const std::optional<std::string>& failures = {}) {
  walkthroughs::Places places;
  for (const std::string& file : read)
    if (read.size() > 1) places.read(file, "the study " + file);
  for (const std::filesystem::path& file : written)
    places.write(file, "what --out gets, " + file.filename().string() + ",");
  if (failures) places.write_into(*failures, {"*.json"}, scenes_of_failures);
  places.write_standard_output();
  places.expect_apart();
}

void announce(const Plan& plan) {
  std::cerr << "seed " << plan.seed << ", " << plan.parts.size() << " families, " << plan.methods.size() << " methods, "
            << plan.threads << (plan.threads == 1 ? " thread" : " threads");
  if (plan.shard.count > 1) std::cerr << ", shard " << plan.shard.index << " of " << plan.shard.count;
  std::cerr << '\n';
}

/// Called last: what was found is written whatever it says.
void expect_no_contradiction(const Study& study) {
  if (const std::string found = contradiction(study); !found.empty()) throw std::logic_error(found);
}

void announce_time(const Plan& plan) {
  const double seconds = estimated_seconds(plan);
  std::cerr << "this will take about ";
  if (seconds < 90)
    std::cerr << std::ceil(seconds) << " s\n";
  else if (seconds < 36 * 3600)
    std::cerr << std::ceil(seconds / 60) << " min\n";
  else
    std::cerr << std::ceil(seconds / 86400) << " days; --shard splits it\n";
}

}  // namespace

void RunCommand::add_to(CLI::App& app) {
  CLI::Option* const is_quick = app.add_flag("--quick", quick, "less than a minute on two cores (the default)");
  CLI::Option* const is_full = app.add_flag("--full", full, "says first how long it will take")->excludes(is_quick);
  add_seed(app, request.seed);
  expect_number(app.add_option("--pairs", request.pairs, "so many of each family, a 50th of them in exact numbers")
                    ->excludes(is_quick)
                    ->excludes(is_full),
                std::uint64_t{1}, most_pairs);
  add_list(app, "--families", request.families, "only these, such as triangles,boxes");
  add_list(app, "--rules", request.rules, "only these");
  add_list(app, "--scalar", request.scalars, "only these");
  add_list(app, "--zero-test", request.zero_tests, "only these");
  add_list(app, "--limit", request.limits, "these iteration limits");
  app.add_option("--shard", shard, "I/N: one N-th of the pairs, I from 0; leaves a file for merge");
  add_threads(app, threads);
  app.add_option("--out", out, "folder of the results")->capture_default_str();
  CLI::Option* const saves = app.add_option("--save-failures", failures, "folder for scene files of what went wrong");
  expect_number(app.add_option("--max-failures", max_failures, "of each family, method and kind")
                    ->capture_default_str()
                    ->needs(saves),
                std::uint64_t{0}, most_pairs);
}

void RunCommand::run() const {
  expect_named("--out", out);
  if (failures) expect_named("--save-failures", *failures);
  Request wanted = request;
  wanted.scope = full ? Scope::full : Scope::quick;
  Plan plan = plan_of(wanted);
  if (shard) plan.shard = parse_shard(*shard);
  plan.threads = threads_of(threads);
  expect_apart({}, plan.shard.count > 1 ? std::vector{shard_file(out, plan.shard)} : result_files(out), failures);
  render::make_folder(out, "choose another with --out");  // before the work, not after it
  if (failures) render::make_folder(*failures, "choose another with --save-failures");
  announce(plan);
  if (full || request.pairs) announce_time(plan);
  plan.failures_kept = failures ? max_failures : 0;
  ProgressLine line;
  Findings findings = sweep(plan, std::ref(line));
  const Study study = study_of(wanted, plan, std::move(findings.rows));
  if (plan.shard.count > 1)
    write_shard(out, study);
  else
    write_results(out, study);
  if (failures) save(findings.failures, plan.seed);
  expect_no_contradiction(study);
}

void RunCommand::save(const std::vector<Failure>& found, std::uint64_t seed) const {
  const Saved saved = write_failures(*failures, found, seed);
  std::cout << *failures << ": " << saved.files << " scene files\n";
  if (saved.left_out > 0) std::cerr << "gjkstep-study: " << left_out_words(saved) << '\n';
}

void MergeCommand::add_to(CLI::App& app) {
  app.add_option("FILES", files, "the files of all shards, in any order")->required();
  app.add_option("--out", out, "folder of the results")->capture_default_str();
}

void MergeCommand::run() const {
  expect_named("--out", out);
  std::vector<NamedStudy> shards;
  if (std::ranges::count(files, "") > 0)
    throw UsageError("merge '': name files that 'gjkstep-study run --shard' wrote");
  expect_apart(files, result_files(out));
  for (const std::string& file : files) shards.push_back({file, read_study(file)});
  const Study study = merged(std::move(shards));
  write_results(out, study);
  expect_no_contradiction(study);
}

void Commands::add_to(CLI::App& app) {
  run_.add_to(*app.add_subcommand("run", "ask GJK about every family in every setting"));
  merge_.add_to(*app.add_subcommand("merge", "add up the shards of a study"));
  claims_.add_to(*app.add_subcommand("claims", "measure what the report claims; Markdown on the standard output"));
  symmetries_.add_to(*app.add_subcommand(
      "symmetries",
      "ask for certified answers again after what must not change them; Markdown on the standard output"));
  pairs_.add_to(*app.add_subcommand("pairs", "write pairs with their exact answers, a JSON line each"));
  judge_.add_to(
      *app.add_subcommand("judge", "is a program right? Asks it about pairs, and tells which mistake it may have"));
  check_steps_.add_to(*app.add_subcommand(
      "check-steps", "which is the first step of a program's search that the report's algorithm would not make?"));
  app.add_subcommand("list", "families and settings");
  all_ = {{app.get_subcommand("run"), [this] { run_.run(); }},
          {app.get_subcommand("merge"), [this] { merge_.run(); }},
          {app.get_subcommand("claims"), [this] { claims_.run(); }},
          {app.get_subcommand("symmetries"), [this] { symmetries_.run(); }},
          {app.get_subcommand("pairs"), [this] { pairs_.run(); }},
          {app.get_subcommand("judge"), [this] { judge_.run(); }},
          {app.get_subcommand("check-steps"), [this] { check_steps_.run(); }},
          {app.get_subcommand("list"), list}};
}

void Commands::run() const {
  for (const auto& [command, run] : all_)
    if (*command) return run();
  throw UsageError("what to do? 'gjkstep-study --help' shows the commands");
}

}  // namespace study
