/// The panels of a frame: the objects, the difference set with the search in it, and the algorithm that is running.
///
/// Each function that draws returns how many labels could not be kept clear of lines and of each other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs {

/// The smallest box of the picture that holds what a panel must show.
struct Bounds {
  render::Vec2 low, high;
};

Bounds bounds_of_objects(const Telling& telling, const Lens& lens);
/// Of the whole difference, of everything that the search finds in it, and the origin.
Bounds bounds_of_difference(const Telling& telling, const Lens& lens);
/// Of the simplex that is being processed and the origin, with room for the regions around.
Bounds bounds_of_decision(const Moment& now, const Lens& lens);
/// Of the move that `now` has found, the origin, and the search direction drawn from there.
Bounds bounds_of_move(const Moment& now, const Lens& lens);

/// Where a panel stands on the page: its title and its key on top, the scene below.
struct Place {
  render::Box frame;
  std::string title;
  render::View view;
};

/// Returns: the part of `frame` below the title.
render::Box below_title(const render::Box& frame);

/// What is shown, and how it is looked at.
struct Shown {
  const Telling& telling;
  const Moment& now;
  const Names& names;
  Focus focus;
  const Lens& lens;
  const Style& style;
};

/// The two objects, the support points and the directions in which they are farthest.
int draw_objects(render::Canvas& canvas, const Place& place, const Shown& shown);

/// The difference, the origin, the simplex with the segments that GJK added, and what the focus asks for.
int draw_difference(render::Canvas& canvas, const Place& place, const Shown& shown);

/// The same, reduced to one move: where it started, where it ended, d and the vector from the origin (Figure 5).
int draw_move(render::Canvas& canvas, const Place& place, const Shown& shown);

/// The pseudo-code that is running, the values of its tests so far, and the line where it is.
void draw_algorithm(render::Canvas& canvas, const render::Box& frame, const Shown& shown);

// -- For the panels themselves ----------------------------------------------------------------------------------------

/// A sign of a key and what it stands for; `draw` gets the middle of the sign.
struct KeyEntry {
  std::string text;
  std::function<void(render::Canvas&, const render::Vec2&)> draw;
};

/// Draws the frame of a panel, its title at the left and at the right as much of its key as there is room for.
void draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                      const std::vector<KeyEntry>& key, const Style& style);

}  // namespace walkthroughs
