#include "tests/study/program/claims_command.hpp"

#include <filesystem>
#include <iostream>

#include "render/file.hpp"
#include "tests/study/claims/claims.hpp"
#include "tests/study/program/options.hpp"

namespace study {

using walkthroughs::expect_number;

void ClaimsCommand::add_to(CLI::App& app) {
  CLI::Option* const is_quick = app.add_flag("--quick", quick, "20,000 pairs of every kind: a few seconds");
  expect_number(app.add_option("--pairs", pairs, "so many of every kind; the report took a million triangles")
                    ->excludes(is_quick)
                    ->capture_default_str(),
                std::uint64_t{1}, most_pairs);
  add_seed(app, seed);
  add_threads(app, threads);
  app.add_option("--out", out, "folder of the CSV files")->capture_default_str();
  app.footer("tests/study/report/report.py makes claims.md of the CSV files.");
}

void ClaimsCommand::run() const {
  expect_named("--out", out);
  render::make_folder(out, "choose another with --out");  // before the work, not after it
  std::cerr << "seed " << seed << '\n';
  for (const Csv& csv : claims_csv({.pairs = quick ? 20'000 : pairs,
                        .seed = seed,
                        .threads = threads_of(threads),
                        .progress = [](const std::string& what) { std::cerr << what << '\n'; }})) {
    const std::filesystem::path file = std::filesystem::path(out) / csv.name;
    render::write_file(file, csv.text);
    std::cout << file.string() << '\n';
  }
}

}  // namespace study
