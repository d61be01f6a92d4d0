/// How far the simplex is from the origin, iteration by iteration, as a small graph of its own.
#pragma once

#include <string>
#include <vector>

#include "render/canvas.hpp"
#include "walkthroughs/picture/style.hpp"
#include "walkthroughs/story/progress.hpp"

namespace walkthroughs::picture {

/// A search in the graph: only what is known of it is drawn. Axes fit all of it, so that they stay where they are.
struct ProgressLine {
  std::string name;
  const std::vector<Progress>& all;
  std::size_t known;
};

inline constexpr render::Size progress_page{420, 170};

/// Draws one search or two, of which the first is dashed and has square marks. Where a distance has come again, a thin line leads back
/// to where it was. Heights are powers of ten where distances span more than three of these; 0 then lies below them all.
/// Requires: a canvas with the page progress_page, in the colour of the paper.
void draw_progress(render::Canvas& canvas, const std::vector<ProgressLine>& lines, const Style& style);

}  // namespace walkthroughs::picture
