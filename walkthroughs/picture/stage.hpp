/// What pictures of a story need beside it: hulls and cameras, computed once.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "walkthroughs/picture/body.hpp"
#include "walkthroughs/picture/lens.hpp"
#include "walkthroughs/picture/placing.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::picture {

/// One scene of a story, ready to be drawn. Panels that were not asked for leave their part empty.
struct Stage {
  const Telling* telling;  ///< as it is drawn
  Placing placing;
  Body a, b, difference;
  Lens lens;
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
