// gjkstep-study: measure the trade of speed against accuracy. Reads the command line, turns failures into exit codes.
#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <new>

#include "render/file.hpp"
#include "tests/study/program/commands.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace {

enum ExitCode { ok = 0, unexpected = 1, wrong_usage = 2, bad_input = 3, cannot_write = 5 };

constexpr const char* footer =
    "Exit codes: 0 ok, 2 wrong usage, 3 bad input (shards that do not go together, an unreadable file),\n"
    "5 cannot write, 1 GJK in exact numbers is at odds with the oracle, or anything else.";

int flush_output() {
  if (!std::cout.flush())
    throw render::FileError(
        "cannot write to standard output; check that the disk has space left, or that who reads has not left");
  return ok;
}

int run(int argc, char** argv) {
  CLI::App app("Measures how often GJK is wrong or undecided, and how long it takes, against an exact oracle.");
  app.footer(footer);
  app.require_subcommand(0, 1);
  study::Commands commands;
  commands.add_to(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return flush_output();
  } catch (const CLI::ParseError& error) {
    throw study::UsageError(std::string(error.what()) + "; 'gjkstep-study --help' and 'gjkstep-study COMMAND --help' " +
                            "show what there is");
  }
  commands.run();
  return flush_output();
}

int fail(ExitCode code, const std::exception& error) {
  std::cerr << "gjkstep-study: " << error.what() << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a gnuplot that is not there, or a reader who leaves, is an error of writing
  std::signal(SIGXFSZ, SIG_IGN);  // as is a file that may not grow
  try {
    return run(argc, argv);
  } catch (const study::UsageError& error) {
    return fail(wrong_usage, error);
  } catch (const study::StudyError& error) {
    return fail(bad_input, error);
  } catch (const walkthroughs::InputError& error) {
    return fail(bad_input, error);
  } catch (const render::FileError& error) {
    return fail(cannot_write, error);
  } catch (const std::bad_alloc&) {
    return fail(unexpected,
                std::runtime_error("out of memory; ask for fewer --families or --threads, or merge fewer files"));
  } catch (const std::exception& error) {
    return fail(unexpected, error);
  }
}
