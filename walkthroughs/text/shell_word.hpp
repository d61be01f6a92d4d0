/// Paths in commands that readers may copy.
#pragma once

#include <string>
#include <string_view>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text {

/// Returns: `text` as one word of a POSIX shell, which has nothing but line breaks that a terminal would act upon or not show.
std::string shell_quoted(std::string_view text);

/// Returns: `path` as one word of a shell, and not an option.
std::string shell_word(const std::string& path);

}  // namespace walkthroughs::text
