// gjkstep render: which walkthroughs, how large, in which colours, and where to.

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/file.hpp"
#include "render/rendered_by.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/output/pages.hpp"
#include "walkthroughs/output/paper_sheet.hpp"
#include "walkthroughs/output/sheet.hpp"
#include "walkthroughs/output/zip_file.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/trace/trace_file.hpp"

namespace walkthroughs::program {
namespace {

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
  std::optional<double> hold;  ///< of the last frame

  double last_frame_time() const { return hold.value_or(2 * frame_time); }
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
};

/// All of them, each once, in the order named.
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

/// Reads "1280x720". Errors: UsageError.
render::Size parse_size(const std::string& text) {
  if (const auto size = size_in(text)) return *size;
  throw UsageError("--size " + in_quotes(text) + ": expected WIDTHxHEIGHT in pixels, for example 1280x720, each from " +
                   std::to_string(render::min_pixels) + " to " + std::to_string(render::max_pixels));
}

/// One run of the command.
class Rendering {
 public:
  /// Errors: UsageError, and those of reading.
  explicit Rendering(const RenderCommand& command)
      : command_(command), output_(checked_output()), folder_(output_.folder), chosen_(select()) {}

  /// Writes the files and tells of each on standard output. Everything that can be wrong with the words of the command is
  /// found before the first file is written.
  /// Errors: UsageError, and those of whatever it calls.
  void run() {
    expect_chosen_frames();
    make_sinks();
    const Places places = all_places();
    places.expect_apart();
    places.expect_no_loss(others(), options_that_write());
    expect_writable();
    Studio studio{chosen_backend(command_.gl)};
    try {
      // Given up before other files are written, which may lie in folders that others claim.
      const std::vector<std::unique_ptr<FolderClaim>> claims = claim_folders();
      if (has_waited_) places.expect_no_loss(others(), "--out");
      // It writes what it was given even when it goes early: before what it is given.
      Renderer renderer(studio, [this](const auto&... what) { report(what...); });
      for (const Chosen& each : chosen_) render(each, renderer);
      renderer.finish();
    } catch (...) {
      for (const Chosen& each : chosen_) discard_stage(folder_ / each.walkthrough.name);
      throw;
    }
    if (!studio.font.missing().empty()) note(missing_letters(studio.font.missing()));
    if (command_.rendered_by) write_rendered_by(studio);
    if (command_.captions) write(*command_.captions, captions_json(frames_), "captions and descriptions of the frames");
    if (command_.movie) print_movies();
    if (has_pages()) write_index(folder_, has_files_beside());
    if (command_.zip) {
      write_zip(*command_.zip, folder_, files_to_pack());
      std::cout << printable(*command_.zip) << "  all of this, packed\n";
    }
    places.tidy_manifests();
    if (has_pages()) std::cout << "open " << printable((folder_ / page_file).string()) << '\n';
  }

 private:
  /// With what the file of a scene asks for and the command does not.
  Output output_of(const Chosen& chosen) const {
    Output output = output_;
    if (!command_.size && chosen.size) output.size = *chosen.size;
    if (!command_.text_scale && chosen.text_scale) output.look.style = style_of(chosen.text_scale);
    return output;
  }

  Style style_of(std::optional<double> text_scale) const {
    render::Theme theme = theme_named(command_.theme);
    theme.text = text_scale.value_or(theme.text);
    return Style(theme);
  }

  std::string options_that_write() const {
    return std::string("--out") + (command_.captions ? " and --captions" : "") + (command_.zip ? " and --zip" : "");
  }
  Others others() const { return command_.force ? Others::overwritten : Others::kept; }
  bool has_svg() const { return command_.format == "svg"; }
  bool has_pages() const { return !command_.page.empty(); }
  bool has_files_beside() const { return command_.page != "single"; }

  /// One for each format that is asked for, in the order in which each story is given to them.
  void make_sinks() {
    sinks_.push_back(std::make_unique<Frames>(has_svg()));
    if (command_.apng)
      sinks_.push_back(std::make_unique<OneFile>(animated_png(command_.frame_time, command_.last_frame_time())));
    if (command_.strip) sinks_.push_back(std::make_unique<OneFile>(strip()));
    if (command_.sheet == "one") sinks_.push_back(std::make_unique<OneFile>(sheet()));
    if (const std::optional<render::PaperSize> paper = paper_named(command_.sheet))
      sinks_.push_back(std::make_unique<OneFile>(paper_sheets(*paper, !command_.text_scale, note_small_letters)));
    if (!has_pages()) return;
    std::vector<PageOrigin> origins;
    for (const Chosen& each : chosen_)
      origins.push_back({each.walkthrough.name, each.walkthrough.title, each.option, each.file, each.scene});
    sinks_.push_back(std::make_unique<Pages>(
        PagesWanted{has_files_beside(), command_.out, options_of_pictures(), is_usual(), std::move(origins)}));
  }

  Output checked_output() const {
    expect_named("--out", command_.out, "a folder to write to, for example --out pictures");
    if (command_.captions)
      expect_named("--captions", *command_.captions, "a file to write, for example --captions captions.json");
    if (command_.zip) expect_named("--zip", *command_.zip, "a file to write, for example --zip pages.zip");
    const Look look{.style = style_of(command_.text_scale),
                    .text = command_.no_captions ? Text::none : Text::around,
                    .values = !command_.no_values};
    return {.folder = command_.out,
            .size = parse_size(command_.size.value_or("1280x720")),
            .look = look,
            .turns = command_.turns,
            .is_staged = has_pages()};
  }

  std::vector<Chosen> select() const {
    Selection selection;
    for (const std::string& name : command_.names) {
      progress("reading " + name);
      selection.add(name);
    }
    for (const std::string& file : command_.traces) {
      progress("reading " + file);
      selection.add_trace(file);
    }
    if (command_.all)
      for (const Walkthrough& w : whole_catalogue()) selection.add({&w});
    if (selection.chosen.empty())
      throw UsageError("render what? name walkthroughs, or say --all; 'gjkstep list' shows them");
    for (Chosen& each : selection.chosen)  // corners of a planar hull have letters of their own anyway
      if (Naming& naming = each.walkthrough.naming; command_.letters && naming != Naming::corners)
        naming = *command_.letters == "fixed" ? Naming::fixed : Naming::roles;
    return std::move(selection.chosen);
  }

  /// One after the other, in the order of their names, so that two runs do not wait for each other.
  std::vector<std::unique_ptr<FolderClaim>> claim_folders() {
    std::set<std::string> folders;
    for (const Chosen& each : chosen_) folders.insert(each.walkthrough.name);
    std::vector<std::unique_ptr<FolderClaim>> claims;
    for (const std::string& name : folders) {
      render::make_folder(folder_ / name, "choose another with --out");
      claims.push_back(std::make_unique<FolderClaim>(folder_ / name, [&] {
        note("another run writes to " + printable((folder_ / name).string()) + "; waiting for it");
        has_waited_ = true;
      }));
      discard_stage(folder_ / name);  // of a run that was killed
    }
    return claims;
  }

  /// Returns: the names of all that is written of a walkthrough, as patterns.
  std::vector<std::string> files_of(const Walkthrough& w) const {
    std::vector<std::string> files;
    for (const std::unique_ptr<Sink>& sink : sinks_)
      for (const std::string& file : sink->files(w)) files.push_back(file);
    return files;
  }

  /// Returns: what this run has written below its folder, and all that the index leads to, in the order of their names.
  std::vector<std::filesystem::path> files_to_pack() const {
    std::set<std::string> folders;
    for (const Chosen& each : chosen_) folders.insert(each.walkthrough.name);
    std::set<std::filesystem::path> files;
    if (has_pages()) {
      for (const std::string& name : names_in_index(folder_)) folders.insert(name);
      for (const std::filesystem::path& file : our_files(folder_)) files.insert(file);
    }
    for (const std::string& name : folders)
      for (const std::filesystem::path& file : our_files(folder_ / name)) files.insert(file);
    std::error_code not_there_yet;
    std::erase_if(files, [&](const auto& file) { return std::filesystem::equivalent(file, *command_.zip, not_there_yet); });
    return {files.begin(), files.end()};
  }

  Places all_places() const {
    Places places;
    for (const std::string& name : command_.names)
      if (is_scene_file(name)) places.read(name, "the scene file " + name);
    for (const std::string& file : command_.traces) places.read(file, "the trace " + file);
    for (const Chosen& each : chosen_) {
      const Walkthrough& w = each.walkthrough;
      places.write_into(folder_ / w.name, files_of(w), "the pictures of " + w.name);
      if (has_pages())
        places.write_into(folder_ / w.name / stage_folder, files_of(w), "what becomes the page of " + w.name);
      if (command_.movie) places.reserve(folder_ / w.name / ("animation." + *command_.movie), "the film of " + w.name);
    }
    if (command_.rendered_by) places.write(folder_ / render::rendered_by_file, "what --rendered-by notes");
    if (command_.captions) places.write(*command_.captions, "what --captions writes");
    if (command_.zip) places.write(*command_.zip, "what --zip writes");
    if (has_pages())
      for (const std::string& name : index_file_names(has_files_beside()))
        places.write(folder_ / name, "what all walkthroughs have in common");
    places.write_standard_output();
    return places;
  }

  /// What is written last, before all that is drawn. Captions may be meant to lie beside pictures.
  void expect_writable() const {
    constexpr const char* elsewhere = "choose another with --out";
    if (command_.captions) {
      for (const Chosen& each : chosen_) render::make_folder(folder_ / each.walkthrough.name, elsewhere);
      render::expect_writable(*command_.captions);
    }
    if (command_.zip) render::expect_writable(*command_.zip);
    if (!has_pages()) return;
    render::make_folder(folder_, elsewhere);
    for (const std::string& name : index_file_names(has_files_beside())) render::expect_writable(folder_ / name);
  }

  /// What else the command says about the pictures that pages show.
  std::string options_of_pictures() const {
    const RenderCommand usual;
    std::string options;
    const auto add = [&options](bool is_said, const std::string& option, const std::string& value) {
      if (is_said) options += " --" + option + " " + shell_word(value);
    };
    add(command_.detail != usual.detail, "detail", command_.detail);
    add(command_.frames.has_value(), "frames", command_.frames.value_or(""));
    add(command_.letters.has_value(), "letters", command_.letters.value_or(""));
    add(command_.theme != usual.theme, "theme", command_.theme);
    add(command_.size.has_value(), "size", command_.size.value_or(""));
    add(command_.text_scale.has_value(), "text-scale", number_text(command_.text_scale.value_or(1)));
    add(command_.turns != usual.turns, "turn", std::to_string(command_.turns));
    return options + (command_.no_captions ? " --no-captions" : "") + (command_.no_values ? " --no-values" : "");
  }

  /// Whether nothing was said that the program in a page would tell otherwise.
  bool is_usual() const {
    return command_.detail == RenderCommand().detail && !command_.frames && !command_.letters && !command_.no_values;
  }

  Story tell_all(const Chosen& chosen) const {
    const Detail shown = command_.detail == "iteration" ? Detail::iteration : Detail::decision;
    return chosen.traces ? tell(chosen.walkthrough, *chosen.traces, shown) : tell(chosen.walkthrough, shown);
  }

  void expect_chosen_frames() const {
    if (!command_.frames) return;
    const std::optional<FrameChoice> choice = frames_in(*command_.frames);
    const std::string option = "--frames " + in_quotes(*command_.frames) + ": ";
    if (!choice)
      throw UsageError(option +
                       "expected numbers of steps such as 4,10,18 or 3-7, and kinds of them: " + frame_kinds());
    for (const Chosen& each : chosen_)
      if (const std::string no = objection_to(*choice, tell_all(each).frames); !no.empty())
        throw UsageError(option + each.walkthrough.name + " " + no);
  }

  void render(const Chosen& chosen, Renderer& renderer) {
    const Walkthrough& w = chosen.walkthrough;
    progress(w.name + ": searching");
    Story told = tell_all(chosen);
    if (command_.frames) keep_only(told, places_of(frames_in(*command_.frames).value(), told.frames));
    progress(w.name + ": looking for hulls and cameras");
    const auto story = std::make_shared<const StagedStory>(std::move(told));
    progress(w.name + ": drawing");
    for (const std::string& sentence : story->left_out()) note(w.name + ": " + sentence);
    note_truth(*story);
    note_what_stays(w);
    if (command_.captions) stories_.push_back(story);
    const Output output = output_of(chosen);
    for (const std::unique_ptr<Sink>& sink : sinks_) sink->add(story, output, renderer);
    if (output.is_staged)  // a page and its pictures are replaced at once
      renderer.then([folder = folder_ / w.name, files = files_of(w), others = others()] {
        publish(folder, files, page_file, others);
      });
  }

  /// Where a search answers otherwise than the truth, be its last frame among those drawn or not.
  static void note_truth(const Story& story) {
    for (const Telling& telling : story.tellings)
      if (const TruthTold told = truth_told(telling.truth, telling.scene, answer_of(telling.trace));
          !told.note.empty() && !telling.scene.mistake)
        note(story.walkthrough.name + ": " + told.note);
  }

  /// What an earlier run has left beside the frames, and this one does not make.
  void note_what_stays(const Walkthrough& w) const {
    struct Kind {
      const char *file, *option;
      bool is_made;
    };
    const bool is_on_paper = paper_named(command_.sheet).has_value();
    for (const Kind& kind :
         {Kind{page_file, "--page", has_pages()}, Kind{"strip.png", "--strip", command_.strip},
          Kind{"animation.png", "--apng", command_.apng}, Kind{"sheet.png", "--sheet", command_.sheet == "one"},
          Kind{"sheet.pdf", "--sheet=a4", is_on_paper}, Kind{"000.svg", "--format svg", has_svg()}}) {
      std::error_code unreadable;
      if (!kind.is_made && std::filesystem::exists(folder_ / w.name / kind.file, unreadable))
        note(w.name + ": " + kind.file + " is of an earlier run, and may tell of other pictures; " + kind.option +
             " writes it anew");
    }
  }

  /// One line for each file, and how far it is.
  void report(const std::filesystem::path& written, const Story& story, std::optional<std::size_t> frame) {
    const bool is_staged = written.parent_path().filename() == stage_folder;
    const std::filesystem::path file = is_staged ? written.parent_path().parent_path() / written.filename() : written;
    const std::string name = printable(file.string());
    if (!frame) {
      std::cout << name << "  " << story.walkthrough.title << std::endl;
      return;
    }
    if (command_.captions && file.extension() == ".png") frames_.push_back({file.string(), story, *frame});
    const std::size_t count = story.frames.size();
    progress("");
    std::cout << name << "  " << plain(story.frames[*frame].caption) << std::endl;
    if (*frame + 1 < count)
      progress(story.walkthrough.name + ": frame " + std::to_string(*frame + 1) + " of " + std::to_string(count));
  }

  /// On a terminal, what is being done: in place of what was being done before, nothing where `what` is empty.
  static void progress(const std::string& what) {
    static const bool terminal = isatty(STDERR_FILENO) != 0;
    if (terminal) std::cerr << "\r\033[K" + message_line(what) << std::flush;
  }

  /// What the pictures do not tell, once for all of them.
  static void note(const std::string& sentence) {
    progress("");
    std::cerr << "gjkstep: " + sentence + "\n";
  }

  static void note_small_letters(const Story& story, double points) {
    char size[32];
    std::snprintf(size, sizeof size, "%.1f", points);
    note(story.walkthrough.name + ": the smallest letters of its sheets have " + size +
         " points; choose paper held across, or --no-captions");
  }

  static void write(const std::filesystem::path& file, const std::string& text, const std::string& what) {
    write_output(file, text);
    std::cout << printable(file.string()) << "  " << what << '\n';
  }

  void write_rendered_by(const Studio& studio) const {
    render::RenderedBy notes = render::rendered_by(studio.context, studio.font_folder);
    notes.insert(notes.begin(), {"gjkstep", GJKSTEP_VERSION});
    write(folder_ / render::rendered_by_file, render::rendered_by_json(notes), "what drew these pictures");
  }

  void print_movies() const {
    const Movie kind = *command_.movie == "gif" ? Movie::gif : Movie::mp4;
    for (const Chosen& each : chosen_)
      std::cout << ffmpeg_line(kind, folder_ / each.walkthrough.name, command_.frame_time, command_.last_frame_time(),
                               output_.look.style.theme.paper)
                << '\n';
  }

  const RenderCommand& command_;
  const Output output_;
  const std::filesystem::path& folder_;
  const std::vector<Chosen> chosen_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  bool has_waited_ = false;  // for another run
  // What the file of captions is about; empty where none is asked for, so that stories go when their frames are drawn.
  std::vector<FrameFile> frames_;
  std::vector<std::shared_ptr<const Story>> stories_;
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

void add_formats(CLI::App& command, RenderCommand& render) {
  command.add_flag(
      "--strip", render.strip,
      "write OUT/NAME/strip.png as well: all iterations in one picture, side by side, more than twelve in rows");
  add_flag_of(command, "--sheet", render.sheet,
              "write OUT/NAME/sheet.png as well: all frames in one picture; --sheet=a4, letter, a4-across or "
              "letter-across: OUT/NAME/sheet.pdf, pages that can be read in print and searched");
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

void add_frames(CLI::App& command, RenderCommand& render) {
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

void add_files(CLI::App& command, RenderCommand& render) {
  command.add_option("--captions", render.captions,
                     "JSON file to write: caption, description and events of each frame");
  command.add_option("--zip", render.zip,
                     "file to write: the pictures and pages of this run packed into one, to hand out")
      ->type_name("FILE");
  command.add_flag("--rendered-by", render.rendered_by,
                   "write OUT/rendered-by.json as well: what drew the pictures; 'gjkstep compare' shows it");
  command.add_option("--out", render.out, "folder to write to");
  add_force_flag(command, render.force);
}

void add_sizes(CLI::App& command, RenderCommand& render) {
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
  for (const auto add : {add_formats, add_frames, add_files, add_sizes}) add(*command, *render);
  add_backend_option(*command, gl);
  return {command, [render, &gl] {
            render->gl = gl;
            Rendering(*render).run();
            return ok;
          }};
}

}  // namespace walkthroughs::program
