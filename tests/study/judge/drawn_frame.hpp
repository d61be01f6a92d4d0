/// One frame of a story, for pages.
#pragma once

#include "render/image.hpp"
#include "walkthroughs/output/renderer.hpp"
#include "walkthroughs/story/story.hpp"

namespace study {

/// What draws frames one after the other. Errors: render::ContextError, render::FontError.
class FrameDrawing {
 public:
  /// Requires: the story has frames. Returns: the one in which two searches part; the last where none do.
  render::Image operator()(const walkthroughs::story::Story& story);

 private:
  walkthroughs::output::Studio studio_;
};

}  // namespace study
