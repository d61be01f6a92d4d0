/// The files that a study leaves in a folder.
#pragma once

#include <filesystem>
#include <vector>

#include "tests/study/sweep/study.hpp"

namespace study {

/// Returns: what write_results() writes there.
std::vector<std::filesystem::path> result_files(const std::filesystem::path& folder);

/// Writes the study, its tables and the pictures, and lists them on standard output.
/// Errors: render::FileError. Where there is no gnuplot the pictures are left out, with a message.
void write_results(const std::filesystem::path& folder, const Study& study);

/// Returns: what write_shard() writes there, shard-I-of-N.json.
std::filesystem::path shard_file(const std::filesystem::path& folder, const Shard& shard);

/// Writes one shard of a study, for `merge`. Errors: render::FileError.
void write_shard(const std::filesystem::path& folder, const Study& study);

/// Errors: StudyError; walkthroughs::InputError where it is not a regular file, or a far too large one.
Study read_study(const std::filesystem::path& file);

}  // namespace study
