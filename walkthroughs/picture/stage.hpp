/// What pictures of a story need beside it: hulls and cameras, computed once.
#pragma once

#include <vector>

#include "walkthroughs/picture/body.hpp"
#include "walkthroughs/picture/lens.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// One scene of a story, ready to be drawn. Panels that were not asked for leave their part empty.
struct Stage {
  Body a, b, difference;
  Lens lens;
};

/// A story that is ready to be drawn.
struct StagedStory : Story {
  explicit StagedStory(Story story);
  std::vector<Stage> stages;  ///< one for each of `tellings`
};

}  // namespace walkthroughs
