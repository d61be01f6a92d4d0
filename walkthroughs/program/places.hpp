/// The places that one run of the program reads and writes.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace walkthroughs {

/// Knows all files and folders of a run before the first is written, so that nothing is written over what was read or over
/// what else was written. However a path is spelt, and whichever links it goes through, one place is one place. A path that
/// ends in a link is two: a file that is written replaces the link, but whoever names it may mean what it leads to.
class Places {
 public:
  /// What is read: a scene file, a trace. `what` names it in messages, here and below.
  void read(const std::filesystem::path& file, const std::string& what);
  /// A file that is written.
  void write(const std::filesystem::path& file, const std::string& what);
  /// A folder in which files of those names are written, *.png being all with that ending: nothing else of the run may be
  /// one of them there.
  void write_into(const std::filesystem::path& folder, const std::vector<std::string>& names, const std::string& what);
  /// Standard input, or standard output, where it is a file.
  void read_standard_input();
  void write_standard_output();

  /// Errors: UsageError where two of them that are not both read are at the same place, or a file is where a folder must be.
  void expect_apart() const;

 private:
  using Place = std::pair<std::filesystem::path, std::string>;  // and what is there
  struct Folder {
    std::filesystem::path place;
    std::vector<std::string> names;
    std::string what;
  };

  static void add(std::vector<Place>& places, const std::filesystem::path& file, const std::string& what);

  std::vector<Place> read_, written_;
  std::vector<Folder> folders_;
};

}  // namespace walkthroughs
