/// Paths in commands that readers may copy.
#pragma once

#include <filesystem>
#include <string>

namespace walkthroughs {

/// Returns: `text` as one word of a shell.
std::string shell_quoted(const std::string& text);

/// Returns: `path` as one word of a shell, and not an option.
std::string shell_word(const std::filesystem::path& path);

}  // namespace walkthroughs
