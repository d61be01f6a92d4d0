/// The panel of the algorithm that is running.
#pragma once

#include "walkthroughs/picture/shown.hpp"

namespace walkthroughs {

/// The pseudo-code that is running, the values of its tests so far, and the line where it is.
void draw_algorithm(render::Canvas& canvas, const render::Box& frame, const Shown& shown);

}  // namespace walkthroughs
