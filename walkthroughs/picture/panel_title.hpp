/// The frame of a panel, with its title and its key, and the signs that a key explains.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

/// Returns: the part of `frame` below a title of one line, which no key makes smaller: pictures are fitted to it.
render::Box below_title(const render::Box& frame, const Style& style);

/// A sign of a key and what it stands for; `draw` gets the middle of the sign.
struct KeyEntry {
  std::string text;
  std::function<void(render::Canvas&, const render::Vec2&)> draw;
  double half_width = 15;         ///< of the sign, in page units
  bool may_be_shortened = false;  ///< a name that may be of any length
};

/// Draws the frame of a panel, its title, and its key: at the right of the title or, where that is too long, on lines below it,
/// over the margin of the picture. Letters get somewhat smaller before a line is broken. A name that is too long for a line
/// takes two, or ends in "…" where it has no space to be broken at.
/// Returns: the room that is left below.
render::Box draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                             const Style& style, const std::vector<KeyEntry>& key = {});

/// Returns: the view, fitted to what a key has left of the room below a title of one line.
render::View view_in(const render::Box& room, const render::Box& frame, const render::View& view, const Style& style);

// -- Signs --

KeyEntry key_of_line(const std::string& text, const render::Stroke& stroke);
KeyEntry key_of_newest(const Style& style);
/// An area with the supporting line, or plane, as its border.
KeyEntry key_of_out_of_reach(const std::string& text, const Style& style);
KeyEntry key_of_skipped(const Style& style);
/// What is drawn so many times as long as the rest, and which way: "heights ×8".
KeyEntry key_of_stretch(const std::string& what, const render::Vec2& way, double factor, const Style& style);
/// The origin above a face and below it, both, because one alone would be an answer; in its plane only where `height` is zero.
std::vector<KeyEntry> key_of_origin(double height, const Style& style);

/// Draws the origin as the key has it: filled above the plane, a dot in it, a ring below.
void draw_origin_beside(render::Panel& panel, const render::Vec2& at, double height, const Style& style);

}  // namespace walkthroughs::picture
