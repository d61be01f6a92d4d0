/// What the program has written, so that no file of others is lost: a manifest in each folder of outputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::output {

/// Lines "CRC-32 size name" about the files beside it. A file is ours as long as one of the lines of its name fits it. Other lines
/// count for nothing, and stay.
inline constexpr const char* manifest_file = ".gjkstep";

/// Whether a pattern such as ###-turn-#.png fits the name of a file: each # is a digit, the last of a row of them one or more, and
/// a * at the beginning stands for anything.
bool fits(std::string_view pattern, std::string_view name);

/// A folder that a run writes to. As long as this lives other runs wait for it, where the file system has locks.
class FolderClaim {
 public:
  /// `waits`: called before it waits for another run. Claims of several folders are made in the order of their names.
  explicit FolderClaim(const std::filesystem::path& folder, const std::function<void()>& waits = {});
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

 private:
  int descriptor_;
};

/// Writes as render::write_file(), and the line about it before it is there: a run that is killed in between leaves a file that is
/// still known. Errors: render::FileError.
void write_output(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);
void write_output(const std::filesystem::path& file, std::string_view text);

/// Removes what is ours in `folder` and fits one of the patterns, but for what is `kept`.
void remove_outputs(const std::filesystem::path& folder, const std::vector<std::string>& patterns,
                    const std::set<std::string>& kept = {});

/// Where a run writes what is to replace an older state of a folder at once: in this folder below it.
inline constexpr const char* stage_folder = ".unfinished";

/// What happens to files that the program has not written, or that were changed since.
enum class Others { kept, overwritten };

/// Moves all that was written to the stage of a folder to its place, and removes what is ours there, fits the patterns and has
/// not come from the stage. `last` is moved when all else is in place, and what was there of that name is removed before. So a
/// run that is interrupted before leaves the old state. In between it leaves none with that file.
/// Errors: render::FileError, before anything is moved where a folder is in the way, or a file that is to be kept.
void publish(const std::filesystem::path& folder, const std::vector<std::string>& patterns, const std::string& last,
             Others others);

/// Removes what is ours from a folder, and the folder, unless there is more in it.
void discard(const std::filesystem::path& folder);

/// The same of the stage of a folder: also that of a run that was killed.
void discard_stage(const std::filesystem::path& folder);

/// Returns: the files in `folder` whose names fit one of the patterns and that would be lost where one of that name is written or
/// removed: those that are not ours.
/// Errors: render::FileError where the folder cannot be looked into.
std::vector<std::filesystem::path> files_of_others(const std::filesystem::path& folder,
                                                   const std::vector<std::string>& patterns);

/// The same of one file.
std::vector<std::filesystem::path> files_of_others(const std::filesystem::path& file);

/// Returns: the files in `folder` that are ours. Errors: render::FileError where the folder cannot be looked into.
std::vector<std::filesystem::path> our_files(const std::filesystem::path& folder);

/// Makes a file ours as it is. Errors: render::FileError.
void adopt(const std::filesystem::path& file);

/// Takes lines that no file fits any more out of the manifest of a folder, if it has one. Errors: render::FileError.
void tidy_manifest(const std::filesystem::path& folder);

}  // namespace walkthroughs::output
