// gjkstep-study: measure the trade of speed against accuracy. Reads the command line, turns failures into exit codes.
#include <CLI/CLI.hpp>

#include "tests/study/program/commands.hpp"
#include "walkthroughs/program/exit_code.hpp"

namespace {

constexpr const char* footer =
    "Exit codes: 0 ok, 2 wrong usage, 3 bad input (an unreadable file),\n"
    "5 cannot write, 1 GJK in exact numbers or a certified answer is at odds with the oracle, or anything else.";

int run(int argc, char** argv) {
  CLI::App app("Measures how often GJK is wrong or undecided, and how long it takes, against an exact oracle.");
  app.footer(footer);
  app.require_subcommand(0, 1);
  using namespace study;
  for (const auto add : {add_run, add_claims, add_pairs, add_listing}) add(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return walkthroughs::program::ok;
  } catch (const CLI::ParseError& error) {
    throw walkthroughs::program::UsageError(std::string(error.what()) +
                                            "; 'gjkstep-study --help' and 'gjkstep-study COMMAND --help' " +
                                            "show what there is");
  }
  if (app.get_subcommands().empty())
    throw walkthroughs::program::UsageError("what to do? 'gjkstep-study --help' shows the commands");
  return walkthroughs::program::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return walkthroughs::program::exit_code_of("gjkstep-study", "ask for fewer --families or --threads",
                                             [&] { return run(argc, argv); });
}
