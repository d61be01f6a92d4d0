/// Files that users name, read whole or in parts. "-" is standard input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/file.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs::text {

/// A file that a user named cannot be read. what(): "FILE:LINE: KEY: reason; what to do", without KEY where the text as a whole is at
/// fault; where the file itself is, as render::read_file() says.
using InputError = render::ReadError;

inline bool is_standard_input(const std::filesystem::path& file) { return file == "-"; }

/// Returns: the file as messages call it.
inline std::string called(const std::filesystem::path& file) {
  return is_standard_input(file) ? "standard input" : file.string();
}

/// Errors: InputError unless `file` is a regular file, or standard input, that can be read and has no more than `most` bytes.
/// Reads no more.
std::string read_text(const std::filesystem::path& file, std::size_t most);

/// A regular file, or standard input, that is read in parts.
class OpenFile {
 public:
  /// Errors: InputError, also where it is another kind of file.
  explicit OpenFile(const std::filesystem::path& file);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Waits where there is nothing yet. Returns: how many bytes there were; 0 at the end. Errors: InputError.
  std::size_t read_some(std::span<char> bytes) const;

 private:
  const std::filesystem::path file_;
  const int descriptor_;
};

/// Returns: what was read from the text of a file of that name. Errors: InputError, where something is wrong with it.
template <class T>
T accepted(Reading<T> reading, const std::string& file_name) {
  if (const auto& complaint = reading.complaint)
    throw InputError(file_name + ":" + std::to_string(complaint->line) + ": " + complaint->text());
  return std::move(reading.value);
}

}  // namespace walkthroughs::text
