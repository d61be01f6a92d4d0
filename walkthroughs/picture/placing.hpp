/// Where a scene is put before it is drawn.
///
/// Pictures are computed in doubles, with products of up to four lengths. Scenes may lie so far from the origin that nothing
/// is left of their size, or be so large or small that such products overflow or vanish. These are drawn moved and scaled;
/// what is said of them, in captions and panels, keeps the scene's own numbers.
#pragma once

#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::picture {

struct Placing {
  double scale = 1;              ///< a power of two, so that nothing is rounded
  Point center = Point::Zero();  ///< of the objects, which is moved to the origin; their difference stays where it is

  bool moves() const { return scale != 1 || !center.isZero(0); }
  Scene placed(Scene scene) const;
  Trace placed(Trace trace) const;
  LabelledHull placed(LabelledHull hull) const;
};

/// Returns: one for all scenes of a story; one that leaves everything where it is, unless that matters.
Placing placing_of(const std::vector<Telling>& tellings);

}  // namespace walkthroughs::picture
