/// Whole files in, whole files out; and how much memory there is for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
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

/// The largest file that is written or read: a program that reads files whole must not be asked for all of the memory.
inline constexpr std::uintmax_t max_file_bytes = std::uintmax_t{1} << 30;

/// Writes beside `path` and puts in place what is whole, so that a run that is interrupted or killed leaves either the old
/// file or the whole new one. Beside it, if that happens in the moment of replacing, one `path`.unfinished, which the next
/// write to `path` removes; and, where the file system knows no files without a name (NFS, FAT), one `path`.N.unfinished.
/// Errors: FileError, also where `path` is a folder or a device, and where there are more than max_file_bytes; no
/// temporary file is left behind.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Errors: FileError where write_file() would surely fail: `path` is a folder or a device, or no file can be made beside it;
/// none is left behind.
void expect_writable(const std::filesystem::path& path);

/// Makes sure that the folder is there and can be written to. Errors: FileError, which says `what_to_do`.
void make_folder(const std::filesystem::path& folder, const std::string& what_to_do);

/// Errors: ReadError, also where `path` is no regular file, such as a pipe or a device, which may never end, and where it
/// is larger than `most` bytes. Reads no more, and waits for nobody.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uintmax_t most = max_file_bytes);

/// Returns: the first bytes of the file, `most` of them at most. Errors: ReadError, also where it is no regular file.
std::vector<std::uint8_t> read_beginning(const std::filesystem::path& path, std::size_t most);

/// Returns: how much memory `ulimit -v` allows and that more may help, as the end of a message about what failed for want
/// of memory; nothing where it allows any amount.
std::string memory_limit();

}  // namespace render
