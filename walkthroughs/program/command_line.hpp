/// The commands of gjkstep, and what the words of all of them have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/offscreen_context.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/program/exit_code.hpp"

namespace walkthroughs::program {

/// The words that a command takes, and what it does with them.
struct Command {
  CLI::App* words;
  std::function<int()> run;  ///< Returns: the exit code. Errors: those that exit_code_of() tells.
};

Command add_list_command(CLI::App& app);
/// `gl`, here and below, is what --gl says, before the command or after it. It must live as long as the command.
Command add_render_command(CLI::App& app, std::optional<std::string>& gl);
Command add_trace_command(CLI::App& app);
Command add_scene_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_query_command(CLI::App& app);
Command add_judge_command(CLI::App& app, std::optional<std::string>& gl);

/// Errors: UsageError, with the name that was probably meant.
const Walkthrough& walkthrough_named(const std::string& name);

/// Returns: the walkthrough of that name, or those of the folder of that name. Errors: as walkthrough_named().
std::vector<const Walkthrough*> walkthroughs_named(const std::string& name);

/// The option --gl of all commands that draw. Adding it to a command fills `name`, which must live as long.
void add_backend_option(CLI::App& command, std::optional<std::string>& name);

/// Returns: the backend of that name (what --gl says); else the one that the environment variable GJKSTEP_GL names; else
/// the default. Whether this build has it shows when the context is made.
/// Errors: UsageError, with the names that there are.
render::Backend chosen_backend(const std::optional<std::string>& name);

/// Options of render that may have a word behind them, and which; alone they mean the first: --page is --page=beside.
inline const std::map<std::string, std::vector<std::string>> words_of_flags{
    {"--sheet", {"one", "a4", "letter", "a4-across", "letter-across"}}, {"--page", {"beside", "single"}}};

/// The option --force of all commands that write files. Adding it to a command fills `force`, which must live as long.
void add_force_flag(CLI::App& command, bool& force);

/// Errors: UsageError where standard output is the file that is to be read. `what`: the file is, in that message.
void expect_output_apart_from(const std::string& file, const std::string& what = "the scene file");

/// Whether a word of the command line means a scene file and not a walkthrough: whether it ends in .json, in capitals or not.
bool is_scene_file(const std::string& name);

}  // namespace walkthroughs::program
