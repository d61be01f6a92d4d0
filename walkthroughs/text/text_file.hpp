/// Files that users name, read whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include "walkthroughs/text/document.hpp"

namespace walkthroughs::text {

/// A file that a user named cannot be read. what(): "FILE:LINE: KEY: reason; what to do", without KEY where the text as a whole is at
/// fault; where the file itself is, as render::read_file() says.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Errors: InputError unless `file` is a regular file that can be read and has no more than `most` bytes. Reads no more.
std::string read_text(const std::filesystem::path& file, std::size_t most);

/// Returns: what was read from the text of a file of that name. Errors: InputError, where something is wrong with it.
template <class T>
T accepted(Reading<T> reading, const std::string& file_name) {
  if (const auto& complaint = reading.complaint)
    throw InputError(file_name + ":" + std::to_string(complaint->line) + ": " + complaint->text());
  return std::move(reading.value);
}

}  // namespace walkthroughs::text
