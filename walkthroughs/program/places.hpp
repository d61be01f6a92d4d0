/// The places that one run of the program reads and writes.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/output/manifest.hpp"

namespace walkthroughs::program {

/// Knows all files and folders of a run before the first is written, so that nothing is written over what was read, over
/// what else was written, or over what is of others. However a path is spelt, and whichever links it goes through, one place is one place. A path that
/// ends in a link is two: a file that is written replaces the link, but whoever names it may mean what it leads to.
class Places {
 public:
  /// What is read: a scene file, a trace. `what` names it in messages, here and below.
  void read(const std::filesystem::path& file, const std::string& what);
  /// A file that is written.
  void write(const std::filesystem::path& file, const std::string& what);
  /// A file that is written later by whoever reads what is printed.
  void reserve(const std::filesystem::path& file, const std::string& what);
  /// A folder in which files are written, or removed, whose names fit those patterns (see fits()): nothing else of the run may
  /// be one of them there.
  void write_into(const std::filesystem::path& folder, const std::vector<std::string>& names, const std::string& what);
  /// Standard input, or standard output, where it is a file.
  void read_standard_input();
  void write_standard_output();

  /// Errors: UsageError where two of them that are not both read are at the same place, or a file is where a folder must be.
  void expect_apart() const;
  /// Errors: UsageError where files of others would be lost that are to be kept; `elsewhere` says how to name other places.
  /// Where they are not, these files are ours from now on.
  void expect_no_loss(Others others, const std::string& elsewhere) const;
  /// At the end of the run: tidies the manifests of all folders.
  void tidy_manifests() const;

 private:
  using Place = std::pair<std::filesystem::path, std::string>;  // and what is there
  struct Folder {
    std::filesystem::path place, spelt;
    std::vector<std::string> names;
    std::string what;
  };

  static void add(std::vector<Place>& places, const std::filesystem::path& file, const std::string& what);

  std::vector<Place> read_, written_;
  std::vector<Place> files_;  // as they are spelt
  std::vector<Folder> folders_;
};

/// Errors: UsageError where what is to be written has no name, that of the next option, or "-". `example`: what to
/// name, and how.
void expect_named(const std::string& option, const std::string& name, const std::string& example);

}  // namespace walkthroughs::program
