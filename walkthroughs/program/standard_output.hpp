/// Standard output and input as pipes, files and terminals: all of it is written, or there is an error that says why not.
#pragma once

#include <string_view>

#include "render/file.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::program {

/// A pipe may have been set, by another program that holds it, to fail rather than wait (O_NONBLOCK).
/// Returns: whether errno says so; then it has waited for `event` of poll(). Keeps errno.
bool wait_for(int descriptor, short event);

/// Who read standard output has left, as head does. Nobody is told: it was his choice.
struct ReaderLeft : render::FileError {
  ReaderLeft() : FileError("nobody reads standard output any more") {}
};

/// Errors: render::FileError, ReaderLeft among them.
void write_to_standard_output(std::string_view text);

}  // namespace walkthroughs::program
