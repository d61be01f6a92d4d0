/// Standard output and input as pipes, files and terminals: all of it is written, or there is an error that says why not.
#pragma once

#include <string_view>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::program {

/// A pipe may have been set, by another program that holds it, to fail rather than wait (O_NONBLOCK).
/// Returns: whether errno says so; then it has waited for `event` of poll(). Keeps errno.
bool wait_for(int descriptor, short event);

/// Errors: render::FileError.
void write_to_standard_output(std::string_view text);

}  // namespace walkthroughs::program
