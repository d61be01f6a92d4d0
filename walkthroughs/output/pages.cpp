#include "walkthroughs/output/pages.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "render/file.hpp"
#include "render/html.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/page/compare_page.hpp"
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

/// What the page asks for, before there is a page that asks. Where it asks for nothing, that of an earlier run goes.
void write_files_beside(const Story& story, const PagePictures& pictures, const PageSurroundings& around,
                        const fs::path& folder) {
  if (around.has_files)
    for (const PageFile& file : page_files(story, pictures, around)) write_output(folder / file.name, file.content);
  else
    remove_outputs(folder, {files_asked_for.begin(), files_asked_for.end()});
}

std::string copy_of_scene(const PageOrigin& origin) { return origin.name + ".json"; }

/// Returns: what may lie beside a page of where it comes from, written there or left by an earlier run; but for what is read from
/// there, which stays as it is.
std::vector<std::string> sources_beside(const PageOrigin& origin, const fs::path& folder) {
  std::vector<std::string> names{trace_file};
  if (!origin.file.empty()) names.push_back(copy_of_scene(origin));
  std::error_code is_not_there;
  std::erase_if(names, [&](const std::string& name) {
    return !origin.file.empty() && fs::equivalent(origin.file, folder / name, is_not_there);
  });
  return names;
}

/// Returns: its content; nothing where the page has no such source.
std::string source(const std::string& name, const Story& story, const PageOrigin& origin) {
  if (name == trace_file) {
    std::vector<Trace> traces;
    for (const Telling& telling : story.tellings) traces.push_back(telling.trace);
    return traces.empty() ? "" : traces_json(story.walkthrough, traces);
  }
  if (!origin.option.empty()) return "";
  const std::vector<std::uint8_t> bytes = render::read_file(origin.file);
  return {bytes.begin(), bytes.end()};
}

void write_sources(const Story& story, const PageOrigin& origin, Pages::Pictures pictures, const fs::path& folder) {
  for (const std::string& name : sources_beside(origin, folder)) {
    const std::string content = pictures == Pages::Pictures::beside ? source(name, story, origin) : "";
    if (content.empty())
      remove_outputs(folder, {name});
    else
      write_output(folder / name, content);
  }
}

/// Returns: so many bytes at most; none where there is no such file.
std::string beginning_of(const fs::path& path, std::size_t bytes) {
  std::string beginning(bytes, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file) return "";
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  return beginning;
}

/// Returns: what the page in `folder`/`name` says of itself; nothing where there is none, or none that belongs there.
std::optional<IndexEntry> entry_at(const fs::path& folder, const std::string& name) {
  std::optional<IndexEntry> entry = entry_of(beginning_of(folder / name / page_file, std::size_t{1} << 20));
  if (!entry || entry->name != name) return std::nullopt;
  entry->picture_url = name + "/" + picture_name(entry->picture);
  std::error_code unreadable;
  return fs::exists(folder / entry->picture_url, unreadable) ? entry : std::nullopt;
}

/// Returns: the folders in which a walkthrough may lie, by name, in the order of the catalogue, scenes of one's own last.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable, no_status;
  for (auto at = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, unreadable);
       !unreadable && at != fs::recursive_directory_iterator(); at.increment(unreadable)) {
    if (at.depth() == 1) at.disable_recursion_pending();
    if (at->is_directory(no_status)) names.push_back(at->path().lexically_relative(folder).generic_string());
  }
  const auto place = [](const std::string& name) {
    return std::ranges::find(catalogue(), name, &Walkthrough::name) - catalogue().begin();
  };
  std::ranges::sort(names, {}, [&](const std::string& name) { return std::pair(place(name), name); });
  return names;
}

std::vector<IndexEntry> pages_in(const fs::path& folder) {
  std::vector<IndexEntry> entries;
  for (const std::string& name : names_in(folder))
    if (std::optional<IndexEntry> entry = entry_at(folder, name)) entries.push_back(std::move(*entry));
  return entries;
}

}  // namespace

std::vector<PageOrigin>::const_iterator Pages::origin_of(const Walkthrough& walkthrough) const {
  return std::ranges::find(origins_, walkthrough.name, &PageOrigin::name);
}

std::vector<std::string> Pages::files(const Walkthrough& walkthrough) const {
  std::vector<std::string> files{page_file};
  files.insert(files.end(), files_asked_for.begin(), files_asked_for.end());
  std::ranges::move(sources_beside(*origin_of(walkthrough), folder_ / walkthrough.name), std::back_inserter(files));
  return files;
}

PageSurroundings Pages::surroundings_of(const Walkthrough& walkthrough) const {
  const auto here = origin_of(walkthrough);
  const std::string what = here->option + shell_word(here->file.empty() ? fs::path(here->name) : here->file);
  PageSurroundings all;
  all.command = "gjkstep render " + what + (pictures_ == Pictures::inside ? " --page=single" : " --page") + options_;
  if (!walkthrough.scenes.empty() && here->option.empty()) all.trace_command = "gjkstep trace " + what;
  if (pictures_ == Pictures::inside) return all;
  all.has_files = true;
  if (!here->file.empty())
    all.sources.push_back(
        {url_of(here->option.empty() ? copy_of_scene(*here) : trace_file), here->file.filename().string()});
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
  renderer.then([=, written = written_, around = surroundings_of(w), origin = *origin_of(w), kind = pictures_] {
    write_files_beside(*story, pictures, around, folder);
    write_sources(*story, origin, kind, folder);
    write_output(folder / page_file, page_html(*story, pictures, around));
    written(folder / page_file, *story);
  });
}

void write_index(const fs::path& folder) {
  const std::vector<IndexEntry> entries = pages_in(folder), searches = comparable(entries);
  const bool is_pair = searches.size() >= 2;
  if (is_pair)
    write_output(folder / compare_file, compare_html(searches));
  else
    remove_outputs(folder, {compare_file});  // of an earlier run
  write_output(folder / page_file, index_html(entries, is_pair ? compare_file : ""));
}

}  // namespace walkthroughs
