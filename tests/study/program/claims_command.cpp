#include "tests/study/program/claims_command.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

#include "tests/study/claims/claims.hpp"
#include "tests/study/sweep/plan.hpp"

namespace study {

void ClaimsCommand::add_to(CLI::App& app) {
  CLI::Option* const is_quick = app.add_flag("--quick", quick, "20,000 pairs of every kind: a few seconds");
  app.add_option("--pairs", pairs, "so many of every kind; the report took a million triangles")
      ->check(CLI::Range(std::uint64_t{1}, most_pairs))
      ->excludes(is_quick)
      ->capture_default_str();
  app.add_option("--seed", seed, "which pairs are made")->capture_default_str();
  app.add_option("--threads", threads, "0: as many as there are processors")
      ->check(CLI::Range(0u, most_threads))
      ->capture_default_str();
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
