/// gjkstep list: the walkthroughs that there are.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace walkthroughs {

struct ListCommand {
  std::optional<std::string> name;

  /// Errors: UsageError where nothing has that name or says that word.
  void run() const;
};

CLI::App* add_list_command(CLI::App& app, ListCommand& list);

}  // namespace walkthroughs
