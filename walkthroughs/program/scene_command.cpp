// gjkstep scene: files with scenes of one's own.

#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/story/warnings.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace walkthroughs::program {
namespace {

struct SceneCommand {
  bool example = false;
  std::optional<std::string> check;

  /// Errors: UsageError; InputError where the file is not a scene.
  int run() const {
    if (!example && !check)
      throw UsageError("scene: say --example to see a scene file, or --check FILE to have one checked");
    if (example) {
      std::cout << example_scene();
      return ok;
    }
    if (check->empty()) throw UsageError("scene --check '': name a scene file, or - for standard input");
    expect_output_apart_from(*check);
    const SceneFile file = read_scene(*check);
    const std::string declared = summary(file);  // before the first word that says it is well
    std::cout << printable(called(*check)) << ": ok: " << declared
              << (is_scene_file(*check) ? "" : ". Before it is drawn, give it a name that ends in .json") << '\n';
    for (const std::string& warning : warnings_about(file.walkthrough.scenes.back()))
      std::cout << printable(called(*check)) << ": warning: " << warning << '\n';
    return ok;
  }
};

}  // namespace

Command add_scene_command(CLI::App& app) {
  const auto scene = std::make_shared<SceneCommand>();
  CLI::App* const command = app.add_subcommand("scene", "files with scenes of your own");
  CLI::Option* const example =
      command->add_flag("--example", scene->example, "print a scene file that shows every key");
  command
      ->add_option("--check", scene->check,
                   "read this scene file (- for standard input), say what it declares and warn of rounding")
      ->excludes(example);
  return {command, [scene] { return scene->run(); }};
}

}  // namespace walkthroughs::program
