/// The panel of the two objects.
#pragma once

#include "walkthroughs/picture/shown.hpp"

namespace walkthroughs {

Bounds bounds_of_objects(const Telling& telling, const Stage& stage, const Lens& lens);

/// The two objects, the support points and the directions in which they are farthest.
int draw_objects(render::Canvas& canvas, const Place& place, const Shown& shown);

}  // namespace walkthroughs
