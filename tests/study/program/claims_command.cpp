#include <iostream>
#include <memory>

#include "render/file.hpp"
#include "tests/study/claims/claims.hpp"
#include "tests/study/program/commands.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/sweep/results.hpp"

namespace study {
namespace {

struct ClaimsCommand {
  ClaimsOptions options;
  bool is_quick = false;
  std::string out = "study";
};

void run(const ClaimsCommand& asked) {
  expect_named("--out", asked.out);
  render::make_folder(asked.out, "choose another with --out");  // before the work, not after it
  ClaimsOptions options = asked.options;
  if (asked.is_quick) options.pairs = 20'000;
  options.threads = threads_of(options.threads);
  options.progress = [](const std::string& what) { std::cerr << what << '\n'; };
  std::cerr << "seed " << options.seed << '\n';
  write_csv(asked.out, claims_csv(options));
}

}  // namespace

void add_claims(CLI::App& program) {
  CLI::App& app = *program.add_subcommand("claims", "count what the report claims; CSV files");
  const auto asked = std::make_shared<ClaimsCommand>();
  CLI::Option* const is_quick = app.add_flag("--quick", asked->is_quick, "20,000 pairs of every kind: a few seconds");
  add_pair_count(app, "--pairs", asked->options.pairs, "so many of every kind; the report took a million triangles")
      ->excludes(is_quick);
  add_seed(app, asked->options.seed);
  add_threads(app, asked->options.threads);
  app.add_option("--out", asked->out, "folder of the CSV files")->capture_default_str();
  app.footer("tests/study/report/report.py makes claims.md of the CSV files.");
  app.callback([asked] { run(*asked); });
}

}  // namespace study
