/// gjkstep compare: are two pictures, or two folders of pictures, the same?
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace walkthroughs {

struct CompareCommand {
  std::string expected, actual;
  std::optional<std::string> report;  ///< folder to write index.html to
  bool force = false;

  /// Returns: the exit code: 0 the same, 1 different, 3 a picture cannot be read (told on standard error).
  /// Errors: UsageError; render::ReadError where a side is not there; render::FileError where the report cannot be
  /// written.
  int run() const;
};

CLI::App* add_compare_command(CLI::App& app, CompareCommand& compare);

}  // namespace walkthroughs
