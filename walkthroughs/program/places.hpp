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
  /// A folder in which pictures are written: nothing else of the run may be a picture or a film there (.png, .mp4, .gif).
  void write_pictures(const std::filesystem::path& folder, const std::string& what);
  /// Standard input, or standard output, where it is a file.
  void read_standard_input();
  void write_standard_output();

  /// Errors: UsageError where two of them that are not both read are at the same place, or a file is where a folder must be.
  void expect_apart() const;

 private:
  using Place = std::pair<std::filesystem::path, std::string>;  // and what is there

  static void add(std::vector<Place>& places, const std::filesystem::path& file, const std::string& what);

  std::vector<Place> read_, written_, pictures_;
};

}  // namespace walkthroughs
