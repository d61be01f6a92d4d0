/// How much this process may have.
#pragma once

#include <string>

namespace render {

/// Returns: how much memory `ulimit -v` allows and that more may help, as the end of a message about what failed for want
/// of memory; nothing where it allows any amount.
std::string memory_limit();

}  // namespace render
