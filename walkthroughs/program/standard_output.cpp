#include "walkthroughs/program/standard_output.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace walkthroughs::program {
namespace {

std::string what_to_do(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT: return "make room on the disk, or write to another one";
    default: return "check where the output goes";
  }
}

[[noreturn]] void fail_to_write(int error_number) {
  if (error_number == EPIPE) throw ReaderLeft();
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

}  // namespace walkthroughs::program
