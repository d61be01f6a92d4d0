// gjkstep render: the words that say which walkthroughs, how large, in which colours, and where to.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/picture/style.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/program/rendering.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/trace/trace_file.hpp"

namespace walkthroughs::program {
namespace {

/// Walkthroughs that words choose, each once, in the order named.
class Selection {
 public:
  void add(const std::string& word) {
    if (!is_scene_file(word)) return add(walkthroughs_named(word));
    if (has_read(word)) return;
    std::string text = read_text(word, scene_limits::bytes);
    const SceneFile file = parse_scene(text, called(word));
    add({.walkthrough = file.walkthrough,
         .file = word,
         .size = file.size,
         .text_scale = file.text_scale,
         .scene = std::move(text)});
  }
  void add_trace(const std::string& file) {
    if (has_read(file)) return;
    const TraceFile read = read_trace(file);
    add({.walkthrough = read.walkthrough, .option = "--from-trace ", .file = file, .traces = read.traces});
  }
  void add(const std::vector<const Walkthrough*>& several) {
    for (const Walkthrough* w : several)
      if (std::ranges::none_of(chosen,
                               [&](const Chosen& c) { return c.file.empty() && c.walkthrough.name == w->name; }))
        add(Chosen{*w});
  }

  std::vector<Chosen> chosen;

 private:
  bool has_read(const std::string& file) const {
    return !file.empty() && std::ranges::count(chosen, std::filesystem::path(file), &Chosen::file) > 0;
  }

  /// Pictures go to a folder of its name: a second walkthrough of that name would overwrite those of the first.
  void add(Chosen one) {
    const std::string& name = one.walkthrough.name;
    if (std::ranges::any_of(chosen, [&](const Chosen& each) { return each.walkthrough.name == name; }))
      throw UsageError("'" + (one.file.empty() ? name : one.file.string()) +
                       "': there is another walkthrough of the name '" + name +
                       "' on the command line; render them into different folders with --out");
    chosen.push_back(std::move(one));
  }
};

struct RenderCommand {
  std::vector<std::string> names;
  std::vector<std::string> traces;  ///< files
  bool all = false;
  RenderOptions options;

  /// Errors: UsageError, and those of reading.
  std::vector<Chosen> chosen() const {
    Selection selection;
    for (const std::string& name : names) {
      progress("reading " + name);
      selection.add(name);
    }
    for (const std::string& file : traces) {
      progress("reading " + file);
      selection.add_trace(file);
    }
    if (all)
      for (const Walkthrough& w : whole_catalogue()) selection.add({&w});
    if (selection.chosen.empty())
      throw UsageError("render what? name walkthroughs, or say --all; 'gjkstep list' shows them");
    for (Chosen& each : selection.chosen)  // corners of a planar hull have letters of their own anyway
      if (Naming& naming = each.walkthrough.naming; options.letters && naming != Naming::corners)
        naming = *options.letters == "fixed" ? Naming::fixed : Naming::roles;
    return std::move(selection.chosen);
  }
};

// -- The words --------------------------------------------------------------------------------------------------------

/// `word`: a text, or an optional one.
void add_choice(CLI::App& command, const std::string& option, auto& word, const std::string& what,
                const std::vector<std::string>& words) {
  command.add_option(option, word, what)->check(CLI::IsMember(words));
}

/// A flag that may say more.
void add_flag_of(CLI::App& command, const std::string& option, std::string& word, const std::string& what) {
  const std::vector<std::string>& words = words_of_flags.at(option);
  command.add_flag(option + "{" + words.front() + "}", word, what)->check(CLI::IsMember(words));
}

void add_walkthroughs(CLI::App& command, RenderCommand& render) {
  command.add_option("NAME", render.names,
                     "walkthroughs to render, folders of them, or scene files (.json, or - for standard input)");
  command
      .add_option("--from-trace", render.traces,
                  "file that 'gjkstep trace' wrote: its frames are drawn without a search; may be repeated")
      ->type_name("FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--all", render.all, "render every walkthrough");
}

void add_formats(CLI::App& command, RenderOptions& render) {
  command.add_flag(
      "--strip", render.strip,
      "write OUT/NAME/strip.png as well: all iterations in one picture, side by side, more than twelve in rows");
  add_flag_of(command, "--sheet", render.sheet,
              "write OUT/NAME/sheet.png as well: all frames in one picture; --sheet=a4, letter, a4-across or "
              "letter-across: OUT/NAME/sheet.pdf, pages that can be read in print and searched");
  command.add_flag(
      "--deck", render.deck,
      "write OUT/NAME/deck.pdf as well, a slide for each frame, and OUT/NAME/notes.pdf, what to say to each");
  command.add_flag("--handout", render.handout,
                   "write OUT/NAME/handout.pdf as well: the whole search on one page of paper");
  command.add_flag(
      "--quiz", render.quiz,
      "write OUT/NAME/quiz.pdf as well: for each iteration a picture and questions about it, to print, and behind them the answers");
  add_choice(command, "--format", render.format,
             "svg: OUT/NAME/000.svg, 001.svg, ... as well, which stay sharp however much they are enlarged",
             {"png", "svg"});
  command.add_flag("--apng", render.apng, "write OUT/NAME/animation.png as well: all frames as an animated PNG");
  add_flag_of(command, "--page", render.page,
              "write OUT/NAME/index.html as well, to step through in a browser, and OUT/index.html over all; "
              "--page=single puts pictures, style, script and events into each");
  add_choice(command, "--movie", render.movie, "print the ffmpeg command that makes OUT/NAME/animation.mp4 or .gif",
             {"mp4", "gif"});
  expect_number(
      command.add_option("--frame-time", render.frame_time, "seconds for which animation and movie show a frame"), 0.02,
      60.0);
  expect_number(command.add_option("--hold", render.hold,
                                   "seconds for which they show the last one; if not given, twice as long"),
                0.02, 60.0);
}

void add_frames(CLI::App& command, RenderOptions& render) {
  add_choice(command, "--detail", render.detail, "a frame for each decision, or for each iteration",
             {"decision", "iteration"});
  command.add_option("--frames", render.frames,
                     "a choice of frames, numbered anew: steps such as 4,10,18 or 3-7, and kinds: " + frame_kinds());
  add_choice(command, "--theme", render.theme,
             "colours and weights: for a report, for slides with larger text, or on a dark ground",
             {"report", "slides", "dark"});
  expect_number(command.add_option("--turn", render.turns,
                                   "further views of each frame of a scene in space, from all around: 000-turn-1.png, "
                                   "..."),
                0, 72);
  command.add_flag("--no-captions", render.no_captions, "draw the panels only, for use in a document");
  add_choice(command, "--letters", render.letters,
             "'fixed': each vertex keeps its letter; 'roles': A is always the newest", {"roles", "fixed"});
  command.add_flag("--no-values", render.no_values, "leave the numbers that decide out of the panels, for questions");
}

void add_files(CLI::App& command, RenderOptions& render) {
  command.add_option("--captions", render.captions,
                     "JSON file to write: caption, description and events of each frame");
  command
      .add_option("--zip", render.zip, "file to write: the pictures and pages of this run packed into one, to hand out")
      ->type_name("FILE");
  command.add_flag("--rendered-by", render.rendered_by,
                   "write OUT/rendered-by.json as well: what drew the pictures; 'gjkstep compare' shows it");
  command.add_option("--out", render.out, "folder to write to");
  add_force_flag(command, render.force);
}

void add_sizes(CLI::App& command, RenderOptions& render) {
  command.add_option("--size", render.size,
                     "width and height in pixels; if not given, what the scene file says, or 1280x720");
  expect_number(command.add_option("--text-scale", render.text_scale,
                                   "all text so many times as large, and the pictures in what room is left. If not "
                                   "given: what the scene file says, else 1, for slides " +
                                       number_text(render::themes::slides.text)),
                render::least_text_scale, render::most_text_scale);
}

}  // namespace

Command add_render_command(CLI::App& app, std::optional<std::string>& gl) {
  const auto render = std::make_shared<RenderCommand>();
  CLI::App* const command = app.add_subcommand("render", "write the frames OUT/NAME/000.png, 001.png, ...");
  add_walkthroughs(*command, *render);
  command->option_defaults()->always_capture_default();  // which help shows
  for (const auto add : {add_formats, add_frames, add_files, add_sizes}) add(*command, render->options);
  add_backend_option(*command, gl);
  return {command, [render, &gl] {
            render->options.backend = chosen_backend(gl);
            expect_usable(render->options);
            render_all(render->options, render->chosen());
            return ok;
          }};
}

}  // namespace walkthroughs::program
