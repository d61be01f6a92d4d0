/// Folders for what the study writes.
#pragma once

#include <filesystem>
#include <system_error>

#include "render/file.hpp"

namespace study {

/// Errors: render::FileError.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw render::FileError("cannot make the folder " + folder.string() + ": " + error.message());
}

}  // namespace study
