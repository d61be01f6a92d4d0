/// Standard output and input as pipes, files and terminals: all of it is written, or there is an error that says why not.
#pragma once

#include <streambuf>
#include <string>
#include <string_view>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::program {

/// A pipe may have been set, by another program that holds it, to fail rather than wait (O_NONBLOCK).
/// Returns: whether errno says so; then it has waited for `event` of poll(). Keeps errno.
bool wait_for(int descriptor, short event);

/// Errors: render::FileError.
void write_to_standard_output(std::string_view text);

/// What std::cout writes to as long as this lives. Where it cannot, the next insertion or flush that needs it throws a
/// render::FileError, so that a command ends when nobody reads what it says; what is left then is thrown away.
class StandardOutput : public std::streambuf {
 public:
  StandardOutput();
  /// Writes what is left if it can.
  ~StandardOutput() override;
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  /// Writes what is left if it can; what cannot be written, now and later, is thrown away without a word.
  void finish() noexcept;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* letters, std::streamsize count) override;
  int sync() override;

 private:
  void write();

  std::string text_;
  std::streambuf* const before_;
  const bool is_terminal_;  ///< which shows each line at once
};

}  // namespace walkthroughs::program
