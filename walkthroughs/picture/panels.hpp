/// The panels of a search.
#pragma once

#include <string>

#include "render/panel.hpp"
#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/picture/style.hpp"
#include "walkthroughs/story/decision.hpp"
#include "walkthroughs/story/number_line.hpp"

namespace walkthroughs::picture {

/// Where a panel stands on the page: its title and its key on top, the scene below.
struct Place {
  render::Box frame;
  std::string title;
  render::View view;
};

/// What is shown, and how it is looked at.
struct Shown {
  const Telling& telling;
  const Stage& stage;
  const Moment& now;
  const Names& names;
  Focus focus;
  const Lens& lens;
  const Style& style;
  bool values = true;            ///< whether numbers that decide are written into the picture
  bool regions_beside = false;   ///< whether pictures of planes beside this one show the regions
  bool is_parting = false;       ///< whether another search goes another way here
  const Stage& framing = stage;  ///< that the picture is as large as,
  double zoom = 1;               ///< or so many times as large
  bool grips = false;            ///< whether the canvas is told what can be taken hold of

  /// Returns: the same, drawn with another style, which must outlive it.
  Shown in(const Style& other) const {
    return {telling, stage, now, names, focus, lens, other, values, regions_beside, is_parting, framing, zoom, grips};
  }
};

/// A grip that moves nothing: where the origin of a difference is drawn, through which one knows where all of it is. One for each
/// scene; the names of those of plane pictures begin so, too.
inline constexpr const char* difference_grip = "difference";
/// Returns: the name of that of a triangle's plane, straight down its normal, or seen edge-on.
inline std::string difference_grip_of(const gjk::Roles& face, bool is_edge_on) {
  return difference_grip + std::string(is_edge_on ? " edge-on " : " flat ") + to_string(face);
}

render::Box bounds_of_objects(const Stage& stage, const Lens& lens);

/// The two objects, the support points and the directions in which they are farthest.
void draw_objects(render::Canvas& canvas, const Place& place, const Shown& shown);

/// Of the whole difference, of everything that the search finds in it, and the origin.
render::Box bounds_of_difference(const Stage& stage, const Lens& lens);
/// Of the simplex that is being processed and the origin, with room for the regions around.
render::Box bounds_of_decision(const Moment& now, const Lens& lens);
/// Of the move that `now` has found, the origin, and the search direction drawn from there.
render::Box bounds_of_move(const Moment& now, const Lens& lens);

/// The difference, the origin, the simplex with the segments that GJK added, and what the focus asks for.
void draw_difference(render::Canvas& canvas, const Place& place, const Shown& shown);
/// The same, reduced to one move: where it started, where it ended, d and the vector from the origin (Figure 5).
void draw_move(render::Canvas& canvas, const Place& place, const Shown& shown);

/// The plane pictures of a decision in space. Requires: at least one view, those of `shown.now`.
void draw_decision(render::Canvas& canvas, const render::Box& frame, const std::vector<DecisionView>& views,
                   const Shown& shown);

/// Of a proof or of a sign in doubt: its numbers on a line, to scale, beside what rounding may have made. Words stand where no
/// line is.
void draw_number_line(render::Canvas& canvas, const render::Box& frame, const NumberLine& line, const Shown& shown);

/// The pseudo-code that is running, the values of its tests so far, and the line where it is.
void draw_algorithm(render::Canvas& canvas, const render::Box& frame, const Shown& shown);

}  // namespace walkthroughs::picture
