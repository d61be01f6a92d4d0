/// Sizes of pictures, as users write them.
#pragma once

#include <optional>
#include <string_view>

#include "render/geometry.hpp"

namespace walkthroughs {

/// Returns: what "1280x720" says; nothing for other texts and for sizes that cannot be drawn.
std::optional<render::Size> size_in(std::string_view text);

}  // namespace walkthroughs
