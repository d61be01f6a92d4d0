/// The panels of a frame: the objects, and the difference set with the search in it. Scenes lie in the plane z = 0.
#pragma once

#include <string>

#include "render/panel.hpp"
#include "walkthroughs/storyboard.hpp"

namespace walkthroughs {

/// The smallest box of scene units that holds what a panel must show.
struct Bounds {
  render::Vec2 low, high;
};

Bounds bounds_of_objects(const Scene& scene);
/// Of the whole difference and the origin.
Bounds bounds_of_difference(const LabelledHull& hull);
/// Of the move that `now` has found, the origin, and the search direction drawn from there.
Bounds bounds_of_move(const Moment& now);

/// Where a panel stands on the page: its title and its key on top, the scene below.
struct Place {
  render::Box frame;
  std::string title;
  render::View view;
};

/// Returns: the part of `frame` below the title.
render::Box below_title(const render::Box& frame);

// Each returns how many labels could not be kept clear of lines and of each other.

/// The two objects, the support points and the directions in which they are farthest.
int draw_objects(render::Canvas& canvas, const Place& place, const Scene& scene, const Moment& now, Focus focus);

/// The labelled hull, the origin, the simplex with the segments that GJK added, and what `focus` asks for.
int draw_difference(render::Canvas& canvas, const Place& place, const LabelledHull& hull, const Moment& now,
                    Focus focus);

/// The same, reduced to one move: where it started, where it ended, d and the vector from the origin (Figure 5).
int draw_move(render::Canvas& canvas, const Place& place, const LabelledHull& hull, const Moment& now, Focus focus);

}  // namespace walkthroughs
