/// Whole files in, whole files out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace render {

/// A file could not be read or written; what() says which, why, and what to do.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be read, or is not what it should be.
struct ReadError : FileError {
  using FileError::FileError;
};

/// Writes beside `path` and puts in place what is whole, so that an interrupted run leaves either the old file or the whole
/// new one, and nothing else where the file system knows files without a name (NFS and FAT do not).
/// Errors: FileError, also where `path` is a folder or a device; no temporary file is left behind.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Errors: ReadError.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

}  // namespace render
