#include "render/compare_files.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <new>
#include <system_error>

namespace render {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".png";
}

[[noreturn]] void fail(const fs::path& folder, const std::error_code& error) {
  throw ReadError("cannot read the folder " + folder.string() + ": " + error.message() +
                  "; check that it exists and may be read");
}

void collect(const fs::path& folder, const fs::path& root, std::vector<std::string>& names) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code unknown;  // what kind of entry; then it is not a folder
    if (entry->symlink_status(unknown).type() == fs::file_type::directory)
      collect(entry->path(), root, names);
    else if (is_picture(entry->path()))
      names.push_back(entry->path().lexically_relative(root).generic_string());
  }
  if (error) fail(folder, error);
}

/// Refuses what would never end, such as a pipe or a device; a file that is not there has its own message.
Image read_picture(const fs::path& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw ReadError("cannot read " + path.string() + ": it is not a file; put a PNG file in its place");
  try {
    return read_png(path);
  } catch (const std::bad_alloc&) {
    throw ReadError("cannot read " + path.string() + ": not enough memory; compare smaller pictures");
  }
}

void compare_pictures(ComparedFiles& found, const Tolerance& tolerance) {
  const Sides sides = found.files.sides;
  if (sides != Sides::only_actual) found.expected = read_picture(found.files.expected);
  if (sides != Sides::only_expected) found.actual = read_picture(found.files.actual);
  if (sides == Sides::only_expected) {
    found.verdict = Verdict::missing;
    found.words = "only the expected side has it";
  } else if (sides == Sides::only_actual) {
    found.verdict = Verdict::extra;
    found.words = "only the actual side has it";
  } else {
    found.comparison = compare(*found.expected, *found.actual, tolerance);
    found.verdict = found.comparison.verdict;
    found.words = in_words(found.comparison);
  }
}

}  // namespace

std::vector<std::string> pictures_in(const fs::path& folder) {
  std::vector<std::string> names;
  collect(folder, folder, names);
  std::ranges::sort(names);
  return names;
}

std::vector<FilePair> file_pairs(const fs::path& expected, const fs::path& actual) {
  const std::vector<std::string> of_expected = pictures_in(expected), of_actual = pictures_in(actual);
  std::vector<std::string> all;
  std::ranges::set_union(of_expected, of_actual, std::back_inserter(all));
  std::vector<FilePair> pairs;
  for (const std::string& name : all) {
    const Sides sides = !std::ranges::binary_search(of_actual, name)     ? Sides::only_expected
                        : !std::ranges::binary_search(of_expected, name) ? Sides::only_actual
                                                                         : Sides::both;
    pairs.push_back({name, expected / name, actual / name, sides});
  }
  return pairs;
}

ComparedFiles compare_files(const FilePair& files, const Tolerance& tolerance) {
  ComparedFiles found{.files = files, .words = {}, .expected = {}, .actual = {}};
  try {
    compare_pictures(found, tolerance);
  } catch (const ReadError& error) {
    found.verdict = Verdict::unreadable;
    found.words = error.what();
  }
  return found;
}

}  // namespace render
