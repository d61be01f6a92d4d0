// gjkstep trace: the events of a walkthrough or a scene file as JSON Lines.

#include <iostream>
#include <memory>
#include <string>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::program {
namespace {

void write_trace(const std::string& name) {
  if (is_scene_file(name)) {
    expect_output_apart_from(name);
    return write_traces(std::cout, read_scene(name).walkthrough);
  }
  if (find_walkthrough(name) == nullptr && !find_walkthroughs(name).empty())
    throw UsageError(in_quotes(name) + " is a folder: name one of its walkthroughs; 'gjkstep list " + name +
                     "' shows them");
  const Walkthrough& found = walkthrough_named(name);
  if (found.layout == Layout::diagrams)
    throw UsageError(in_quotes(name) + " is a diagram, which no search makes: there is no trace of it");
  write_traces(std::cout, found);
}

struct TraceCommand {
  bool schema = false;
  std::string name;

  /// Errors: UsageError; InputError where a scene file cannot be read.
  int run() const {
    if (!schema && name.empty())
      throw UsageError("trace what? NAME is required: a walkthrough or a scene file; or say --schema");
    if (schema)
      std::cout << trace_schema();
    else
      write_trace(name);
    return ok;
  }
};

}  // namespace

Command add_trace_command(CLI::App& app) {
  const auto trace = std::make_shared<TraceCommand>();
  CLI::App* const command = app.add_subcommand("trace", "print the events of a walkthrough as JSON Lines");
  CLI::Option* const name =
      command->add_option("NAME", trace->name, "walkthrough or scene file (.json, or - for standard input) to trace");
  command->add_flag("--schema", trace->schema, "print the JSON Schema of one line of a trace")->excludes(name);
  return {command, [trace] { return trace->run(); }};
}

}  // namespace walkthroughs::program
