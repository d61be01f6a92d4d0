// gjkstep: watch GJK decide. Reads the command line, calls the rest, turns failures into exit codes.

#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "render/offscreen_context.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/exit_code.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::program {
namespace {

constexpr const char* footer =
    "Exit codes: 0 ok, 2 wrong usage, 3 bad input (a scene file, a trace, a query; also: a missing font), 4 no OpenGL "
    "context,\n"
    "5 cannot write, 1 anything else (of compare: pictures differ).\n"
    "Environment variables: GJKSTEP_FONT_DIR names the folder of the fonts, GJKSTEP_GL what to draw with, like --gl.";

void print_version(const std::optional<std::string>& gl) {
  const render::Backend backend = chosen_backend(gl);
  std::cout << "gjkstep " << GJKSTEP_VERSION << std::endl;
  std::cout << render::OffscreenContext(backend).description() << '\n';
}

/// Returns: the parser's complaint, that an option has too few or too many values in words of ours.
std::string complaint_of(const CLI::ParseError& error) {
  const std::string said = error.what(), option = said.substr(0, said.find(": "));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return said;
  if (said.starts_with(option + ": At Most 1 ")) return option + " is given more than once; give it once";
  return said.ends_with(" missing") ? option + " has no value; give it one" : said;
}

/// Returns: the complaint and what to do about it.
std::string what_was_wrong(const CLI::App& app, const CLI::ParseError& error) {
  std::string complaint = complaint_of(error);
  if (app.get_subcommands().empty() && !app.remaining().empty()) {
    const std::string word = app.remaining().front();
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    const bool is_name = find_walkthrough(word) != nullptr;
    complaint = "there is no command " + in_quotes(word) + "; " +
                did_you_mean(is_name ? "render " + word : nearest(word, commands));
  }
  return complaint + (complaint.ends_with(' ') ? "" : "; ") +
         "'gjkstep --help' and 'gjkstep COMMAND --help' show what there is";
}

/// Returns: the words of the command line, the last first, as the parser wants them. "--sheet a4" is "--sheet=a4".
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (const auto flag = words_of_flags.find(words[i]);
        flag != words_of_flags.end() && std::ranges::count(flag->second, words[i + 1]) > 0) {
      words[i] += "=" + words[i + 1];
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
  std::ranges::reverse(words);
  return words;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Draws, step by step, how the Gilbert-Johnson-Keerthi algorithm decides whether two convex objects "
      "collide.");
  app.name(argc > 0 ? argv[0] : "gjkstep");
  app.footer(footer);
  app.require_subcommand(0, 1);
  bool version = false;
  app.add_flag("--version", version, "print the version and the OpenGL renderer");
  std::optional<std::string> gl;
  add_backend_option(app, gl);
  const std::vector<Command> commands = {add_list_command(app),     add_render_command(app, gl), add_trace_command(app),
                                         add_scene_command(app),    add_compare_command(app),    add_query_command(app),
                                         add_judge_command(app, gl)};

  try {
    app.parse(words_of(argc, argv));
  } catch (const CLI::Success& help) {
    app.exit(help);
    return ok;
  } catch (const CLI::ParseError& error) {
    throw UsageError(what_was_wrong(app, error));
  }
  const auto chosen = std::ranges::find_if(commands, [](const auto& each) { return each.words->parsed(); });
  const std::string name = chosen == commands.end() ? "" : chosen->words->get_name();
  if (version && !name.empty()) throw UsageError("--version stands alone; leave it out, or '" + name + "'");
  if (gl && !name.empty() && name != "render" && name != "judge")
    throw UsageError("--gl: '" + name + "' draws nothing; leave --gl out");
  if (!version && name.empty()) throw UsageError("what to do? 'gjkstep --help' shows the commands");
  if (!version) return chosen->run();
  print_version(gl);
  return ok;
}

}  // namespace
}  // namespace walkthroughs::program

int main(int argc, char** argv) {
  // Mesa would keep what it compiles in the home folder, which is none of ours. It takes a twentieth of a second to do without.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
#ifdef __GLIBC__
  // Each picture takes megabytes and gives them back. They are kept for the next one, which saves a tenth of the time.
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
  ::mallopt(M_TRIM_THRESHOLD, 512 << 20);
#endif
  return walkthroughs::program::exit_code_of("gjkstep", "ask for less, such as fewer points or a smaller --size",
                                             [&] { return walkthroughs::program::run(argc, argv); });
}
