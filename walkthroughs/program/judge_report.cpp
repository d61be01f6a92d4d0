#include "walkthroughs/program/judge_report.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "render/file.hpp"
#include "walkthroughs/judge/report_page.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/output/pages.hpp"
#include "walkthroughs/program/rendering.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace walkthroughs::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* report_file = "report.html";
constexpr const char* scene_files = "#.json";

using Pictures = std::map<std::string, judge::ShownPicture>;

/// Writes nothing: notes which picture of each story the report shows.
class Deciding : public Sink {
 public:
  explicit Deciding(Pictures& pictures) : pictures_(pictures) {}
  std::vector<std::string> files(const Walkthrough&) const override { return {}; }
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer&) override {
    const Walkthrough& w = story->walkthrough;
    const std::size_t index = story->parting().value_or(story->frames.size() - 1);
    const PagePictures layout{.url = {}, .page = page_of_frame(output.look), .part = pictures_of_frame(w, output.look)};
    pictures_[w.name] = {w.name + "/" + picture_name(index), w.name + "/" + page_file + "#" + std::to_string(index + 1),
                         alternative_text(*story, index), plain(story->frames[index].caption),
                         index_entry(*story, layout)["cut"]};
  }

 private:
  Pictures& pictures_;
};

RenderOptions options_of(const ReportFolder& to) {
  RenderOptions options;
  options.page = "beside";
  options.out = to.folder;
  options.backend = to.backend;
  options.force = to.force;
  options.is_quiet = true;
  options.report = report_file;
  return options;
}

/// Returns: the names of all walkthroughs that a report may show.
std::vector<std::string> possible_names() {
  std::vector<std::string> names{parting_name};
  for (std::size_t i = 1; i <= kept_worst + 2 * judge::most_failed; ++i) names.push_back(std::to_string(i));
  return names;
}

/// Of the scenes that stand in the folder.
std::vector<Chosen> chosen_for(const judge::Report& report, const Story* first_wrong_step) {
  std::vector<Chosen> chosen;
  if (first_wrong_step)
    chosen.push_back({.walkthrough = first_wrong_step->walkthrough,
                      .told = first_wrong_step,
                      .made_by = judge::told(report).command});
  for (const judge::SavedScene& each : judge::scenes_of_worst(report.judgement)) {
    const fs::path file = fs::path(report.shown) / each.name;
    chosen.push_back(
        {.walkthrough = parse_scene(each.text, file.string()).walkthrough, .file = file, .scene = each.text});
  }
  return chosen;
}

}  // namespace

void write_scenes(const std::string& folder, const judge::Judgement& judgement) {
  std::set<std::string> written;
  for (const judge::SavedScene& each : judge::scenes_of_worst(judgement)) {
    write_output(fs::path(folder) / each.name, each.text);
    written.insert(each.name);
  }
  remove_outputs(folder, {scene_files}, written);
}

void ReportFolder::add_written(Places& places) const {
  expect_named("--report", folder, "a folder to write to, for example --report wrong");
  std::vector<Chosen> possible;
  for (const std::string& name : possible_names()) {
    possible.emplace_back().walkthrough.name = name;
    if (name != parting_name) possible.back().file = fs::path(folder) / (name + ".json");
  }
  program::add_written(places, options_of(*this), possible);
  places.write_into(folder, {scene_files}, "the scenes of --report");
  places.write(fs::path(folder) / report_file, "the page of --report");
}

void ReportFolder::expect_possible() const {
  const Studio can_draw{backend};  // which leaves nothing behind where it cannot
  constexpr const char* elsewhere = "choose another with --report";
  render::make_folder(folder, elsewhere);
  std::vector<std::string> files = index_file_names(true);
  files.push_back(report_file);
  for (const std::string& name : files) render::expect_writable(fs::path(folder) / name);
  for (const std::string& name : possible_names())
    if (std::error_code unknown; fs::exists(fs::path(folder) / name, unknown))
      render::make_folder(fs::path(folder) / name, elsewhere);
}

fs::path ReportFolder::write(const judge::Report& report) const {
  remove_outputs(folder, {report_file});  // which tells of what is replaced now
  write_scenes(folder, report.judgement);
  const std::optional<Parting> parting = judge::parting_of(report.steps);
  const std::optional<Story> step = parting ? std::optional(parting->story()) : std::nullopt;
  const std::vector<Chosen> chosen = chosen_for(report, step ? &*step : nullptr);
  for (const std::string& name : possible_names())
    if (std::ranges::none_of(chosen, [&](const Chosen& each) { return each.walkthrough.name == name; }))
      discard(fs::path(folder) / name);
  Pictures pictures;
  if (chosen.empty())
    remove_outputs(folder, index_file_names(true));
  else
    render_all(options_of(*this), chosen, std::make_unique<Deciding>(pictures));
  write_output(fs::path(folder) / report_file, judge::report_page(report, pictures));
  return fs::path(folder) / report_file;
}

}  // namespace walkthroughs::program
