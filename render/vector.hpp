/// Canvases as lines, areas and letters that stay sharp however much they are enlarged: pages of a PDF file, or an SVG
/// picture.
///
/// There is no date in a file: same canvases, same bytes. Letters of a PDF file can be searched and copied. Those of an
/// SVG picture are outlines, so that it looks the same where the font is missing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/canvas.hpp"
#include "render/image.hpp"

namespace render {

/// In points, of which an inch has 72.
struct PaperSize {
  double width, height;
};

/// A part of a canvas on paper.
struct OnPaper {
  const Canvas* canvas;
  Box part;      ///< of its page, in page units
  Vec2 corner;   ///< of that part, the top left one, in points
  double scale;  ///< points per page unit
};
using PdfPage = std::vector<OnPaper>;

/// Returns: a PDF file of pages of that size and colour. Errors: FileError where there is no memory for it.
std::vector<std::uint8_t> encode_pdf(std::span<const PdfPage> pages, const PaperSize& paper, Color color,
                                     const PngText& text);

/// Returns: the canvas as an SVG file as large as its pixels, with title and description for who does not see it.
/// Errors: as encode_pdf().
std::vector<std::uint8_t> encode_svg(const Canvas& canvas, const PngText& text);

}  // namespace render
