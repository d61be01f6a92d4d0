#include "walkthroughs/output/manifest.hpp"

#include <fcntl.h>
#include <libdeflate.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <sstream>
#include <system_error>

#include "render/file.hpp"

namespace walkthroughs::output {
namespace {

namespace fs = std::filesystem;

using Bytes = std::span<const std::uint8_t>;

/// Returns: nothing where it cannot be read: who cannot look into a file does not know it.
std::vector<std::uint8_t> content_of(const fs::path& file) {
  try {
    return render::read_file(file);
  } catch (const render::ReadError&) {
    return {};
  }
}

std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// What stands beside a file while it replaces another has the name of that one in the manifest.
std::string name_in_place(std::string name) {
  constexpr std::string_view unfinished = ".unfinished";
  if (name.ends_with(unfinished)) name.erase(name.size() - unfinished.size());
  return name;
}

// ---------------------------------------------------------------------------------------------- lines

std::string line_of(std::string name, Bytes bytes) {
  char mark[40];
  std::snprintf(mark, sizeof mark, "%08x %zu ", libdeflate_crc32(0, bytes.data(), bytes.size()), bytes.size());
  std::ranges::replace(name, '\n', '/');  // which no name has
  return mark + name;
}

/// Returns: the name in a line; empty where it is none of ours.
std::string name_in(const std::string& line) {
  const auto is_hexadecimal = [](char c) { return ('0' <= c && c <= '9') || ('a' <= c && c <= 'f'); };
  const std::size_t size = line.find(' '), end = line.find(' ', size + 1);
  if (size != 8 || end == std::string::npos || !std::all_of(line.begin(), line.begin() + 8, is_hexadecimal) ||
      !fits("#", std::string_view(line).substr(size + 1, end - size - 1)))
    return "";
  std::string name = line.substr(end + 1);
  std::ranges::replace(name, '/', '\n');
  return name;
}

/// The lines about the files of a folder.
class Manifest {
 public:
  explicit Manifest(const fs::path& folder) : folder_(folder) {
    std::istringstream text{std::string(text_of(content_of(folder / manifest_file)))};
    for (std::string line; std::getline(text, line);) {
      const std::string name = name_in(line);
      std::vector<std::string>& lines = lines_[name];
      if (name.empty() ? !line.empty() : std::ranges::count(lines, line) == 0) lines.push_back(line);
    }
  }

  bool is_ours(const std::string& name) const {
    const auto lines = lines_.find(name_in_place(name));
    return lines != lines_.end() &&
           std::ranges::count(lines->second, line_of(lines->first, content_of(folder_ / name))) > 0;
  }

  /// Returns: its text without lines about files that are gone, or that were replaced. A file that was changed keeps its lines.
  std::string tidied() const {
    std::string text;
    for (const auto& [name, lines] : lines_) {
      std::error_code unknown;
      if (!name.empty() && !fs::exists(folder_ / name, unknown)) continue;
      const std::string fitting = lines.size() > 1 ? line_of(name, content_of(folder_ / name)) : "";
      const bool is_known = std::ranges::count(lines, fitting) > 0;
      for (const std::string& line : lines) text += is_known && line != fitting ? "" : line + "\n";
    }
    return text;
  }

 private:
  fs::path folder_;
  std::map<std::string, std::vector<std::string>> lines_;  // by name; by "" those that are not ours
};

// ---------------------------------------------------------------------------------------------- folders

int opened(const fs::path& folder) {
  return ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

/// Waits for others, unless `how` is LOCK_NB. Returns: false where another has the lock. A file system may know none.
bool lock(int descriptor, int how = 0) {
  while (::flock(descriptor, LOCK_EX | how) != 0)
    if (errno != EINTR) return errno != EWOULDBLOCK;
  return true;
}

/// Whatever it is called.
using FolderNumber = std::pair<dev_t, ino_t>;

FolderNumber number_of(int descriptor) {
  struct stat status {};
  ::fstat(descriptor, &status);
  return {status.st_dev, status.st_ino};
}

/// Those that this run claims.
std::set<FolderNumber>& claimed() {
  static std::set<FolderNumber> folders;
  return folders;
}

/// As long as it lives other runs neither write to the folder nor tidy it, where the file system has locks.
class Lock {
 public:
  explicit Lock(const fs::path& folder) : descriptor_(opened(folder)) {
    if (descriptor_ >= 0 && !claimed().contains(number_of(descriptor_))) lock(descriptor_);
  }
  ~Lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int descriptor_;
};

/// Appends a line about a file with these bytes. It begins with the end of the one before, which a full disk may have cut short.
void note(const fs::path& file, Bytes bytes) {
  const fs::path manifest = file.parent_path() / manifest_file;
  const std::string line = "\n" + line_of(name_in_place(file.filename().string()), bytes);
  const int descriptor = ::open(manifest.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666);
  const bool is_written =
      descriptor >= 0 && ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int error = errno;
  const bool is_closed = descriptor < 0 || ::close(descriptor) == 0;
  if (!is_written || !is_closed)
    throw render::FileError("cannot write " + manifest.string() + ", which says what gjkstep wrote there: " +
                            std::generic_category().message(is_written ? errno : error) +
                            "; check that it may be written to and the disk has space left");
}

/// Returns: the names in `folder` that fit one of the patterns, sorted.
std::vector<std::string> fitting_names(const fs::path& folder, const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  std::error_code error;
  if (!fs::is_directory(folder, error)) return names;
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (std::ranges::any_of(patterns, [&](const std::string& pattern) { return fits(pattern, name_in_place(name)); }))
      names.push_back(name);
  }
  if (error)
    throw render::FileError("cannot look into the folder " + folder.string() + ": " + error.message() +
                            "; check that it may be read, or choose another");
  std::ranges::sort(names);
  return names;
}

/// Whether it would be lost: folders and devices are neither replaced nor removed.
bool is_file(const fs::path& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  return fs::is_regular_file(status) || (!fs::exists(status) && fs::is_symlink(fs::symlink_status(path, unknown)));
}

bool is_digit(char c) { return '0' <= c && c <= '9'; }

}  // namespace

bool fits(std::string_view pattern, std::string_view name) {
  if (pattern.starts_with('*')) return name.ends_with(pattern.substr(1));
  while (!pattern.empty() && !name.empty()) {
    if (pattern[0] == '#' ? !is_digit(name[0]) : pattern[0] != name[0]) return false;
    const bool is_last_of_number = pattern[0] == '#' && !pattern.starts_with("##");
    name.remove_prefix(1);
    if (!is_last_of_number || name.empty() || !is_digit(name[0])) pattern.remove_prefix(1);
  }
  return pattern.empty() && name.empty();
}

FolderClaim::FolderClaim(const fs::path& folder, const std::function<void()>& waits) : descriptor_(opened(folder)) {
  if (descriptor_ < 0) return;
  if (!lock(descriptor_, LOCK_NB)) {
    if (waits) waits();
    lock(descriptor_);
  }
  claimed().insert(number_of(descriptor_));
}

FolderClaim::~FolderClaim() {
  if (descriptor_ < 0) return;
  claimed().erase(number_of(descriptor_));
  ::close(descriptor_);
}

void write_output(const fs::path& file, Bytes bytes) {
  const Lock lock(file.parent_path());
  note(file, bytes);
  render::write_file(file, bytes);
}

void write_output(const fs::path& file, std::string_view text) {
  write_output(file, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void remove_outputs(const fs::path& folder, const std::vector<std::string>& patterns,
                    const std::set<std::string>& kept) {
  const Lock lock(folder);
  const Manifest manifest(folder);
  std::error_code ignored;
  for (const std::string& name : fitting_names(folder, patterns))
    if (!kept.contains(name_in_place(name)) && is_file(folder / name) && manifest.is_ours(name))
      fs::remove(folder / name, ignored);
}

void publish(const fs::path& folder, const std::vector<std::string>& patterns, const std::string& last, Others others) {
  const fs::path stage = folder / stage_folder;
  const std::vector<std::string> names = fitting_names(stage, patterns);
  for (const std::string& name : names)
    if (std::error_code unknown; fs::exists(folder / name, unknown) && !is_file(folder / name))
      throw render::FileError("cannot write " + (folder / name).string() +
                              ": it is a folder or no regular file; check that you mean it, and move it away");
  if (const auto lost = files_of_others(folder, patterns); others == Others::kept && !lost.empty())
    throw render::FileError(
        lost[0].string() +
        " was changed while the page was drawn, and would be lost. Nothing is replaced; move it away, "
        "or say --force");
  std::set<std::string> moved;
  const auto move = [&](const std::string& name) {
    const Lock lock(folder);
    note(folder / name, content_of(stage / name));
    std::error_code error;
    fs::rename(stage / name, folder / name, error);
    if (error)
      throw render::FileError("cannot write " + (folder / name).string() + ": " + error.message() +
                              "; check that the folder may be written to");
    fs::remove(folder / (name + ".unfinished"), error);  // as render::write_file() does
    moved.insert(name);
  };
  remove_outputs(folder, {last});
  for (const std::string& name : names)
    if (name != last) move(name);
  remove_outputs(folder, patterns, moved);
  if (std::ranges::count(names, last) > 0) move(last);
  discard_stage(folder);
}

void discard(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(fs::symlink_status(folder, ignored))) return;
  remove_outputs(folder, {"*"});
  tidy_manifest(folder);
  if (Manifest(folder).tidied().empty()) fs::remove(folder / manifest_file, ignored);
  fs::remove(folder, ignored);
}

void discard_stage(const fs::path& folder) { discard(folder / stage_folder); }

std::vector<fs::path> our_files(const fs::path& folder) {
  const Manifest manifest(folder);
  std::vector<fs::path> found;
  for (const std::string& name : fitting_names(folder, {"*"}))
    if (is_file(folder / name) && manifest.is_ours(name)) found.push_back(folder / name);
  return found;
}

std::vector<fs::path> files_of_others(const fs::path& folder, const std::vector<std::string>& patterns) {
  const Manifest manifest(folder);
  std::vector<fs::path> found;
  for (const std::string& name : fitting_names(folder, patterns))
    if (is_file(folder / name) && !manifest.is_ours(name)) found.push_back(folder / name);
  return found;
}

std::vector<fs::path> files_of_others(const fs::path& file) {
  const Manifest manifest(file.parent_path());
  std::vector<fs::path> found{file, file.string() + ".unfinished"};
  std::erase_if(found,
                [&](const fs::path& each) { return !is_file(each) || manifest.is_ours(each.filename().string()); });
  return found;
}

void adopt(const fs::path& file) {
  const Lock lock(file.parent_path());
  note(file, content_of(file));
}

void tidy_manifest(const fs::path& folder) {
  const Lock lock(folder);
  if (const std::string text = Manifest(folder).tidied(); !text.empty())
    render::write_file(folder / manifest_file, text);
}

}  // namespace walkthroughs::output
