#include "walkthroughs/output/pages.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <iterator>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <system_error>
#include <utility>

#include "render/file.hpp"
#include "render/html.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/page/index_page.hpp"
#include "walkthroughs/text/shell_word.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs {
namespace {

namespace fs = std::filesystem;

/// Returns: the way from the folder of a walkthrough up to that of all.
std::string up_from(const std::string& name) {
  std::string up = "../";
  for (const char c : name) up += c == '/' ? "../" : "";
  return up;
}

/// Returns: a path as a URL, its letters beyond ASCII left to the browser.
std::string url_of(const fs::path& path) {
  std::string url;
  for (const char c : path.generic_string()) {
    const bool is_plain = static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) ||
                          std::string_view("/._-~").find(c) != std::string_view::npos;
    char escape[8];
    std::snprintf(escape, sizeof escape, "%%%02X", static_cast<unsigned char>(c));
    url += is_plain ? std::string(1, c) : escape;
  }
  return url;
}

std::string copy_of_scene(const PageOrigin& origin) { return origin.name + ".json"; }

/// Returns: what a page was made of.
std::vector<PageFile> sources(const Story& story, const PageOrigin& origin) {
  std::vector<PageFile> files;
  std::vector<Trace> traces;
  for (const Telling& telling : story.tellings) traces.push_back(telling.trace);
  if (!traces.empty()) files.push_back({trace_file, traces_json(story.walkthrough, traces)});
  if (origin.file.empty() || !origin.option.empty()) return files;
  const std::vector<std::uint8_t> scene = render::read_file(origin.file);
  files.push_back({copy_of_scene(origin), {scene.begin(), scene.end()}});
  return files;
}

/// Returns: what the page in `folder`/`name` says of itself; nothing where there is none, or none that belongs there.
std::optional<PageJson> entry_at(const fs::path& folder, const std::string& name) {
  for (const char* file : {story_file, page_file}) try {
      const std::vector<std::uint8_t> bytes = render::read_beginning(folder / name / file, std::size_t{1} << 20);
      std::optional<PageJson> entry = entry_in({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
      if (!entry || (*entry)["name"] != name) continue;
      const std::string picture = name + "/" + picture_name((*entry)["picture"]);
      (*entry)["picture_url"] = picture;
      std::error_code unreadable;
      if (fs::exists(folder / name / page_file, unreadable) && fs::exists(folder / picture, unreadable)) return entry;
    } catch (const render::ReadError&) {  // there is none
    }
  return std::nullopt;
}

/// Returns: those of all pages in the folder, in the order of the catalogue, scenes of one's own last.
std::vector<PageJson> entries_in(const fs::path& folder) {
  std::map<std::pair<std::ptrdiff_t, std::string>, PageJson> entries;
  std::error_code unreadable;
  for (auto at = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, unreadable);
       !unreadable && at != fs::recursive_directory_iterator(); at.increment(unreadable)) {
    if (at.depth() == 1) at.disable_recursion_pending();
    const std::string name = at->path().lexically_relative(folder).generic_string();
    const auto place = std::ranges::find(catalogue(), name, &Walkthrough::name) - catalogue().begin();
    if (std::optional<PageJson> entry = entry_at(folder, name)) entries.emplace(std::pair(place, name), *entry);
  }
  const auto values = std::views::values(entries);
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<PageOrigin>::const_iterator Pages::origin_of(const Walkthrough& walkthrough) const {
  return std::ranges::find(origins_, walkthrough.name, &PageOrigin::name);
}

std::vector<std::string> Pages::files(const Walkthrough& walkthrough) const {
  const PageOrigin& origin = *origin_of(walkthrough);
  std::vector<std::string> names = page_file_names();
  names.push_back(trace_file);
  if (!origin.file.empty()) names.push_back(copy_of_scene(origin));
  std::error_code is_not_there;  // what is read from there stays as it is
  std::erase_if(names, [&](const std::string& name) {
    return fs::equivalent(origin.file, folder_ / walkthrough.name / name, is_not_there);
  });
  return names;
}

PageSurroundings Pages::surroundings_of(const Walkthrough& walkthrough) const {
  const auto here = origin_of(walkthrough);
  const std::string what = here->option + shell_word(here->file.empty() ? fs::path(here->name) : here->file);
  PageSurroundings all;
  all.has_files_beside = pictures_ == Pictures::beside;
  all.command = "gjkstep render " + what + (all.has_files_beside ? " --page" : " --page=single") + options_;
  if (!walkthrough.scenes.empty() && here->option.empty())
    all.sources.push_back({all.has_files_beside ? trace_file : "", "its trace: gjkstep trace " + what});
  if (!all.has_files_beside) return all;
  if (!here->file.empty())
    all.sources.push_back({here->option.empty() ? url_of(copy_of_scene(*here)) : trace_file, here->file.filename()});
  const std::string up = up_from(walkthrough.name);
  const auto way_to = [up](const PageOrigin& other) { return up + other.name + "/" + page_file; };
  all.page_of = [up, folder = folder_, origins = origins_](const std::string& other) {
    const fs::path page = fs::path(other) / page_file;
    std::error_code unreadable;
    const bool is_there =
        std::ranges::count(origins, other, &PageOrigin::name) || fs::exists(folder / page, unreadable);
    return is_there ? up + page.generic_string() : "";
  };
  all.ways.push_back({up + page_file, "All walkthroughs"});
  if (here != origins_.begin()) all.ways.push_back({way_to(*(here - 1)), "← " + (here - 1)->title});
  if (here + 1 != origins_.end()) all.ways.push_back({way_to(*(here + 1)), "→ " + (here + 1)->title});
  return all;
}

void Pages::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  const Walkthrough& w = story->walkthrough;
  const fs::path folder = output.folder / w.name;
  const auto url = [folder, kind = pictures_](std::size_t frame, int turn) {
    return kind == Pictures::beside ? picture_name(frame, turn)
                                    : render::data_url(written_picture(folder, frame, turn));
  };
  const PagePictures pictures{.url = url,
                              .page = page_of_frame(output.look.text),
                              .part = pictures_of_frame(w, output.look),
                              .text_scale = output.look.style.theme.text,
                              .turns = turns_of(w, output),
                              .is_dark = output.look.style.theme.paper.r < 128};
  renderer.then([=, written = written_, around = surroundings_of(w), origin = *origin_of(w), names = files(w)] {
    std::vector<PageFile> files = around.has_files_beside ? sources(*story, origin) : std::vector<PageFile>();
    std::ranges::move(page_files(*story, pictures, around), std::back_inserter(files));
    std::set<std::string> kept;
    for (const auto& [name, content] : files) {
      if (std::ranges::count(names, name)) write_output(folder / name, content);
      kept.insert(name);
    }
    remove_outputs(folder, names, "", kept);
    written(folder / page_file, *story);
  });
}

void write_index(const fs::path& folder) {
  const std::vector<PageJson> entries = entries_in(folder);
  const auto is_search = [](const PageJson& entry) { return !entry["iteration_ends"].empty(); };
  if (std::ranges::count_if(entries, is_search) >= 2)
    write_output(folder / compare_file, page_over(entries, compare_file));
  else
    remove_outputs(folder, {compare_file});  // of an earlier run
  write_output(folder / page_file, page_over(entries, page_file));
}

}  // namespace walkthroughs
