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

/// Writes beside `path` and puts in place what is whole, so that a run that is interrupted or killed leaves either the old
/// file or the whole new one. Beside it, if that happens in the moment of replacing, one `path`.unfinished, which the next
/// write to `path` removes; and, where the file system knows no files without a name (NFS, FAT), one `path`.N.unfinished.
/// Errors: FileError, also where `path` is a folder or a device; no temporary file is left behind.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Errors: ReadError.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

}  // namespace render
