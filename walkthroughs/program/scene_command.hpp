/// gjkstep scene: files with scenes of one's own.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace walkthroughs {

struct SceneCommand {
  bool example = false;
  std::optional<std::string> check;

  /// Errors: UsageError; InputError where the file is not a scene.
  void run() const;
};

CLI::App* add_scene_command(CLI::App& app, SceneCommand& scene);

}  // namespace walkthroughs
