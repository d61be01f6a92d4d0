/// The frame of a panel, with its title and its key, and the signs that a key explains.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/style.hpp"
#include "walkthroughs/story/decision.hpp"

namespace walkthroughs::picture {

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

// -- Signs --

KeyEntry key_of_line(const std::string& text, const render::Stroke& stroke);
KeyEntry key_of_newest(const Style& style);
/// An area with the supporting line, or plane, as its border.
KeyEntry key_of_out_of_reach(const std::string& text, const Style& style);
KeyEntry key_of_skipped(const Style& style);
/// The origin above a face and below it; in its plane only where one of the views shows that.
std::vector<KeyEntry> key_of_origin(const std::vector<DecisionView>& views, const Style& style);

/// Draws the origin as the key has it: filled above the plane, a dot in it, a ring below.
void draw_origin_beside(render::Panel& panel, const render::Vec2& at, double height, const Style& style);

}  // namespace walkthroughs::picture
