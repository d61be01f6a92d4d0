/// The files that a study leaves in a folder.
#pragma once

#include <filesystem>

#include "tests/study/sweep/study.hpp"

namespace study {

/// Writes study.json, study.csv, timings.csv, tables.md, errors.md, settings.md, timings.md and the
/// pictures, and lists them on standard output.
/// Errors: render::FileError. Where there is no gnuplot the pictures are left out, with a message.
void write_results(const std::filesystem::path& folder, const Study& study);

/// Writes shard-I-of-N.json, for `merge`. Errors: render::FileError.
void write_shard(const std::filesystem::path& folder, const Study& study);

/// Errors: StudyError; walkthroughs::InputError where it is not a regular file, or a far too large one.
Study read_study(const std::filesystem::path& file);

}  // namespace study
