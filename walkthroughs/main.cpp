// gjkstep: watch GJK decide. Reads the command line, calls the rest, turns failures into exit codes.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>
#include <optional>

#include "render/image.hpp"
#include "walkthroughs/alternative_text.hpp"
#include "walkthroughs/nearest.hpp"
#include "walkthroughs/render_frames.hpp"
#include "walkthroughs/scene_file.hpp"
#include "walkthroughs/trace_json.hpp"
#include "walkthroughs/words.hpp"

namespace {

using walkthroughs::Walkthrough;

enum ExitCode { ok = 0, unexpected = 1, wrong_usage = 2, bad_input = 3, no_context = 4, cannot_write = 5 };

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr const char* footer =
    "Exit codes: 0 ok, 2 wrong usage, 3 bad input (also: a missing font), 4 no OpenGL context, 5 cannot write,\n"
    "1 anything else.\n"
    "The folder of the fonts can be named by the environment variable GJKSTEP_FONT_DIR.";

const Walkthrough& walkthrough_named(const std::string& name) {
  if (const Walkthrough* found = walkthroughs::find_walkthrough(name)) return *found;
  throw UsageError("there is no walkthrough '" + name + "'; did you mean '" + walkthroughs::nearest_name(name) +
                   "'? 'gjkstep list' shows all");
}

/// Reads "1280x720".
render::Size parse_size(const std::string& text) {
  render::Size size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool has_x = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_x ? std::from_chars(width.ptr + 1, end, size.height) : width;
  const auto fits = [](int pixels) { return render::min_pixels <= pixels && pixels <= render::max_pixels; };
  if (!has_x || height.ec != std::errc() || height.ptr != end || !fits(size.width) || !fits(size.height))
    throw UsageError("--size '" + text + "': expected WIDTHxHEIGHT in pixels, for example 1280x720, each from " +
                     std::to_string(render::min_pixels) + " to " + std::to_string(render::max_pixels));
  return size;
}

void list() {
  std::size_t widest = 0;
  for (const Walkthrough& w : walkthroughs::catalogue()) widest = std::max(widest, w.name.size());
  for (const Walkthrough& w : walkthroughs::catalogue())
    std::cout << w.name << std::string(widest + 2 - w.name.size(), ' ') << w.summary << '\n';
}

struct RenderCommand {
  std::vector<std::string> names;
  bool all = false;
  bool strip = false;
  bool sheet = false;
  bool no_captions = false;
  std::string detail = "decision";
  std::string out = "out";
  std::string size = "1280x720";
  std::optional<std::string> captions;

  /// Everything that can be wrong with the words of the command is found before the first file is written.
  void run() const {
    const std::vector<const Walkthrough*> chosen = chosen_walkthroughs();
    if (out.empty()) throw UsageError("--out '': name a folder to write to, for example --out pictures");
    const walkthroughs::Look look{.text = no_captions ? walkthroughs::Text::none : walkthroughs::Text::around};
    const walkthroughs::Output output{out, parse_size(size), look};
    const walkthroughs::Detail shown = detail == "step" ? walkthroughs::Detail::step : walkthroughs::Detail::decision;
    walkthroughs::Studio studio;
    std::vector<walkthroughs::Story> stories;
    stories.reserve(chosen.size());
    std::vector<walkthroughs::FrameFile> written;
    for (const Walkthrough* w : chosen) {
      const walkthroughs::Story& story = stories.emplace_back(walkthroughs::tell(*w, shown));
      walkthroughs::render_frames(story, output, studio, [&](const std::filesystem::path& file, std::size_t index) {
        written.push_back({file, story, index});
        report(written.back());
      });
      if (strip) std::cout << walkthroughs::render_strip(story, output, studio).string() << "  " << w->title << '\n';
      if (sheet) std::cout << walkthroughs::render_sheet(story, output, studio).string() << "  " << w->title << '\n';
    }
    if (captions) write_captions(written);
  }

 private:
  std::vector<const Walkthrough*> chosen_walkthroughs() const {
    std::vector<const Walkthrough*> chosen;
    const auto choose = [&](const Walkthrough& w) {
      if (std::ranges::count(chosen, &w) == 0) chosen.push_back(&w);
    };
    for (const std::string& name : names) choose(walkthrough_named(name));
    if (all) std::ranges::for_each(walkthroughs::catalogue(), choose);
    if (chosen.empty()) throw UsageError("render what? name walkthroughs, or say --all; 'gjkstep list' shows them");
    return chosen;
  }

  /// One line for each file, and on a terminal how far it is.
  static void report(const walkthroughs::FrameFile& frame) {
    static const bool terminal = isatty(STDERR_FILENO) != 0;
    const std::size_t count = frame.story.frames.size();
    if (terminal) std::cerr << "\r\033[K";
    std::cout << frame.file.string() << "  " << walkthroughs::plain(frame.story.frames[frame.index].caption)
              << std::endl;
    if (terminal && frame.index + 1 < count)
      std::cerr << frame.story.walkthrough.name << ": frame " << frame.index + 1 << " of " << count << std::flush;
  }

  void write_captions(const std::vector<walkthroughs::FrameFile>& written) const {
    const std::string text = walkthroughs::captions_json(written);
    render::write_file(*captions, std::vector<std::uint8_t>(text.begin(), text.end()));
    std::cout << *captions << "  captions and descriptions of the frames\n";
  }
};

struct SceneCommand {
  bool example = false;
  std::optional<std::string> check;

  void run() const {
    if (example) {
      std::cout << walkthroughs::example_scene();
    } else if (check) {
      const walkthroughs::SceneFile scene = walkthroughs::read_scene(*check);
      std::cout << *check << ": ok: " << walkthroughs::summary(scene) << '\n';
    } else {
      throw UsageError("scene: say --example to see a scene file, or --check FILE to have one checked");
    }
  }
};

void print_version() {
  std::cout << "gjkstep " << GJKSTEP_VERSION << std::endl;
  std::cout << render::OffscreenContext().description() << '\n';
}

ExitCode flush_output() {
  if (!std::cout.flush()) throw render::FileError("cannot write to standard output");
  return ok;
}

/// Returns: the parser's complaint and what to do about it.
std::string what_was_wrong(const CLI::App& app, const CLI::ParseError& error) {
  std::string complaint = error.what();
  if (app.get_subcommands().empty() && !app.remaining().empty()) {
    const std::string word = app.remaining().front();
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    const bool is_name = walkthroughs::find_walkthrough(word) != nullptr;
    complaint = "there is no command '" + word + "'; did you mean '" +
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
  CLI::App* const list_command = app.add_subcommand("list", "the walkthroughs, one line each");

  RenderCommand render;
  CLI::App* const render_command = app.add_subcommand("render", "write the frames OUT/NAME/000.png, 001.png, ...");
  render_command->add_option("NAME", render.names, "walkthroughs to render");
  render_command->add_flag("--all", render.all, "render every walkthrough");
  render_command->add_flag("--strip", render.strip,
                           "write OUT/NAME/strip.png as well: one wide picture of all iterations");
  render_command->add_flag("--sheet", render.sheet, "write OUT/NAME/sheet.png as well: all frames on one page");
  render_command->add_option("--detail", render.detail, "a frame for each decision, or for each step (iteration)")
      ->check(CLI::IsMember({"decision", "step"}))
      ->capture_default_str();
  render_command->add_flag("--no-captions", render.no_captions, "draw the panels only, for use in a document");
  render_command->add_option("--captions", render.captions,
                             "JSON file to write: caption, description and events of each frame");
  render_command->add_option("--out", render.out, "folder to write to")->capture_default_str();
  render_command->add_option("--size", render.size, "width and height in pixels")->capture_default_str();

  std::string traced;
  CLI::App* const trace_command = app.add_subcommand("trace", "print the events of a walkthrough as JSON Lines");
  trace_command->add_option("NAME", traced, "walkthrough to trace")->required();

  SceneCommand scene;
  CLI::App* const scene_command = app.add_subcommand("scene", "files with scenes of your own");
  CLI::Option* const example =
      scene_command->add_flag("--example", scene.example, "print a scene file that shows every key");
  scene_command->add_option("--check", scene.check, "read this scene file and say what it declares")->excludes(example);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return flush_output();
  } catch (const CLI::ParseError& error) {
    throw UsageError(what_was_wrong(app, error));
  }
  if (version)
    print_version();
  else if (*list_command)
    list();
  else if (*render_command)
    render.run();
  else if (*trace_command)
    walkthroughs::write_traces(std::cout, walkthrough_named(traced));
  else if (*scene_command)
    scene.run();
  else
    throw UsageError("what to do? 'gjkstep --help' shows the commands");
  return flush_output();
}

int fail(ExitCode code, const std::exception& error) {
  std::cerr << "gjkstep: " << error.what() << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return fail(wrong_usage, error);
  } catch (const render::FontError& error) {
    return fail(bad_input, error);
  } catch (const walkthroughs::SceneError& error) {
    return fail(bad_input, error);
  } catch (const render::ContextError& error) {
    return fail(no_context, error);
  } catch (const render::FileError& error) {
    return fail(cannot_write, error);
  } catch (const std::bad_alloc&) {
    return fail(unexpected, std::runtime_error("out of memory; choose a smaller --size"));
  } catch (const std::exception& error) {
    return fail(unexpected, error);
  }
}
