/// Colours, and the palette of the pictures.
#pragma once

#include <cstdint>

namespace render {

/// 8-bit sRGB with straight (not premultiplied) alpha; blending happens on the sRGB values.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;

  constexpr Color with_alpha(std::uint8_t alpha) const { return {r, g, b, alpha}; }
  friend bool operator==(const Color&, const Color&) = default;
};

/// The colour-blind-safe palette of Okabe and Ito (2008). On white, blue, vermillion, green and black carry lines;
/// orange and sky are fills and need a dark outline. Nothing may be told by colour alone.
namespace palette {
inline constexpr Color white{255, 255, 255};
inline constexpr Color black{0, 0, 0};
inline constexpr Color ink{34, 34, 34};       // text and outlines
inline constexpr Color grey{110, 110, 110};   // secondary text: contrast 5.1 on white
inline constexpr Color faint{222, 222, 222};  // grid lines
inline constexpr Color blue{0, 114, 178};
inline constexpr Color vermillion{213, 94, 0};
inline constexpr Color green{0, 158, 115};
inline constexpr Color orange{230, 159, 0};
inline constexpr Color sky{86, 180, 233};
}  // namespace palette

}  // namespace render
