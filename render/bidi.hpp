/// Text that runs from right to left.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace render {

/// Text as it is drawn from left to right.
struct VisualText {
  std::u32string codes;
  std::vector<std::size_t> from;  ///< for each of them its place in the text as it was written
};

/// The bidirectional algorithm of Unicode, by FriBidi, which also joins Arabic letters. A text begins on the side on which
/// its first letter does.
/// Returns: text without letters that run from right to left as it is.
VisualText visual(const std::u32string& text);

}  // namespace render
