/// Files that users name, read whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace walkthroughs {

/// A file that a user named cannot be read. what(): "FILE:LINE: KEY: reason; what to do". LINE is missing where the file
/// itself is at fault, KEY where the text as a whole is.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct TextFile {
  std::string kind;   ///< as an error calls it: "scene file"
  std::size_t bytes;  ///< at most so many
};

/// Errors: InputError unless `file` is a regular file that can be read and is no larger than expected. Reads no more.
std::string read_text(const std::filesystem::path& file, const TextFile& expected);

}  // namespace walkthroughs
