/// What is written below the panels of a frame: how far the story is, the caption, and the numbers that decide.
#pragma once

#include <cstddef>

#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs {

/// Draws it into `room`, the facts smaller where there are many.
/// Returns: how many lines there was no room for.
int draw_footer(render::Canvas& canvas, const render::Box& room, const StagedStory& story, std::size_t index,
                const Style& style);

}  // namespace walkthroughs
