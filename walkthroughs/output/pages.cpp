#include "walkthroughs/output/pages.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <system_error>
#include <tuple>

#include "render/file.hpp"
#include "render/html.hpp"
#include "walkthroughs/catalogue/lesson.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::output {
namespace {

namespace fs = std::filesystem;

using Origin = std::vector<PageOrigin>::const_iterator;

Origin origin_of(const Walkthrough& walkthrough, const PagesWanted& wanted) {
  return std::ranges::find(wanted.origins, walkthrough.name, &PageOrigin::name);
}

std::string copy_of_scene(const PageOrigin& origin) { return origin.name + ".json"; }

/// Returns: what a page was made of.
std::vector<PageFile> sources(const Story& story, const PageOrigin& origin) {
  std::vector<PageFile> files;
  std::vector<Trace> traces;
  std::vector<Truth> truths;
  for (const Telling& telling : story.tellings) {
    traces.push_back(telling.trace);
    truths.push_back(telling.truth);
  }
  if (!traces.empty()) files.push_back({trace_file, traces_json(story.walkthrough, traces, truths)});
  if (!origin.scene.empty()) files.push_back({copy_of_scene(origin), origin.scene});
  return files;
}

/// Returns: nothing where there is no such file.
std::string beginning_of(const fs::path& file) try {
  const std::vector<std::uint8_t> bytes = render::read_beginning(file, std::size_t{1} << 20);
  return {bytes.begin(), bytes.end()};
} catch (const render::ReadError&) {
  return "";
}

/// Returns: what the page in `folder`/`name` says of itself; nothing where there is none, or none that belongs there.
std::optional<PageJson> entry_at(const fs::path& folder, const std::string& name) {
  std::optional<PageJson> entry = entry_in(beginning_of(folder / name / story_file));
  if (!entry) entry = entry_in(beginning_of(folder / name / page_file));
  if (!entry || (*entry)["name"] != name) return std::nullopt;
  const std::string picture = name + "/" + picture_name((*entry)["picture"]);
  (*entry)["picture_url"] = picture;
  std::error_code unreadable;
  const bool is_whole = fs::exists(folder / name / page_file, unreadable) && fs::exists(folder / picture, unreadable);
  return is_whole ? entry : std::nullopt;
}

/// Returns: what to sort names by: "10" comes after "2".
std::string with_whole_number(const std::string& name) {
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  return std::string(digits > 0 && digits < 20 ? 20 - digits : 0, '0') + name;
}

/// Returns: those of all pages in the folder, in the order of the catalogue, scenes of one's own last.
std::vector<PageJson> entries_in(const fs::path& folder) {
  std::map<std::tuple<std::ptrdiff_t, std::string, std::string>, PageJson> entries;
  std::error_code unreadable, no_status;
  for (auto at = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, unreadable);
       !unreadable && at != fs::recursive_directory_iterator(); at.increment(unreadable)) {
    if (at.depth() == 1) at.disable_recursion_pending();
    if (!at->is_directory(no_status)) continue;
    const std::string name = at->path().lexically_relative(folder).generic_string();
    const auto place = std::ranges::find(whole_catalogue(), name, &Walkthrough::name) - whole_catalogue().begin();
    if (std::optional<PageJson> entry = entry_at(folder, name))
      entries.emplace(std::tuple(place, with_whole_number(name), name), *entry);
  }
  const auto values = std::views::values(entries);
  return {values.begin(), values.end()};
}

/// What the program in the page is asked to tell; null where it would tell something else, or is not there.
PageJson request_for(const PageOrigin& origin, const PagesWanted& wanted) {
  if (page_programs().empty() || !wanted.is_usual || !origin.option.empty() || !origin.made_by.empty()) return nullptr;
  if (origin.name == lesson_name) return {{"name", screens()[0].walkthrough}, {"screen", 0}};
  if (origin.file.empty()) return {{"name", origin.name}};
  return {{"scene", origin.scene}, {"file", called(origin.file)}};
}

PageSurroundings surroundings_of(const Walkthrough& walkthrough, const PagesWanted& wanted) {
  const Origin here = origin_of(walkthrough, wanted);
  const std::string what = here->option + shell_word(here->file.empty() ? fs::path(here->name) : here->file);
  PageSurroundings all;
  all.has_files_beside = wanted.has_files_beside;
  const std::string render = "gjkstep render " + what + (all.has_files_beside ? " --page" : " --page=single");
  all.command = here->made_by.empty() ? render + wanted.options : here->made_by;
  const bool has_trace = !walkthrough.scenes.empty() && here->option.empty();
  if (has_trace && all.has_files_beside) all.sources.push_back({trace_file, trace_file});
  if (has_trace && here->made_by.empty()) all.sources.push_back({"", "gjkstep trace " + what});
  all.live = request_for(*here, wanted);
  if (!all.has_files_beside) return all;
  if (!here->file.empty())
    all.sources.push_back({here->option.empty() ? copy_of_scene(*here) : trace_file, here->file.filename()});
  const auto way_to = [from = walkthrough.name](const std::string& name, const std::string& file = page_file) {
    return (fs::path(name) / file).lexically_relative(from).generic_string();
  };
  if (!all.live.is_null())
    for (const PageFile& program : page_programs())
      all.programs.push_back(fs::path(program.name).lexically_relative(walkthrough.name).generic_string());
  all.page_of = [=](const std::string& name) {
    std::error_code unreadable;
    const bool is_there = std::ranges::count(wanted.origins, name, &PageOrigin::name) ||
                          fs::exists(wanted.folder / name / page_file, unreadable);
    return is_there ? way_to(name) : "";
  };
  if (!wanted.report.empty()) all.ways.push_back({way_to("", wanted.report), "The report"});
  all.ways.push_back({way_to(""), "All walkthroughs"});
  if (here != wanted.origins.begin()) all.ways.push_back({way_to((here - 1)->name), "← " + (here - 1)->title});
  if (here + 1 != wanted.origins.end()) all.ways.push_back({way_to((here + 1)->name), "→ " + (here + 1)->title});
  return all;
}

}  // namespace

/// Links lead from page to page as the index goes.
Pages::Pages(PagesWanted wanted) : wanted_(std::move(wanted)) {
  std::ranges::stable_sort(wanted_.origins, {}, [](const PageOrigin& origin) { return group_place(origin.name); });
}

std::vector<std::string> Pages::files(const Walkthrough& walkthrough) const {
  const PageOrigin& origin = *origin_of(walkthrough, wanted_);
  std::vector<std::string> names = page_file_names();
  names.push_back(trace_file);
  if (!origin.file.empty()) names.push_back(copy_of_scene(origin));
  std::error_code is_not_there;  // what is read from there stays as it is
  std::erase_if(names, [&](const std::string& name) {
    return fs::equivalent(origin.file, wanted_.folder / walkthrough.name / name, is_not_there);
  });
  return names;
}

void Pages::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  const Walkthrough& w = story->walkthrough;
  const fs::path folder = folder_of(output, w);
  const PageSurroundings around = surroundings_of(w, wanted_);
  const auto url = [folder, is_beside = around.has_files_beside](std::size_t frame, int turn) {
    return is_beside ? picture_name(frame, turn) : render::data_url(written_picture(folder, frame, turn));
  };
  const PagePictures pictures{.url = url,
                              .page = page_of_frame(output.look),
                              .part = pictures_of_frame(w, output.look),
                              .text_scale = output.look.style.theme.text,
                              .turns = turns_of(w, output),
                              .is_dark = output.look.style.theme.paper.r < 128,
                              .font = &renderer.font()};
  renderer.then([=, &renderer, origin = *origin_of(w, wanted_), names = files(w)] {
    std::vector<PageFile> files = around.has_files_beside ? sources(*story, origin) : std::vector<PageFile>();
    std::ranges::move(page_files(*story, pictures, around), std::back_inserter(files));
    std::set<std::string> kept;
    for (const auto& [name, content] : files) {
      if (std::ranges::count(names, name)) write_output(folder / name, content);
      kept.insert(name);
    }
    remove_outputs(folder, names, kept);
    renderer.tell(folder / page_file, *story);
  });
}

std::vector<std::string> index_file_names(bool has_files_beside) {
  std::vector<std::string> names{page_file, compare_file};
  if (has_files_beside)
    for (const PageFile& program : page_programs()) names.push_back(program.name);
  return names;
}

std::vector<std::string> names_in_index(const fs::path& folder) {
  std::vector<std::string> names;
  for (const PageJson& entry : entries_in(folder)) names.push_back(entry["name"]);
  return names;
}

void write_index(const fs::path& folder, bool has_files_beside) {
  const FolderClaim claim(folder);  // or pages that another run adds meanwhile would be missing
  const std::vector<PageJson> entries = entries_in(folder);
  const auto is_search = [](const PageJson& entry) { return !entry["iteration_ends"].empty(); };
  if (std::ranges::count_if(entries, is_search) >= 2)
    write_output(folder / compare_file, page_over(entries, compare_file));
  else
    remove_outputs(folder, {compare_file});  // of an earlier run
  write_output(folder / page_file, page_over(entries, page_file));
  if (!has_files_beside) return;
  for (const auto& [name, content] : page_programs()) write_output(folder / name, content);
}

}  // namespace walkthroughs::output
