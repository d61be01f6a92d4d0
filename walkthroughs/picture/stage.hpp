/// What pictures of a story need beside it, computed once: where its scenes are put, hulls and cameras.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "walkthroughs/picture/body.hpp"
#include "walkthroughs/picture/lens.hpp"
#include "walkthroughs/picture/surface_crossing.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::picture {

/// Where a scene is put before it is drawn.
///
/// Pictures are computed in doubles, with products of up to four lengths. Scenes may lie so far from the origin that nothing
/// is left of their size, or be so large or small that such products overflow or vanish. These are drawn moved and scaled;
/// what is said of them, in captions and panels, keeps the scene's own numbers.
struct Placing {
  double scale = 1;              ///< a power of two, so that nothing is rounded
  Point center = Point::Zero();  ///< of the objects, which is moved to the origin; their difference stays where it is

  friend bool operator==(const Placing&, const Placing&) = default;
  bool moves() const { return scale != 1 || !center.isZero(0); }
  Scene placed(Scene scene) const;
  Trace placed(Trace trace) const;
  LabelledHull placed(LabelledHull hull) const;
};

/// Returns: one for all scenes of a story; one that leaves everything where it is, unless that matters.
Placing placing_of(const std::vector<Telling>& tellings);

/// One scene of a story, ready to be drawn. Panels that were not asked for leave their part empty.
struct Stage {
  const Telling* telling;  ///< as it is drawn
  Placing placing;
  Body a, b, difference;
  Lens lens;
  std::vector<CrossingPiece> crossing = {};  ///< of the objects, in space
};

/// A story that is ready to be drawn.
struct StagedStory : Story {
  explicit StagedStory(Story story);
  StagedStory(StagedStory&&) = default;
  StagedStory(const StagedStory&) = delete;  // stages point into what it holds

  std::vector<Stage> stages;  ///< one for each of `tellings`

  /// Returns: what the pictures leave out, and why: a sentence each, for who asked for them.
  std::vector<std::string> left_out() const;

  /// Returns: the moment that a frame shows of a scene, as it is drawn.
  Moment drawn(std::size_t frame, std::size_t scene) const;

 private:
  std::deque<Scene> placed_scenes_;  // that do not move when more come, as the next
  std::deque<Telling> placed_tellings_;
};

}  // namespace walkthroughs::picture
