/// Parts of HTML pages that have everything in them.
#pragma once

#include <string>

#include "render/image.hpp"

namespace render {

/// Returns: the text as it stands in a page, and in an attribute between quotes.
std::string escaped(const std::string& text);

/// Returns: the picture itself, of its own size.
std::string img(const Image& image, const std::string& alt);

}  // namespace render
