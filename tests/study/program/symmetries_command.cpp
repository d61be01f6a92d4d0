#include "tests/study/program/symmetries_command.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "tests/study/program/progress.hpp"
#include "tests/study/sweep/plan.hpp"
#include "tests/study/symmetries/symmetries.hpp"
#include "walkthroughs/program/number_option.hpp"

namespace study {

using walkthroughs::expect_number;

void SymmetriesCommand::add_to(CLI::App& app) {
  expect_number(app.add_option("--pairs", pairs, "so many of each family of points, in double and in float")
                    ->capture_default_str(),
                std::uint64_t{1}, most_pairs);
  expect_number(app.add_option("--seed", seed, "which pairs are made")->capture_default_str(), std::uint64_t{0},
                most_seed);
  expect_number(app.add_option("--threads", threads, "0: as many as there are processors")->capture_default_str(), 0u,
                most_threads);
}

void SymmetriesCommand::run() const {
  std::cerr << "seed " << seed << '\n';
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  ProgressLine line;
  const bool is_good = write_symmetries(
      std::cout,
      {.pairs = pairs, .seed = seed, .threads = threads > 0 ? threads : processors, .progress = std::ref(line)});
  if (!is_good)
    throw std::logic_error(
        "a certified answer changed where it must not, or its certificate does not hold: see the table");
}

}  // namespace study
