#include "tests/study/claims_command.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <thread>

#include "tests/study/claims.hpp"

namespace study {

void add_claims_command(CLI::App& program) {
  auto* const command = program.add_subcommand("claims", "Measures what the report claims; prints Markdown");
  const auto options = std::make_shared<ClaimsOptions>();
  const auto quick = std::make_shared<bool>(false);
  options->threads = std::max(1U, std::thread::hardware_concurrency());
  auto* const pairs = command->add_option("--pairs", options->pairs, "How many pairs of every kind")
                          ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40));
  command->add_option("--seed", options->seed, "Other pairs of the same kinds");
  command->add_option("--threads", options->threads, "Changes nothing in the text")->check(CLI::Range(1U, 1024U));
  command->add_flag("--quick", *quick, "20,000 pairs of every kind: a few seconds")->excludes(pairs);
  command->callback([options, quick] {
    if (*quick) options->pairs = 20'000;
    options->progress = [](const std::string& what) { std::cerr << what << '\n'; };
    write_claims(std::cout, *options);
  });
}

}  // namespace study
