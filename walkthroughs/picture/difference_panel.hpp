/// The panel of the difference, with the search in it.
#pragma once

#include "walkthroughs/picture/shown.hpp"

namespace walkthroughs {

/// Of the whole difference, of everything that the search finds in it, and the origin.
Bounds bounds_of_difference(const Telling& telling, const Stage& stage, const Lens& lens);
/// Of the simplex that is being processed and the origin, with room for the regions around.
Bounds bounds_of_decision(const Moment& now, const Lens& lens);
/// Of the move that `now` has found, the origin, and the search direction drawn from there.
Bounds bounds_of_move(const Moment& now, const Lens& lens);

/// The difference, the origin, the simplex with the segments that GJK added, and what the focus asks for.
int draw_difference(render::Canvas& canvas, const Place& place, const Shown& shown);

/// The same, reduced to one move: where it started, where it ended, d and the vector from the origin (Figure 5).
int draw_move(render::Canvas& canvas, const Place& place, const Shown& shown);

}  // namespace walkthroughs
