/// Where what tests look at is.
#pragma once

#include <filesystem>

namespace kit {

/// Returns: the program as its users run it. Only tests that say so to CMake wait until it is built.
std::filesystem::path program();

/// Returns: a file or folder of the project, by its path from the top.
std::filesystem::path source(const std::filesystem::path& path);

/// Returns: a file or folder in the one that was built into.
std::filesystem::path built(const std::filesystem::path& path);

}  // namespace kit
