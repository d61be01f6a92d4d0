#include "walkthroughs/program/rendering.hpp"

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
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/handout.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/output/pages.hpp"
#include "walkthroughs/output/paper_sheet.hpp"
#include "walkthroughs/output/sheet.hpp"
#include "walkthroughs/output/zip_file.hpp"
#include "walkthroughs/program/exit_code.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::program {
namespace {

/// Reads "1280x720". Errors: UsageError.
render::Size parse_size(const std::string& text) {
  if (const auto size = size_in(text)) return *size;
  throw UsageError("--size " + in_quotes(text) + ": expected WIDTHxHEIGHT in pixels, for example 1280x720, each from " +
                   std::to_string(render::min_pixels) + " to " + std::to_string(render::max_pixels));
}

class Rendering {
 public:
  /// Errors: UsageError.
  Rendering(const RenderOptions& options, const std::vector<Chosen>& chosen, std::unique_ptr<Sink> last = {})
      : options_(options), output_(checked_output()), folder_(output_.folder), chosen_(chosen) {
    make_sinks();
    if (last) sinks_.push_back(std::move(last));
  }

  void run() {
    expect_chosen_frames();
    const Places places = all_places();
    places.expect_apart();
    places.expect_no_loss(others(), options_that_write());
    expect_writable();
    Studio studio{options_.backend};
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
    if (options_.rendered_by) write_rendered_by(studio);
    if (options_.captions) write(*options_.captions, captions_json(frames_), "captions and descriptions of the frames");
    if (options_.movie) print_movies();
    if (has_pages()) write_index(folder_, has_files_beside());
    if (options_.zip) {
      write_zip(*options_.zip, folder_, files_to_pack());
      std::cout << printable(*options_.zip) << "  all of this, packed\n";
    }
    places.tidy_manifests();
    if (has_pages() && !options_.is_quiet) std::cout << "open " << printable((folder_ / page_file).string()) << '\n';
  }

  void add_written(Places& places) const {
    for (const Chosen& each : chosen_) {
      const Walkthrough& w = each.walkthrough;
      places.write_into(folder_ / w.name, files_of(w), "the pictures of " + w.name);
      if (has_pages())
        places.write_into(folder_ / w.name / stage_folder, files_of(w), "what becomes the page of " + w.name);
      if (options_.movie) places.reserve(folder_ / w.name / ("animation." + *options_.movie), "the film of " + w.name);
    }
    if (options_.rendered_by) places.write(folder_ / render::rendered_by_file, "what --rendered-by notes");
    if (options_.captions) places.write(*options_.captions, "what --captions writes");
    if (options_.zip) places.write(*options_.zip, "what --zip writes");
    if (has_pages())
      for (const std::string& name : index_file_names(has_files_beside()))
        places.write(folder_ / name, "what all walkthroughs have in common");
  }

 private:
  /// With what the file of a scene asks for and the options do not.
  Output output_of(const Chosen& chosen) const {
    Output output = output_;
    if (!options_.size && chosen.size) output.size = *chosen.size;
    if (!options_.text_scale && chosen.text_scale) output.look.style = style_of(chosen.text_scale);
    return output;
  }

  Style style_of(std::optional<double> text_scale) const {
    render::Theme theme = theme_named(options_.theme);
    theme.text = text_scale.value_or(theme.text);
    return Style(theme);
  }

  std::string options_that_write() const {
    return std::string("--out") + (options_.captions ? " and --captions" : "") + (options_.zip ? " and --zip" : "");
  }
  Others others() const { return options_.force ? Others::overwritten : Others::kept; }
  bool has_svg() const { return options_.format == "svg"; }
  bool has_pages() const { return !options_.page.empty(); }
  bool has_files_beside() const { return options_.page != "single"; }

  /// One for each format that is asked for, in the order in which each story is given to them.
  void make_sinks() {
    sinks_.push_back(std::make_unique<Frames>(has_svg()));
    if (options_.apng)
      sinks_.push_back(std::make_unique<OneFile>(animated_png(options_.frame_time, options_.last_frame_time())));
    if (options_.strip) sinks_.push_back(std::make_unique<OneFile>(strip()));
    if (options_.sheet == "one") sinks_.push_back(std::make_unique<OneFile>(sheet()));
    if (const std::optional<render::PaperSize> paper = paper_named(options_.sheet))
      sinks_.push_back(std::make_unique<OneFile>(paper_sheets(*paper, !options_.text_scale, note_small_letters)));
    if (options_.deck)
      for (auto* const make : {deck, notes}) sinks_.push_back(std::make_unique<OneFile>(make()));
    if (options_.handout) sinks_.push_back(std::make_unique<OneFile>(handout()));
    if (options_.quiz)
      sinks_.push_back(std::make_unique<OneFile>(quiz([this](const auto&... what) { note_unasked(what...); })));
    if (!has_pages()) return;
    std::vector<PageOrigin> origins;
    for (const Chosen& each : chosen_)
      origins.push_back(
          {each.walkthrough.name, each.walkthrough.title, each.option, each.file, each.scene, each.made_by});
    sinks_.push_back(std::make_unique<Pages>(PagesWanted{has_files_beside(), options_.out, options_of_pictures(),
                                                         is_usual(), options_.report, std::move(origins)}));
  }

  Output checked_output() const {
    expect_named("--out", options_.out, "a folder to write to, for example --out pictures");
    if (options_.captions)
      expect_named("--captions", *options_.captions, "a file to write, for example --captions captions.json");
    if (options_.zip) expect_named("--zip", *options_.zip, "a file to write, for example --zip pages.zip");
    const Look look{.style = style_of(options_.text_scale),
                    .text = options_.no_captions ? Text::none : Text::around,
                    .values = !options_.no_values};
    return {.folder = options_.out,
            .size = parse_size(options_.size.value_or("1280x720")),
            .look = look,
            .turns = options_.turns,
            .is_staged = has_pages()};
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
    std::erase_if(files,
                  [&](const auto& file) { return std::filesystem::equivalent(file, *options_.zip, not_there_yet); });
    return {files.begin(), files.end()};
  }

  Places all_places() const {
    Places places;
    for (const Chosen& each : chosen_)
      if (!each.file.empty())
        places.read(each.file, (each.option.empty() ? "the scene file " : "the trace ") + each.file.string());
    add_written(places);
    places.write_standard_output();
    return places;
  }

  /// What is written last, before all that is drawn. Captions may be meant to lie beside pictures.
  void expect_writable() const {
    constexpr const char* elsewhere = "choose another with --out";
    if (options_.captions) {
      for (const Chosen& each : chosen_) render::make_folder(folder_ / each.walkthrough.name, elsewhere);
      render::expect_writable(*options_.captions);
    }
    if (options_.zip) render::expect_writable(*options_.zip);
    if (!has_pages()) return;
    render::make_folder(folder_, elsewhere);
    for (const std::string& name : index_file_names(has_files_beside())) render::expect_writable(folder_ / name);
  }

  /// What else is said about the pictures that pages show.
  std::string options_of_pictures() const {
    const RenderOptions usual;
    std::string options;
    const auto add = [&options](bool is_said, const std::string& option, const std::string& value) {
      if (is_said) options += " --" + option + " " + shell_word(value);
    };
    add(options_.detail != usual.detail, "detail", options_.detail);
    add(options_.frames.has_value(), "frames", options_.frames.value_or(""));
    add(options_.letters.has_value(), "letters", options_.letters.value_or(""));
    add(options_.theme != usual.theme, "theme", options_.theme);
    add(options_.size.has_value(), "size", options_.size.value_or(""));
    add(options_.text_scale.has_value(), "text-scale", number_text(options_.text_scale.value_or(1)));
    add(options_.turns != usual.turns, "turn", std::to_string(options_.turns));
    return options + (options_.no_captions ? " --no-captions" : "") + (options_.no_values ? " --no-values" : "");
  }

  /// Whether nothing was said that the program in a page would tell otherwise.
  bool is_usual() const {
    return options_.detail == RenderOptions().detail && !options_.frames && !options_.letters && !options_.no_values;
  }

  Story tell_all(const Chosen& chosen) const {
    if (chosen.told) return *chosen.told;
    const Detail shown = options_.detail == "iteration" ? Detail::iteration : Detail::decision;
    return chosen.traces ? tell(chosen.walkthrough, *chosen.traces, shown) : tell(chosen.walkthrough, shown);
  }

  void expect_chosen_frames() const {
    if (!options_.frames) return;
    const std::optional<FrameChoice> choice = frames_in(*options_.frames);
    const std::string option = "--frames " + in_quotes(*options_.frames) + ": ";
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
    if (options_.frames) keep_only(told, places_of(frames_in(*options_.frames).value(), told.frames));
    progress(w.name + ": looking for hulls and cameras");
    const auto story = std::make_shared<const StagedStory>(std::move(told));
    progress(w.name + ": drawing");
    if (!options_.is_quiet) note_all(*story);
    if (options_.captions) stories_.push_back(story);
    const Output output = output_of(chosen);
    for (const std::unique_ptr<Sink>& sink : sinks_) sink->add(story, output, renderer);
    if (output.is_staged)  // a page and its pictures are replaced at once
      renderer.then([folder = folder_ / w.name, files = files_of(w), others = others()] {
        publish(folder, files, page_file, others);
      });
  }

  void note_all(const StagedStory& story) const {
    for (const std::string& sentence : story.left_out()) note(story.walkthrough.name + ": " + sentence);
    note_truth(story);
    note_what_stays(story.walkthrough);
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
    const bool is_on_paper = paper_named(options_.sheet).has_value();
    for (const Kind& kind :
         {Kind{page_file, "--page", has_pages()}, Kind{"strip.png", "--strip", options_.strip},
          Kind{"animation.png", "--apng", options_.apng}, Kind{"sheet.png", "--sheet", options_.sheet == "one"},
          Kind{"sheet.pdf", "--sheet=a4", is_on_paper}, Kind{"deck.pdf", "--deck", options_.deck},
          Kind{"handout.pdf", "--handout", options_.handout}, Kind{"quiz.pdf", "--quiz", options_.quiz},
          Kind{"000.svg", "--format svg", has_svg()}}) {
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
      if (!options_.is_quiet) std::cout << name << "  " << story.walkthrough.title << std::endl;
      return;
    }
    if (options_.captions && file.extension() == ".png") frames_.push_back({file.string(), story, *frame});
    const std::size_t count = story.frames.size();
    progress("");
    if (!options_.is_quiet) std::cout << name << "  " << plain(story.frames[*frame].caption) << std::endl;
    if (*frame + 1 < count)
      progress(story.walkthrough.name + ": frame " + std::to_string(*frame + 1) + " of " + std::to_string(count));
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

  void note_unasked(const Story& story, std::size_t asked, std::size_t known) const {
    const std::string about = story.walkthrough.name + ": ", none = "there is no quiz.pdf",
                      missing = "the frames before " + std::to_string(known - asked) + " of its " +
                                std::to_string(known) + " answers are left out, and the questions with them";
    if (known == 0) return note(about + "it asks nothing, so " + none);
    if (asked == 0) return note(about + missing + ", so " + none);
    if (options_.frames || options_.detail == "iteration") note(about + missing);  // else the walkthrough begins later
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
    const Movie kind = *options_.movie == "gif" ? Movie::gif : Movie::mp4;
    for (const Chosen& each : chosen_)
      std::cout << ffmpeg_line(kind, folder_ / each.walkthrough.name, options_.frame_time, options_.last_frame_time(),
                               output_.look.style.theme.paper)
                << '\n';
  }

  const RenderOptions& options_;
  const Output output_;
  const std::filesystem::path& folder_;
  const std::vector<Chosen>& chosen_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  bool has_waited_ = false;  // for another run
  // What the file of captions is about; empty where none is asked for, so that stories go when their frames are drawn.
  std::vector<FrameFile> frames_;
  std::vector<std::shared_ptr<const Story>> stories_;
};

}  // namespace

void progress(const std::string& what) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  if (terminal) std::cerr << "\r\033[K" + message_line(what) << std::flush;
}

void expect_usable(const RenderOptions& options) { Rendering(options, {}); }

void add_written(Places& places, const RenderOptions& options, const std::vector<Chosen>& chosen) {
  Rendering(options, chosen).add_written(places);
}

void render_all(const RenderOptions& options, const std::vector<Chosen>& chosen, std::unique_ptr<Sink> last) {
  Rendering(options, chosen, std::move(last)).run();
}

}  // namespace walkthroughs::program
