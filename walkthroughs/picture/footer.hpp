/// What is written below the panels of a frame: how far the story is, the caption, and the numbers that decide.
#pragma once

#include <cstddef>

#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

/// Draws it into `room`, the facts smaller where there are many.
/// Returns: how many lines there was no room for.
int draw_footer(render::Canvas& canvas, const render::Box& room, const StagedStory& story, std::size_t index,
                const Style& style);

/// Draws the same words, without the number of frames, in one column that begins at the top left corner of the page, each at
/// its full size.
/// Returns: how high the column is.
double draw_words(render::Canvas& canvas, double width, const StagedStory& story, std::size_t index,
                  const Style& style);

}  // namespace walkthroughs::picture
