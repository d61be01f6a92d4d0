/// Whole text files, and folders for them.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>

#include "render/file.hpp"

namespace study {

/// Errors: render::FileError.
inline void write_text(const std::filesystem::path& path, std::string_view text) {
  render::write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// Errors: render::FileError.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw render::FileError("cannot make the folder " + folder.string() + ": " + error.message());
}

}  // namespace study
