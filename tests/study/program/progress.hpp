/// Tells on standard error how far a sweep has come: in place on a terminal, else in a line now and then.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>

namespace study {

class ProgressLine {
 public:
  void operator()(std::uint64_t done, std::uint64_t all) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_ && done < all) return;
    next_ = now + (is_terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(15));
    const double part = static_cast<double>(done) / static_cast<double>(all);
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::fprintf(stderr, "%s%llu of %llu pairs (%.0f %%), %.0f s, some %.0f s left%s", is_terminal_ ? "\r" : "",
                 static_cast<unsigned long long>(done), static_cast<unsigned long long>(all), 100 * part, seconds,
                 part > 0 ? seconds / part - seconds : 0.0, is_terminal_ && done < all ? "" : "\n");
  }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) == 1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), next_ = start_;
};

}  // namespace study
