/// A canvas as SVG text that a page shows as a part of itself. Letters are text in the page's own font, each run as wide as it is in
/// ours; so nothing moves where that font is another. Files that look the same everywhere are made by vector.hpp.
#pragma once

#include <string>

#include "render/canvas.hpp"

namespace render {

/// Returns: an element <svg> that shows `part` of the page, places to a hundredth of a page unit. Nothing in it has an id or a
/// style, so that it may stand in any page, several times. Requires: a canvas as large as its page.
std::string svg_text(const Canvas& canvas, const Box& part);

}  // namespace render
