// gjkstep: watch GJK decide. Reads the command line, calls the rest, turns failures into exit codes.

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

#include "render/offscreen_context.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/compare_command.hpp"
#include "walkthroughs/program/exit_code.hpp"
#include "walkthroughs/program/list_command.hpp"
#include "walkthroughs/program/query_command.hpp"
#include "walkthroughs/program/render_command.hpp"
#include "walkthroughs/program/scene_command.hpp"
#include "walkthroughs/program/trace_command.hpp"
#include "walkthroughs/text/nearest.hpp"
#include "walkthroughs/text/printable.hpp"

namespace {

using walkthroughs::UsageError;

constexpr const char* footer =
    "Exit codes: 0 ok, 2 wrong usage, 3 bad input (a scene file, a trace, a query; also: a missing font), 4 no OpenGL "
    "context,\n"
    "5 cannot write, 1 anything else (of compare: pictures differ).\n"
    "Environment variables: GJKSTEP_FONT_DIR names the folder of the fonts, GJKSTEP_GL what to draw with, like --gl.";

void print_version(const std::optional<std::string>& gl) {
  const render::Backend backend = walkthroughs::chosen_backend(gl);
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
    const bool is_name = walkthroughs::find_walkthrough(word) != nullptr;
    complaint = "there is no command " + walkthroughs::in_quotes(word) + "; did you mean '" +
                (is_name ? "render " + word : walkthroughs::nearest(word, commands)) + "'?";
  }
  return complaint + (complaint.ends_with('?') ? " " : "; ") +
         "'gjkstep --help' and 'gjkstep COMMAND --help' show what there is";
}

int run(int argc, char** argv) {
  CLI::App app(
      "Draws, step by step, how the Gilbert-Johnson-Keerthi algorithm decides whether two convex objects "
      "collide.");
  app.footer(footer);
  app.require_subcommand(0, 1);
  bool version = false;
  app.add_flag("--version", version, "print the version and the OpenGL renderer");
  walkthroughs::RenderCommand render;
  walkthroughs::add_backend_option(app, render.gl);
  walkthroughs::ListCommand list;
  CLI::App* const list_command = walkthroughs::add_list_command(app, list);
  CLI::App* const render_command = walkthroughs::add_render_command(app, render);
  walkthroughs::TraceCommand trace;
  CLI::App* const trace_command = walkthroughs::add_trace_command(app, trace);
  walkthroughs::SceneCommand scene;
  CLI::App* const scene_command = walkthroughs::add_scene_command(app, scene);
  walkthroughs::CompareCommand compare;
  CLI::App* const compare_command = walkthroughs::add_compare_command(app, compare);
  walkthroughs::QueryCommand query;
  CLI::App* const query_command = walkthroughs::add_query_command(app, query);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return walkthroughs::ok;
  } catch (const CLI::ParseError& error) {
    throw UsageError(what_was_wrong(app, error));
  }
  int answer = walkthroughs::ok;
  if (version && !app.get_subcommands().empty())
    throw UsageError("--version stands alone; leave it out, or '" + app.get_subcommands().front()->get_name() + "'");
  if (render.gl && !version && !*render_command && !app.get_subcommands().empty())
    throw UsageError("--gl: '" + app.get_subcommands().front()->get_name() + "' draws nothing; leave --gl out");
  if (version)
    print_version(render.gl);
  else if (*list_command)
    list.run();
  else if (*render_command)
    render.run();
  else if (*trace_command)
    trace.run();
  else if (*scene_command)
    scene.run();
  else if (*compare_command)
    answer = compare.run();
  else if (*query_command)
    answer = query.run();
  else
    throw UsageError("what to do? 'gjkstep --help' shows the commands");
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  return walkthroughs::exit_code_of("gjkstep", "ask for less, such as fewer points or a smaller --size",
                                    [&] { return run(argc, argv); });
}
