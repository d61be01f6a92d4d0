// gjkstep: watch GJK decide. Reads the command line, calls the rest, turns failures into exit codes.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <deque>
#include <iostream>
#include <memory>
#include <optional>
#include <set>

#include "render/image.hpp"
#include "walkthroughs/alternative_text.hpp"
#include "walkthroughs/compare_command.hpp"
#include "walkthroughs/listing.hpp"
#include "walkthroughs/movie.hpp"
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
    "Exit codes: 0 ok, 2 wrong usage, 3 bad input (a scene file; also: a missing font), 4 no OpenGL context,\n"
    "5 cannot write, 1 anything else (of compare: pictures differ).\n"
    "The folder of the fonts can be named by the environment variable GJKSTEP_FONT_DIR.";

const Walkthrough& walkthrough_named(const std::string& name) {
  if (const Walkthrough* found = walkthroughs::find_walkthrough(name)) return *found;
  throw UsageError("there is no walkthrough '" + name + "'; did you mean '" + walkthroughs::nearest_name(name) +
                   "'? 'gjkstep list' shows all");
}

/// Returns: the walkthrough of that name, or those of the folder of that name.
std::vector<const Walkthrough*> walkthroughs_named(const std::string& name) {
  const std::vector<const Walkthrough*> found = walkthroughs::find_walkthroughs(name);
  return found.empty() ? std::vector{&walkthrough_named(name)} : found;
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

bool is_scene_file(const std::string& name) { return name.ends_with(".json"); }

void trace(const std::string& name) {
  if (is_scene_file(name)) return walkthroughs::write_traces(std::cout, walkthroughs::read_scene(name).walkthrough);
  if (walkthroughs::find_walkthrough(name) == nullptr && !walkthroughs::find_walkthroughs(name).empty())
    throw UsageError("'" + name + "' is a folder: name one of its walkthroughs; 'gjkstep list " + name +
                     "' shows them");
  const Walkthrough& found = walkthrough_named(name);
  if (found.layout == walkthroughs::Layout::diagrams)
    throw UsageError("'" + name + "' is a diagram, which no search makes: there is no trace of it");
  walkthroughs::write_traces(std::cout, found);
}

void list(const std::string& name) {
  if (name.empty())
    walkthroughs::write_list(std::cout, walkthroughs::catalogue());
  else
    walkthroughs::write_table(std::cout, walkthroughs_named(name));
}

const render::Theme& theme_named(const std::string& name) {
  if (name == "slides") return render::themes::slides;
  return name == "dark" ? render::themes::dark : render::themes::report;
}

/// The walkthroughs that the words of a command choose, each once, in the order named. Keeps those that files describe.
class Selection {
 public:
  struct Chosen {
    const Walkthrough* walkthrough;
    std::optional<render::Size> size = {};  ///< that its file asks for
  };

  void add(const std::string& word) {
    if (!is_scene_file(word)) return add(walkthroughs_named(word));
    if (!files_read_.insert(word).second) return;
    const walkthroughs::SceneFile& file = files_.emplace_back(walkthroughs::read_scene(word));
    refuse_name_twice(file.walkthrough, word);
    chosen_.push_back({&file.walkthrough, file.size});
  }
  void add(const std::vector<const Walkthrough*>& several) {
    for (const Walkthrough* w : several) {
      if (std::ranges::count(chosen_, w, &Chosen::walkthrough) > 0) continue;
      refuse_name_twice(*w, w->name);
      chosen_.push_back({w});
    }
  }
  const std::vector<Chosen>& chosen() const { return chosen_; }

 private:
  /// Pictures go to a folder of that name: the second walkthrough would overwrite those of the first.
  void refuse_name_twice(const Walkthrough& w, const std::string& word) const {
    for (const Chosen& other : chosen_)
      if (other.walkthrough->name == w.name)
        throw UsageError("'" + word + "': there is another walkthrough of the name '" + w.name +
                         "' on the command line; render them into different folders with --out");
  }

  std::deque<walkthroughs::SceneFile> files_;  // that do not move when more come
  std::set<std::string> files_read_;
  std::vector<Chosen> chosen_;
};

struct RenderCommand {
  std::vector<std::string> names;
  bool all = false;
  bool strip = false;
  bool sheet = false;
  bool apng = false;
  bool no_captions = false;
  int turns = 0;
  double frame_time = 2;
  std::string detail = "decision";
  std::string theme = "report";
  std::string out = "out";
  std::optional<std::string> size;
  std::optional<std::string> movie;
  std::optional<std::string> captions;

  /// Everything that can be wrong with the words of the command is found before the first file is written.
  void run() const {
    const walkthroughs::Output output = checked_output();
    const Selection selection = select();
    Written written;  // before the renderer, which writes what it was given even when it goes early
    walkthroughs::Studio studio;
    walkthroughs::Renderer renderer(studio);
    for (const Selection::Chosen& each : selection.chosen()) {
      walkthroughs::Output sized = output;
      if (!size && each.size) sized.size = *each.size;
      render(*each.walkthrough, sized, renderer, written);
    }
    renderer.finish();
    if (captions) write_captions(written.frames);
    if (movie) print_movies(selection, output);
  }

 private:
  /// What the file of captions is about; empty where none is asked for, so that stories go when their frames are drawn.
  struct Written {
    std::vector<walkthroughs::FrameFile> frames;
    std::vector<std::shared_ptr<const walkthroughs::Story>> stories;
  };

  static constexpr double shortest_frame = 0.02, longest_frame = 60;  // seconds

  walkthroughs::Output checked_output() const {
    if (out.empty()) throw UsageError("--out '': name a folder to write to, for example --out pictures");
    if (!(shortest_frame <= frame_time && frame_time <= longest_frame))
      throw UsageError("--frame-time: expected seconds from 0.02 to 60, for example 2");
    const walkthroughs::Look look{.style = walkthroughs::Style(theme_named(theme)),
                                  .text = no_captions ? walkthroughs::Text::none : walkthroughs::Text::around};
    return {.folder = out, .size = parse_size(size.value_or("1280x720")), .look = look, .turns = turns};
  }

  Selection select() const {
    Selection selection;
    for (const std::string& name : names) selection.add(name);
    if (all)
      for (const Walkthrough& w : walkthroughs::catalogue()) selection.add({&w});
    if (selection.chosen().empty())
      throw UsageError("render what? name walkthroughs, or say --all; 'gjkstep list' shows them");
    return selection;
  }

  void render(const Walkthrough& w, const walkthroughs::Output& output, walkthroughs::Renderer& renderer,
              Written& written) const {
    const walkthroughs::Detail shown = detail == "step" ? walkthroughs::Detail::step : walkthroughs::Detail::decision;
    const auto story = std::make_shared<const walkthroughs::Story>(walkthroughs::tell(w, shown));
    if (captions) written.stories.push_back(story);
    const auto report_frame = [this, story, &written](const std::filesystem::path& file, std::size_t index) {
      const walkthroughs::FrameFile frame{file, *story, index};
      if (captions) written.frames.push_back(frame);
      report(frame);
    };
    const auto report_file = [&w](const std::filesystem::path& file) {
      std::cout << file.string() << "  " << w.title << std::endl;
    };
    renderer.frames(*story, output, report_frame, apng ? std::optional(frame_time) : std::nullopt, report_file);
    if (strip) renderer.strip(*story, output, report_file);
    if (sheet) renderer.sheet(*story, output, report_file);
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

  void print_movies(const Selection& selection, const walkthroughs::Output& output) const {
    const walkthroughs::Movie kind = *movie == "gif" ? walkthroughs::Movie::gif : walkthroughs::Movie::mp4;
    for (const Selection::Chosen& each : selection.chosen())
      std::cout << walkthroughs::ffmpeg_line(kind, output.folder / each.walkthrough->name, frame_time,
                                             output.look.style.theme.paper)
                << '\n';
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

CLI::App* add_render_command(CLI::App& app, RenderCommand& render) {
  CLI::App* const command = app.add_subcommand("render", "write the frames OUT/NAME/000.png, 001.png, ...");
  command->add_option("NAME", render.names, "walkthroughs to render, folders of them, or scene files (.json)");
  command->add_flag("--all", render.all, "render every walkthrough");
  command->add_flag("--strip", render.strip, "write OUT/NAME/strip.png as well: one wide picture of all iterations");
  command->add_flag("--sheet", render.sheet, "write OUT/NAME/sheet.png as well: all frames on one page");
  command->add_flag("--apng", render.apng, "write OUT/NAME/animation.png as well: all frames as an animated PNG");
  command->add_option("--movie", render.movie, "print the ffmpeg command that makes OUT/NAME/animation.mp4 or .gif")
      ->check(CLI::IsMember({"mp4", "gif"}));
  command
      ->add_option("--frame-time", render.frame_time,
                   "seconds for which animation and movie show a frame; the last one is shown twice as long")
      ->capture_default_str();
  command->add_option("--detail", render.detail, "a frame for each decision, or for each step (iteration)")
      ->check(CLI::IsMember({"decision", "step"}))
      ->capture_default_str();
  command->add_option("--theme", render.theme, "colours and weights: for a report, for slides, or on a dark ground")
      ->check(CLI::IsMember({"report", "slides", "dark"}))
      ->capture_default_str();
  command
      ->add_option("--turn", render.turns,
                   "further views of each frame of a scene in space, from all around: 000-turn-1.png, ...")
      ->check(CLI::Range(0, 72))
      ->capture_default_str();
  command->add_flag("--no-captions", render.no_captions, "draw the panels only, for use in a document");
  command->add_option("--captions", render.captions,
                      "JSON file to write: caption, description and events of each frame");
  command->add_option("--out", render.out, "folder to write to")->capture_default_str();
  command->add_option("--size", render.size,
                      "width and height in pixels; if not given, what the scene file says, or 1280x720");
  return command;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Draws, step by step, how the Gilbert-Johnson-Keerthi algorithm decides whether two convex objects "
      "collide.");
  app.footer(footer);
  app.require_subcommand(0, 1);
  bool version = false;
  app.add_flag("--version", version, "print the version and the OpenGL renderer");
  std::string listed;
  CLI::App* const list_command = app.add_subcommand("list", "the walkthroughs, one line each, or those of a folder");
  list_command->add_option("NAME", listed, "a folder or a walkthrough: its cases and how they end, as a table");
  RenderCommand render;
  CLI::App* const render_command = add_render_command(app, render);
  std::string traced;
  CLI::App* const trace_command = app.add_subcommand("trace", "print the events of a walkthrough as JSON Lines");
  trace_command->add_option("NAME", traced, "walkthrough or scene file (.json) to trace")->required();

  SceneCommand scene;
  CLI::App* const scene_command = app.add_subcommand("scene", "files with scenes of your own");
  CLI::Option* const example =
      scene_command->add_flag("--example", scene.example, "print a scene file that shows every key");
  scene_command->add_option("--check", scene.check, "read this scene file and say what it declares")->excludes(example);
  walkthroughs::CompareCommand compare;
  CLI::App* const compare_command = walkthroughs::add_compare_command(app, compare);

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
    list(listed);
  else if (*render_command)
    render.run();
  else if (*trace_command)
    trace(traced);
  else if (*scene_command)
    scene.run();
  else if (*compare_command) {
    const int answer = compare.run();
    flush_output();
    return answer;
  } else
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
  } catch (const walkthroughs::SceneError& error) {
    return fail(bad_input, error);
  } catch (const render::FontError& error) {
    return fail(bad_input, error);
  } catch (const render::ContextError& error) {
    return fail(no_context, error);
  } catch (const walkthroughs::CompareCommand::UsageError& error) {
    return fail(wrong_usage, error);
  } catch (const render::ReadError& error) {
    return fail(bad_input, error);
  } catch (const render::FileError& error) {
    return fail(cannot_write, error);
  } catch (const std::bad_alloc&) {
    return fail(unexpected, std::runtime_error("out of memory; choose a smaller --size"));
  } catch (const std::exception& error) {
    return fail(unexpected, error);
  }
}
