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

/// Beyond the larger one there would be no room for pictures beside their text.
inline constexpr double least_text_scale = 0.75, most_text_scale = 1.5;

/// The colours and weights that pictures are drawn with. Drawing code names what a colour is for, not the colour.
/// On the paper of every theme ink, grey and blue have a contrast of at least 4.5 (WCAG 2, text of any size), vermillion
/// and green of at least 3 (large text and lines): on white, Okabe and Ito's vermillion has 3.9 and their green 3.4.
struct Theme {
  Color paper = palette::white;
  Color ink = palette::ink;
  Color grey = palette::grey;    ///< secondary text and outlines
  Color faint = palette::faint;  ///< grid lines and frames
  Color blue = palette::blue, vermillion = palette::vermillion,
        green = palette::green;                        ///< lines, large text and fills
  Color orange = palette::orange, sky = palette::sky;  ///< fills with an outline
  double line = 1;                                     ///< factor for line widths
  double text = 1;                                     ///< factor for all text, in that range
};

namespace themes {
inline constexpr Theme report;  ///< on white paper
/// For a projector: stronger lines, larger text.
inline constexpr Theme slides{
    .ink = palette::black, .grey = {80, 80, 80}, .faint = {205, 205, 205}, .line = 1.4, .text = 1.25};
/// On a dark ground; the colours are lightened until each has a contrast of at least 4.5 there.
inline constexpr Theme dark{.paper = {22, 25, 31},
                            .ink = {240, 240, 240},
                            .grey = {170, 175, 182},
                            .faint = {58, 63, 72},
                            .blue = {98, 182, 240},
                            .vermillion = {255, 138, 76},
                            .green = {52, 205, 158},
                            .orange = {240, 180, 60},
                            .sky = {86, 180, 233}};
}  // namespace themes

}  // namespace render
