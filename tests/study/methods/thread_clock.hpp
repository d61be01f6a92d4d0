/// How long this thread has computed, whatever else the machine does meanwhile.
#pragma once

#include <cerrno>
#include <chrono>
#include <ctime>
#include <system_error>

namespace study {

/// Stands still while the thread waits and while the processor serves others. Errors: std::system_error.
inline std::chrono::nanoseconds thread_time() {
  std::timespec time{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) != 0)
    throw std::system_error(errno, std::generic_category(), "the clock of the thread cannot be read");
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace study
