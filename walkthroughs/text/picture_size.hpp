/// Sizes of pictures, as users write them.
#pragma once

#include <optional>
#include <string_view>

#include "render/geometry.hpp"

namespace walkthroughs {

/// Returns: whether a picture can be drawn so large and so small.
bool is_size(const render::Size& size);

/// Returns: what "1280x720" says; nothing for other texts and for sizes that cannot be drawn.
std::optional<render::Size> size_in(std::string_view text);

}  // namespace walkthroughs
