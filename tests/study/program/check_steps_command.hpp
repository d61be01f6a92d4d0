/// `gjkstep-study check-steps FILE`: which is the first step of a search that the report's algorithm would not make?
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace study {

struct CheckStepsCommand {
  std::string file;
  std::optional<std::string> draw;  ///< folder

  void add_to(CLI::App& app);
  /// Errors: std::runtime_error where a step is wrong, after everything is written; walkthroughs::InputError.
  void run() const;
};

}  // namespace study
