/// The panel of a proof or of a sign in doubt: its numbers on a line, to scale, beside what rounding may have made.
#pragma once

#include "walkthroughs/picture/shown.hpp"
#include "walkthroughs/story/number_line.hpp"

namespace walkthroughs {

/// Returns: 0; its words stand where no line is.
int draw_number_line(render::Canvas& canvas, const render::Box& frame, const NumberLine& line, const Shown& shown);

}  // namespace walkthroughs
