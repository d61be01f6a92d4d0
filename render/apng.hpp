/// Animated PNG: pictures of one size, each with the time for which it is shown.
///
/// A viewer that knows nothing of animation shows the first picture. The format is that of the PNG specification, third
/// edition: https://www.w3.org/TR/png-3/
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "render/image.hpp"

namespace render {

/// Returns: a file that runs through `count` pictures for ever. `png` is asked once for each, in order, for what encode_png()
/// returned; `seconds` for how long it is shown, rounded to milliseconds (above a minute: to hundredths).
/// Requires: count >= 1; 0 <= seconds <= 600.
/// Errors: std::invalid_argument where a picture has not the size of the first one.
std::vector<std::uint8_t> encode_apng(std::size_t count,
                                      const std::function<std::vector<std::uint8_t>(std::size_t index)>& png,
                                      const std::function<double(std::size_t index)>& seconds, const PngText& text);

}  // namespace render
