/// gjkstep query: pairs of objects on standard input, answers on standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace walkthroughs {

struct QueryCommand {
  std::string scalar = "double", rules = "as-intended", zero_test = "exact";
  int max_iterations = 20;
  std::optional<std::string> start, first_direction;
  bool certified = false, fractions = false;

  /// Returns: the exit code: 0, or 3 where a line was bad (told on standard error; the others are answered).
  /// Errors: UsageError; InputError where standard input cannot be read; render::FileError where standard output cannot be
  /// written.
  int run() const;
};

CLI::App* add_query_command(CLI::App& app, QueryCommand& query);

}  // namespace walkthroughs
