/// The commands of gjkstep: the words that each takes, and what it does with them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

namespace walkthroughs {

struct Command {
  CLI::App* words;
  std::function<int()> run;  ///< Returns: the exit code. Errors: those that exit_code_of() tells.
};

Command add_list_command(CLI::App& app);
/// `gl` is what --gl says, before the command or after it. It must live as long as the command.
Command add_render_command(CLI::App& app, std::optional<std::string>& gl);
Command add_trace_command(CLI::App& app);
Command add_scene_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_query_command(CLI::App& app);

}  // namespace walkthroughs
