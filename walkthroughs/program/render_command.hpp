/// gjkstep render: which walkthroughs, how large, in which colours, and where to.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace walkthroughs {

struct RenderCommand {
  std::vector<std::string> names;
  std::vector<std::string> traces;  ///< files
  bool all = false;
  bool strip = false;
  bool apng = false;
  std::string page;   ///< "beside" or "single"; empty: none
  std::string sheet;  ///< "one" picture, or a paper such as "a4-across"; empty: none
  bool no_captions = false, no_values = false;
  std::optional<std::string> letters;
  bool rendered_by = false;
  bool force = false;
  int turns = 0;
  double frame_time = 2;
  std::string format = "png";
  std::string detail = "decision";
  std::string theme = "report";
  std::string out = "out";
  std::optional<std::string> frames;
  std::optional<std::string> gl;
  std::optional<std::string> size;
  std::optional<double> text_scale;  ///< of the theme, if nothing else is said
  std::optional<std::string> movie;
  std::optional<std::string> captions;

  /// Writes the files and tells of each on standard output. Everything that can be wrong with the words of the command is
  /// found before the first file is written.
  /// Errors: UsageError, and those of whatever it calls.
  void run() const;
};

/// Adds the command to `app`; parsing fills `render`, which must live as long.
CLI::App* add_render_command(CLI::App& app, RenderCommand& render);

}  // namespace walkthroughs
