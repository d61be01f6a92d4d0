#include "tests/study/program/symmetries_command.hpp"

#include <iostream>
#include <stdexcept>

#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"
#include "tests/study/symmetries/symmetries.hpp"

namespace study {

using walkthroughs::expect_number;

void SymmetriesCommand::add_to(CLI::App& app) {
  expect_number(app.add_option("--pairs", pairs, "so many of each family of points, in double and in float")
                    ->capture_default_str(),
                std::uint64_t{1}, most_pairs);
  add_seed(app, seed);
  add_threads(app, threads);
}

void SymmetriesCommand::run() const {
  std::cerr << "seed " << seed << '\n';
  ProgressLine line;
  const bool is_good = write_symmetries(
      std::cout, {.pairs = pairs, .seed = seed, .threads = threads_of(threads), .progress = std::ref(line)});
  if (!is_good)
    throw std::logic_error(
        "a certified answer changed where it must not, or its certificate does not hold: see the table");
}

}  // namespace study
