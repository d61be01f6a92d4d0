/// The panel of a decision in space: its plane pictures.
#pragma once

#include "walkthroughs/picture/shown.hpp"
#include "walkthroughs/story/decision.hpp"

namespace walkthroughs {

/// Requires: at least one view, those of `shown.now`.
int draw_decision(render::Canvas& canvas, const render::Box& frame, const std::vector<DecisionView>& views,
                  const Shown& shown);

}  // namespace walkthroughs
