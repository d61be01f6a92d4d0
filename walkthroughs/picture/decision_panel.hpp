/// The panel of a decision in space: its plane pictures.
#pragma once

#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/shown.hpp"
#include "walkthroughs/story/decision.hpp"

namespace walkthroughs {

/// Requires: at least one view, those of `shown.now`.
int draw_decision(render::Canvas& canvas, const render::Box& frame, const std::vector<DecisionView>& views,
                  const Shown& shown);

/// Draws the origin as it lies to the plane of a triangle: filled above it, on the side of the normal, hollow below, a
/// ring around a dot in it.
void draw_origin_beside(render::Panel& panel, const render::Vec2& at, double height, const Style& style);

/// The signs of these, for the key of a panel; that of the plane itself where one of the views needs it.
std::vector<KeyEntry> key_of_origin(const std::vector<DecisionView>& views, const Style& style);

}  // namespace walkthroughs
