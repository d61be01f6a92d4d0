/// gjkstep trace: the events of a walkthrough or a scene file as JSON Lines.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace walkthroughs {

struct TraceCommand {
  bool schema = false;
  std::string name;

  /// Errors: UsageError; InputError where a scene file cannot be read.
  void run() const;
};

CLI::App* add_trace_command(CLI::App& app, TraceCommand& trace);

}  // namespace walkthroughs
