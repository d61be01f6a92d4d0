/// Files packed into one, as every system opens them.
#pragma once

#include <filesystem>
#include <vector>

namespace walkthroughs::output {

/// Writes `file`, a zip archive of these files, called as they are relative to `folder`. The same files make the same bytes. Errors:
/// render::FileError; then nothing is written.
void write_zip(const std::filesystem::path& file, const std::filesystem::path& folder,
               const std::vector<std::filesystem::path>& files);

}  // namespace walkthroughs::output
