/// What the diagrams share: frames, points.
#pragma once

#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs {

/// Returns: `box` cut into `count` frames of equal width, side by side.
std::vector<render::Box> side_by_side(const render::Box& box, int count);

void draw_point(render::Panel& panel, const render::Vec2& at, render::Color color, const Style& style);
/// A ring, for a point that is not the one meant.
void draw_hollow_point(render::Panel& panel, const render::Vec2& at, render::Color color, const Style& style);
void draw_origin(render::Panel& panel, const Style& style);

/// Returns: "12,345".
std::string with_commas(std::size_t count);

}  // namespace walkthroughs
