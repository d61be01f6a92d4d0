/// From chosen walkthroughs to files: pictures, pages, and what else is asked for.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/geometry.hpp"
#include "render/offscreen_context.hpp"
#include "walkthroughs/output/sink.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::program {

/// What is drawn, how, and where to.
struct RenderOptions {
  bool strip = false;
  bool apng = false;
  std::string page;   ///< "beside" or "single"; empty: none
  std::string sheet;  ///< "one" picture, or a paper such as "a4-across"; empty: none
  bool deck = false, handout = false, quiz = false;
  bool no_captions = false, no_values = false;
  std::optional<std::string> letters;
  std::string report;  ///< a page that shows them and lies beside the index, to which pages lead; empty: none
  bool rendered_by = false;
  bool force = false;
  bool is_quiet = false;  ///< tells nothing of what is written, nor what the pictures do not tell
  int turns = 0;
  double frame_time = 2;
  std::optional<double> hold;  ///< of the last frame

  double last_frame_time() const { return hold.value_or(2 * frame_time); }
  std::string format = "png";
  std::string detail = "decision";
  std::string theme = "report";
  std::string out = "out";
  std::optional<std::string> frames;
  render::Backend backend = render::default_backend();
  std::optional<std::string> size;
  std::optional<double> text_scale;  ///< of the theme, if nothing else is said
  std::optional<std::string> movie;
  std::optional<std::string> captions;
  std::optional<std::string> zip;
};

/// A walkthrough that the words of a command choose.
struct Chosen {
  Walkthrough walkthrough;
  std::string option = {};                        ///< of the command line, before the file
  std::filesystem::path file = {};                ///< that describes it; empty where it is one of the catalogue
  std::optional<render::Size> size = {};          ///< that the file asks for
  std::optional<double> text_scale = {};          ///< the same
  std::optional<std::vector<Trace>> traces = {};  ///< where they have been read
  std::string scene = {};                         ///< the text of a scene file
  const Story* told = nullptr;                    ///< where it has been told already; it must live as long
  std::string made_by = {};                       ///< the command that tells it, where that is not render
};

/// On a terminal, what is being done: in place of what was being done before, nothing where `what` is empty.
void progress(const std::string& what);

/// Errors: UsageError where a place has no name, or a size is none.
void expect_usable(const RenderOptions& options);

/// Adds what is written of these, and what it is about.
void add_written(Places& places, const RenderOptions& options, const std::vector<Chosen>& chosen);

/// Writes the files and tells of each on standard output. Everything that can be wrong with the options is found before the first
/// file is written.
/// `last`: a further format, which is given each story after the others.
/// Requires: options that are usable; walkthroughs with names of their own. Errors: UsageError, and those of whatever it calls.
void render_all(const RenderOptions& options, const std::vector<Chosen>& chosen, std::unique_ptr<Sink> last = {});

}  // namespace walkthroughs::program
