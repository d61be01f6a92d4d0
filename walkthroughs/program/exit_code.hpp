/// From failures to exit codes: the same for every program of the project.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::program {

enum ExitCode { ok = 0, unexpected = 1, wrong_usage = 2, bad_input = 3, no_context = 4, cannot_write = 5 };

/// The command line asks for something that there is not; what() says what there is instead.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs `run` and returns its exit code. What it throws is told on standard error, after the program's name, in one line
/// that shows what is not printable as escapes. `if_out_of_memory`: what to do then. A file that may not grow, and a reader
/// of what is printed who has left, are errors of writing, told like others; the latter ends `run`. So are
/// a thread that cannot be started, and a crash where memory is lacking: both are `unexpected`.
int exit_code_of(const std::string& program, const std::string& if_out_of_memory, const std::function<int()>& run);

}  // namespace walkthroughs::program
