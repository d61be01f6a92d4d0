#include "tests/study/program/commands.hpp"

#include <iostream>
#include <stdexcept>

#include "render/file.hpp"
#include "tests/study/methods/all_methods.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"
#include "tests/study/sweep/failure_files.hpp"
#include "tests/study/sweep/results.hpp"
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

void announce(const Plan& plan) {
  std::cerr << "seed " << plan.seed << ", " << plan.parts.size() << " families, " << plan.methods.size() << " methods, "
            << plan.threads << (plan.threads == 1 ? " thread" : " threads");
  if (plan.shard.count > 1) std::cerr << ", shard " << plan.shard.index << " of " << plan.shard.count;
  std::cerr << '\n';
}

}  // namespace

void RunCommand::add_to(CLI::App& app) {
  CLI::Option* const is_quick = app.add_flag("--quick", quick, "less than a minute on two cores (the default)");
  CLI::Option* const is_full = app.add_flag("--full", full, "some 25 minutes on two cores")->excludes(is_quick);
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
  app.add_option("--shard", shard, "I/N: one N-th of the pairs, I from 0; report.py adds shards up");
  add_threads(app, threads);
  app.add_option("--out", out, "folder of the CSV files")->capture_default_str();
  CLI::Option* const saves = app.add_option("--save-failures", failures, "folder for scene files of what went wrong");
  expect_number(app.add_option("--max-failures", max_failures, "of each family, method and kind")
                    ->capture_default_str()
                    ->needs(saves),
                std::uint64_t{0}, most_pairs);
  app.footer("tests/study/report/report.py makes tables and pictures of the CSV files.");
}

void RunCommand::run() const {
  expect_named("--out", out);
  if (failures) expect_named("--save-failures", *failures);
  Request wanted = request;
  wanted.scope = full ? Scope::full : Scope::quick;
  Plan plan = plan_of(wanted);
  if (shard) plan.shard = parse_shard(*shard);
  plan.threads = threads_of(threads);
  expect_apart(plan);
  render::make_folder(out, "choose another with --out");  // before the work, not after it
  if (failures) render::make_folder(*failures, "choose another with --save-failures");
  announce(plan);
  plan.failures_kept = failures ? max_failures : 0;
  ProgressLine line;
  const Findings findings = sweep(plan, std::ref(line));
  write_csv(out, wanted, plan, findings.rows);
  if (failures) save(findings.failures);
  // Last: what was found is written whatever it says.
  if (const std::string found = contradiction(plan, findings.rows); !found.empty()) throw std::logic_error(found);
}

void RunCommand::expect_apart(const Plan& plan) const {
  walkthroughs::Places places;
  for (const std::filesystem::path& file : csv_files(out, plan.shard))
    places.write(file, "what --out gets, " + file.filename().string() + ",");
  if (failures) places.write_into(*failures, {"*.json"}, scenes_of_failures);
  places.write_standard_output();
  places.expect_apart();
}

void RunCommand::save(const std::vector<Failure>& found) const {
  const Saved saved = write_failures(*failures, found, request.seed);
  std::cout << *failures << ": " << saved.files << " scene files\n";
  if (saved.left_out > 0) std::cerr << "gjkstep-study: " << left_out_words(saved) << '\n';
}

template <class Command>
void Commands::add(CLI::App& app, Command& command, const char* name, const char* what) {
  CLI::App* const added = app.add_subcommand(name, what);
  command.add_to(*added);
  all_.push_back({added, [&command] { command.run(); }});
}

void Commands::add_to(CLI::App& app) {
  add(app, run_, "run", "ask GJK about every family in every setting; CSV files");
  add(app, claims_, "claims", "count what the report claims; CSV files");
  add(app, pairs_, "pairs", "write pairs with their exact answers, a JSON line each");
  add(app, judge_, "judge", "is a program right? Asks it about pairs, and tells which mistake it may have");
  add(app, check_steps_, "check-steps",
      "which is the first step of a program's search that the report's algorithm would not make?");
  all_.push_back({app.add_subcommand("list", "families and settings"), list});
}

void Commands::run() const {
  for (const auto& [command, run] : all_)
    if (*command) return run();
  throw UsageError("what to do? 'gjkstep-study --help' shows the commands");
}

}  // namespace study
