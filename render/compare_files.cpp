#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <iterator>
#include <map>
#include <new>
#include <system_error>
#include <utility>

#include "render/compare.hpp"
#include "render/file.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& path) { return boost::algorithm::iequals(path.extension().string(), ".png"); }

[[noreturn]] void fail(const fs::path& folder, const std::string& why, const std::string& what_to_do) {
  throw ReadError("cannot read the folder " + folder.string() + ": " + why + "; " + what_to_do);
}

/// Returns: what is in `folder`. So the folder is not kept open while those below are read.
std::vector<fs::directory_entry> entries_of(const fs::path& folder, std::error_code& error) {
  std::vector<fs::directory_entry> entries;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) entries.push_back(*entry);
  return entries;
}

/// A walk through all folders below one.
class Walk {
 public:
  explicit Walk(const fs::path& root) : root_(root) {}

  std::vector<std::string> names() {
    if (const std::error_code error = enter(root_))
      fail(root_, error.message(), "check that it exists and may be read");
    std::ranges::sort(names_);
    return std::move(names_);
  }

 private:
  static constexpr int most_links = 1'000;

  /// Returns: why not, where `folder` cannot be entered.
  std::error_code enter(const fs::path& folder) {
    std::error_code error;
    const fs::path place = place_of(folder, error);
    if (std::ranges::count(around_, place) > 0) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    if (error) return error;
    const std::vector<fs::directory_entry> entries = entries_of(folder, error);
    if (error) return error;
    around_.push_back(place);
    for (const fs::directory_entry& entry : entries) take(entry);
    around_.pop_back();
    return {};
  }

  /// Returns: the name of `folder` that has no links in it.
  fs::path place_of(const fs::path& folder, std::error_code& error) {
    if (!around_.empty() && !fs::is_symlink(folder, error)) return around_.back() / folder.filename();
    if (++links_ > most_links)
      fail(root_, "there are more than 1,000 links to folders below", "look for links to folders of links");
    return fs::canonical(folder, error);
  }

  void take(const fs::directory_entry& entry) {
    std::error_code unknown;
    const bool is_folder = entry.is_directory(unknown), leads_nowhere = !is_folder && !entry.exists(unknown);
    const fs::path& path = entry.path();
    const bool listed = is_folder ? bool(enter(path)) : leads_nowhere || is_picture(path);
    if (listed) names_.push_back(path.lexically_relative(root_).generic_string());
  }

  const fs::path root_;
  std::vector<std::string> names_;
  std::vector<fs::path> around_;  // the folders that hold the current one
  int links_ = 0;                 // that were followed
};

/// A folder among the pictures is there because it could not be entered.
[[noreturn]] void fail_to_enter(const fs::path& folder) {
  std::error_code error;
  entries_of(folder, error);
  if (error) fail(folder, error.message(), "check that it may be read");
  fail(folder, "a link makes it lead back to a folder around it", "remove the link");
}

PngPicture read_picture(const fs::path& path) {
  std::error_code unknown;
  if (fs::is_directory(path, unknown)) fail_to_enter(path);
  try {
    return read_png(path);
  } catch (const std::bad_alloc&) {
    throw ReadError("cannot read " + path.string() + ": not enough memory; compare smaller pictures" + memory_limit());
  }
}

/// Notes what a file says, and returns its picture.
Image noted(PngPicture picture, const std::string& side, std::vector<std::string>& notes) {
  for (const std::string& warning : picture.warnings) notes.push_back("of the " + side + " picture " + warning);
  if (picture.pictures > 1)
    notes.push_back("of the " + std::to_string(picture.pictures) + " pictures of the " + side +
                    " animation only the first is compared");
  return std::move(picture.image);
}

/// How samples are to be shown. Viewers may show the same samples in other colours.
void note_colours(const PngPicture& expected, const PngPicture& actual, std::vector<std::string>& notes) {
  std::map<std::string, std::string> either = expected.colours;
  either.insert(actual.colours.begin(), actual.colours.end());
  for (const auto& [type, data] : either) {
    const auto says_so = [&](const PngPicture& picture) {
      const auto own = picture.colours.find(type);
      return own != picture.colours.end() && own->second == data;
    };
    if (!says_so(expected) || !says_so(actual))
      notes.push_back("the chunk " + type + " differs, which tells how to show the samples that are compared");
  }
}

void compare_pictures(ComparedFiles& found) {
  const Sides sides = found.files.sides;
  std::optional<PngPicture> expected, actual;
  if (sides != Sides::only_actual) expected = read_picture(found.files.expected);
  if (sides != Sides::only_expected) actual = read_picture(found.files.actual);
  if (expected && actual) note_colours(*expected, *actual, found.notes);
  if (expected) found.expected = noted(std::move(*expected), "expected", found.notes);
  if (actual) found.actual = noted(std::move(*actual), "actual", found.notes);
  if (sides == Sides::only_expected) {
    found.verdict = Verdict::missing;
    found.words = "only the expected side has it";
  } else if (sides == Sides::only_actual) {
    found.verdict = Verdict::extra;
    found.words = "only the actual side has it";
  } else {
    found.comparison = compare(*found.expected, *found.actual);
    found.verdict = found.comparison.verdict;
    found.words = in_words(found.comparison);
  }
}

}  // namespace

std::vector<std::string> pictures_in(const fs::path& folder) { return Walk(folder).names(); }

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

ComparedFiles compare_files(const FilePair& files) {
  ComparedFiles found{.files = files, .words = {}, .expected = {}, .actual = {}};
  try {
    compare_pictures(found);
  } catch (const ReadError& error) {
    found.verdict = Verdict::unreadable;
    found.words = error.what();
  }
  return found;
}

}  // namespace render
