/// What goes into HTML pages: texts of others, and bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace render {

class Image;

/// Returns: `text` to stand between tags, or in an attribute between double quotes: nothing in it is read as HTML.
std::string escaped(std::string_view text);

std::string base64(std::span<const std::uint8_t> bytes);

/// Returns: the URL of a PNG picture that holds the picture itself.
std::string data_url(std::span<const std::uint8_t> png);

/// Returns: the picture itself, of its own size.
std::string img(const Image& image, std::string_view alt);

}  // namespace render
