/// Another program as a filter.
#pragma once

#include <optional>
#include <string>

namespace study {

/// Runs `program`, found as a shell finds it, on `input`. It ends at the latest with this process, however that is ended, and
/// has no file to leave behind: what it makes it writes to its standard output.
/// Requires: it reads all of `input` before it writes much.
///
/// Returns: what it wrote; nothing where it is not there or failed.
std::optional<std::string> filtered(const std::string& program, const std::string& input);

}  // namespace study
