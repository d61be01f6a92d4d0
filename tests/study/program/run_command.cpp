#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "render/file.hpp"
#include "tests/study/methods/all_methods.hpp"
#include "tests/study/program/commands.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"
#include "tests/study/sweep/results.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/program/places.hpp"

namespace study {
namespace {

struct RunCommand {
  Request request;
  std::vector<std::string> limits;
  std::optional<std::string> shard;
  std::string out = "study";
  unsigned threads = 0;
};

constexpr int largest_limit = 1000;  // of iterations
constexpr const char* limits_in_words = "whole numbers from 1 to 1000, such as 5,20";

std::vector<int> limits_called(const std::vector<std::string>& words) {
  std::vector<int> limits;
  for (const std::string& word : words) {
    const auto limit = walkthroughs::text::decimal<int>(word);
    if (!limit || *limit < 1 || *limit > largest_limit) refuse_list("--limit", word, limits_in_words);
    limits.push_back(*limit);
  }
  return limits;
}

void announce(const Plan& plan) {
  std::cerr << "seed " << plan.seed << ", " << plan.parts.size() << " families, " << plan.methods.size() << " methods, "
            << plan.threads << (plan.threads == 1 ? " thread" : " threads");
  if (plan.shard.count > 1) std::cerr << ", shard " << plan.shard.index << " of " << plan.shard.count;
  std::cerr << '\n';
}

void run(const RunCommand& asked) {
  expect_named("--out", asked.out);
  Request request = asked.request;
  request.limits = limits_called(asked.limits);
  Plan plan = plan_of(request);
  if (asked.shard) plan.shard = parse_shard(*asked.shard);
  plan.threads = threads_of(asked.threads);
  const std::filesystem::path folder = folder_of(asked.out, plan.shard);
  walkthroughs::program::Places places;
  places.write_into(folder, {"*.csv"}, "the CSV files of --out");
  places.write_standard_output();
  places.expect_apart();
  render::make_folder(folder, "choose another with --out");  // before the work, not after it
  announce(plan);
  ProgressLine line;
  const std::vector<Row> rows = sweep(plan, std::ref(line));
  write_csv(folder, csv_of(request, plan, rows));
  // Last: what was found is written whatever it says.
  if (const std::string found = contradiction(plan, rows); !found.empty()) throw std::logic_error(found);
}

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

}  // namespace

void add_run(CLI::App& program) {
  CLI::App& app = *program.add_subcommand("run", "ask GJK about every family in every setting; CSV files");
  const auto asked = std::make_shared<RunCommand>();
  CLI::Option* const is_quick = app.add_flag("--quick")->description("less than a minute on two cores (the default)");
  CLI::Option* const is_full =
      app.add_flag("--full", asked->request.is_full, "some 25 minutes on two cores")->excludes(is_quick);
  add_seed(app, asked->request.seed);
  add_pair_count(app, "--pairs", asked->request.pairs, "so many of each family, a 50th of them in exact numbers")
      ->excludes(is_quick)
      ->excludes(is_full);
  add_list(app, "--families", asked->request.families, "only these, such as triangles,boxes");
  add_list(app, "--rules", asked->request.rules, "only these");
  add_list(app, "--scalar", asked->request.scalars, "only these");
  add_list(app, "--zero-test", asked->request.zero_tests, "only these");
  add_list(app, "--limit", asked->limits, "these iteration limits", limits_in_words);
  app.add_option("--shard", asked->shard, "I/N: one N-th of the pairs, I from 0; report.py adds shards up");
  add_threads(app, asked->threads);
  app.add_option("--out", asked->out, "folder of the CSV files")->capture_default_str();
  app.footer("tests/study/report/report.py makes tables and pictures of the CSV files.");
  app.callback([asked] { run(*asked); });
}

void add_listing(CLI::App& program) { program.add_subcommand("list", "families and settings")->callback(list); }

}  // namespace study
