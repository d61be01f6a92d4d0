#include "walkthroughs/program/places.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/program/exit_code.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::program {
namespace {

namespace fs = std::filesystem;

/// Returns: the one spelling of that place. Follows also links to what is not there yet, as weakly_canonical() does not, and
/// `links` of them at most, as the system does.
fs::path resolved(const fs::path& path, int& links) {
  std::error_code is_none;
  fs::path found;
  for (const fs::path& part : fs::absolute(path)) {
    if (part == "..") {
      found = found.parent_path();
    } else if (!part.empty() && part != ".") {
      const fs::path target = links > 0 ? fs::read_symlink(found / part, is_none) : fs::path();
      found = target.empty() ? found / part : resolved(found / target, --links);
    }
  }
  return found;
}

fs::path resolved(const fs::path& path) {
  int links = 40;
  return resolved(path, links);
}

/// Returns: the same, but for its last name, which is not followed where it is a link.
fs::path resolved_but_for_last(const fs::path& path) {
  const fs::path last = path.filename();
  const bool is_name = !last.empty() && last != "." && last != "..";
  return is_name ? resolved(path.has_parent_path() ? path.parent_path() : ".") / last : resolved(path);
}

bool is_one_of(const std::vector<std::string>& names, const std::string& file) {
  return std::ranges::any_of(names, [&file](const std::string& name) { return fits(name, file); });
}

[[noreturn]] void refuse(const std::string& one, const std::string& other, const fs::path& where) {
  throw UsageError(one + " and " + other + " have the same place, " + where.string() +
                   ": one would be written over the other. Give one of them another place");
}

/// Requires: there is one. Names the first few.
[[noreturn]] void refuse_to_lose(const std::vector<fs::path>& files, const std::string& elsewhere) {
  const std::size_t named = std::min<std::size_t>(3, files.size());
  std::string words = files[0].string();
  for (std::size_t i = 1; i < named; ++i) words += (i + 1 == files.size() ? " and " : ", ") + files[i].string();
  if (named < files.size()) words += " and " + std::to_string(files.size() - named) + " more";
  throw UsageError(
      words + (files.size() == 1 ? " is not of gjkstep, or was" : " are not of gjkstep, or were") +
      " changed since, and would be overwritten or removed. Nothing is written. Choose another place with " +
      elsewhere + ", or say --force");
}

/// Returns: the path of what a standard stream is, empty where it is no file, such as a pipe.
fs::path file_of(int stream) {
  struct stat status {};
  if (::fstat(stream, &status) != 0 || !S_ISREG(status.st_mode)) return {};
  std::error_code unknown;
  return fs::read_symlink("/proc/self/fd/" + std::to_string(stream), unknown);
}

}  // namespace

void Places::add(std::vector<Place>& places, const fs::path& file, const std::string& what) {
  places.emplace_back(resolved_but_for_last(file), what);
  if (resolved(file) != places.back().first) places.emplace_back(resolved(file), what);
}

void Places::read(const fs::path& file, const std::string& what) {
  is_standard_input(file) ? read_standard_input() : add(read_, file, what);
}
void Places::reserve(const fs::path& file, const std::string& what) { add(written_, file, what); }

void Places::write(const fs::path& file, const std::string& what) {
  reserve(file, what);
  files_.emplace_back(file, what);
}

void Places::write_into(const fs::path& folder, const std::vector<std::string>& names, const std::string& what) {
  folders_.push_back({resolved(folder), folder, names, what});
}

void Places::read_standard_input() {
  if (const fs::path file = file_of(STDIN_FILENO); !file.empty()) add(read_, file, "standard input");
}

void Places::write_standard_output() {
  if (const fs::path file = file_of(STDOUT_FILENO); !file.empty()) reserve(file, "standard output");
}

void Places::expect_apart() const {
  std::map<fs::path, const Folder*> written_into;
  std::map<fs::path, std::string> folders, files;
  const auto add_folders = [&](fs::path folder, const std::string& what) {
    while (folders.emplace(folder, what).second && folder.has_relative_path()) folder = folder.parent_path();
  };
  for (const Folder& folder : folders_) {
    const auto [there, is_new] = written_into.emplace(folder.place, &folder);
    if (!is_new) refuse(there->second->what, folder.what, folder.place);
    add_folders(folder.place, folder.what);
  }
  for (const auto& [place, what] : written_) add_folders(place.parent_path(), what);
  const auto expect_not_written_into = [&](const fs::path& place, const std::string& what) {
    const auto there = written_into.find(place.parent_path());
    if (there != written_into.end() && is_one_of(there->second->names, place.filename().string()))
      refuse(what, there->second->what, place);
  };
  for (const auto& [folder, what] : folders) expect_not_written_into(folder, what);
  const auto expect_no_folder = [&](const fs::path& place, const std::string& what) {
    if (const auto there = folders.find(place); there != folders.end()) refuse(what, there->second, place);
  };
  for (const auto& [place, what] : read_) files.emplace(place, what);
  for (const auto& [file, what] : files_)
    if (file.filename() == manifest_file) refuse(what, "the manifest of that folder", file);
  for (const auto& [place, what] : written_)
    if (const auto [there, is_new] = files.emplace(place, what); !is_new) refuse(what, there->second, place);
  for (const auto& [place, what] : files) {
    expect_not_written_into(place, what);
    expect_no_folder(place, what);
  }
}

void Places::expect_no_loss(Others others, const std::string& elsewhere) const {
  std::vector<fs::path> lost;
  for (const auto& [file, what] : files_) std::ranges::copy(files_of_others(file), std::back_inserter(lost));
  for (const Folder& folder : folders_)
    std::ranges::copy(files_of_others(folder.spelt, folder.names), std::back_inserter(lost));
  if (others == Others::overwritten)
    std::ranges::for_each(lost, adopt);
  else if (!lost.empty())
    refuse_to_lose(lost, elsewhere);
}

void Places::tidy_manifests() const {
  std::set<fs::path> folders;
  for (const auto& [file, what] : files_) folders.insert(file.parent_path());
  for (const Folder& folder : folders_) folders.insert(folder.spelt);
  std::ranges::for_each(folders, tidy_manifest);
}

void expect_named(const std::string& option, const std::string& name, const std::string& example) {
  if (name.empty() || name.starts_with("--")) throw UsageError(option + " " + in_quotes(name) + ": name " + example);
  if (name == "-")
    throw UsageError(option + " '-': this is not written to standard output; name " + example +
                     ", or ./- if you mean it");
}

}  // namespace walkthroughs::program
