/// Letters of a line in the order in which they are drawn.
#pragma once

#include <vector>

namespace render {

enum class Level { baseline, subscript };

struct Character {
  char32_t code;
  Level level;
};

/// Returns: the text as it is drawn from left to right; without letters that run from right to left as it is.
std::vector<Character> in_visual_order(const std::vector<Character>& characters);

}  // namespace render
