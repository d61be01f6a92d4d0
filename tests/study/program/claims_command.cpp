#include "tests/study/program/claims_command.hpp"

#include <iostream>

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
}

void ClaimsCommand::run() const {
  std::cerr << "seed " << seed << '\n';
  write_claims(std::cout, {.pairs = quick ? 20'000 : pairs,
                           .seed = seed,
                           .threads = threads_of(threads),
                           .progress = [](const std::string& what) { std::cerr << what << '\n'; }});
}

}  // namespace study
