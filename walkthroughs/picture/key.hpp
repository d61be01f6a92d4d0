/// The signs that a panel's key explains.
#pragma once

#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/story/decision.hpp"

namespace walkthroughs {

KeyEntry key_of_line(const std::string& text, const render::Stroke& stroke);
KeyEntry key_of_newest(const Style& style);
/// An area with the supporting line, or plane, as its border.
KeyEntry key_of_out_of_reach(const std::string& text, const Style& style);
KeyEntry key_of_skipped(const Style& style);
/// The origin above a face and below it; in its plane only where one of the views shows that.
std::vector<KeyEntry> key_of_origin(const std::vector<DecisionView>& views, const Style& style);

/// Draws the origin as the key has it: filled above the plane, a dot in it, a ring below.
void draw_origin_beside(render::Panel& panel, const render::Vec2& at, double height, const Style& style);

}  // namespace walkthroughs
