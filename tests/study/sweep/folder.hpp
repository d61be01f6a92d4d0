/// Folders for what the study writes.
#pragma once

#include <filesystem>
#include <system_error>

#include "render/file.hpp"

namespace study {

/// Makes sure that the folder is there and can be written to. Errors: render::FileError.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw render::FileError("cannot make the folder '" + folder.string() + "': " + error.message() +
                            "; name another, or make room for it");
  render::expect_writable(folder);
}

}  // namespace study
