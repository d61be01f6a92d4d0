#include "walkthroughs/program/standard_output.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>
#include <utility>

#include "render/file.hpp"

namespace walkthroughs::program {
namespace {

std::string what_to_do(int error_number) {
  switch (error_number) {
    case EPIPE: return "who reads it has left before the end; let it read all";
    case ENOSPC:
    case EDQUOT: return "make room on the disk, or write to another one";
    default: return "check where the output goes";
  }
}

[[noreturn]] void fail_to_write(int error_number) {
  throw render::FileError(std::string("cannot write to standard output: ") + std::strerror(error_number) + "; " +
                          what_to_do(error_number));
}

}  // namespace

bool wait_for(int descriptor, short event) {
  const int reason = errno;
  pollfd polled{descriptor, event, 0};
  const bool waits = reason == EAGAIN || reason == EWOULDBLOCK;
  if (waits) ::poll(&polled, 1, -1);
  errno = reason;
  return waits;
}

void write_to_standard_output(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && wait_for(STDOUT_FILENO, POLLOUT)) continue;
    if (count < 0) fail_to_write(errno);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

StandardOutput::StandardOutput() : before_(std::cout.rdbuf(this)), is_terminal_(::isatty(STDOUT_FILENO) != 0) {
  std::cout.exceptions(std::ios::badbit);
}

StandardOutput::~StandardOutput() {
  finish();
  std::cout.rdbuf(before_);
}

void StandardOutput::finish() noexcept {
  std::cout.exceptions(std::ios::goodbit);
  try {
    write();
  } catch (const std::exception&) {
  }
}

StandardOutput::int_type StandardOutput::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char one = traits_type::to_char_type(letter);
  return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize StandardOutput::xsputn(const char* letters, std::streamsize count) {
  constexpr std::size_t enough = 1 << 16;
  const std::string_view added(letters, static_cast<std::size_t>(count));
  text_ += added;
  const bool ends_line = is_terminal_ && added.find('\n') != std::string_view::npos;
  if (ends_line || text_.size() >= enough) write();
  return count;
}

int StandardOutput::sync() {
  write();
  return 0;
}

void StandardOutput::write() { write_to_standard_output(std::exchange(text_, {})); }

}  // namespace walkthroughs::program
