/// The frame of a panel, with its title and its key.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/canvas.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs {

/// Returns: the part of `frame` below the title.
render::Box below_title(const render::Box& frame, const Style& style);

/// A sign of a key and what it stands for; `draw` gets the middle of the sign.
struct KeyEntry {
  std::string text;
  std::function<void(render::Canvas&, const render::Vec2&)> draw;
  double half_width = 15;         ///< of the sign, in page units
  bool may_be_shortened = false;  ///< a name that may be of any length: its sign is shown always
};

/// Draws the frame of a panel, its title at the left and at the right as much of its key as there is room for. Where text is
/// larger than usual the title gives way to a key that could hardly be read beside it.
/// Returns: the room below the title.
render::Box draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                             const Style& style, const std::vector<KeyEntry>& key = {});

}  // namespace walkthroughs
