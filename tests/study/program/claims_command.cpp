#include "tests/study/program/claims_command.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

#include "tests/study/claims/claims.hpp"
#include "tests/study/sweep/plan.hpp"
#include "walkthroughs/program/number_option.hpp"

namespace study {

using walkthroughs::expect_number;

void ClaimsCommand::add_to(CLI::App& app) {
  CLI::Option* const is_quick = app.add_flag("--quick", quick, "20,000 pairs of every kind: a few seconds");
  expect_number(app.add_option("--pairs", pairs, "so many of every kind; the report took a million triangles")
                    ->excludes(is_quick)
                    ->capture_default_str(),
                std::uint64_t{1}, most_pairs);
  expect_number(app.add_option("--seed", seed, "which pairs are made")->capture_default_str(), std::uint64_t{0},
                most_seed);
  expect_number(app.add_option("--threads", threads, "0: as many as there are processors")->capture_default_str(), 0u,
                most_threads);
}

void ClaimsCommand::run() const {
  std::cerr << "seed " << seed << '\n';
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  write_claims(std::cout, {.pairs = quick ? 20'000 : pairs,
                           .seed = seed,
                           .threads = threads > 0 ? threads : processors,
                           .progress = [](const std::string& what) { std::cerr << what << '\n'; }});
}

}  // namespace study
