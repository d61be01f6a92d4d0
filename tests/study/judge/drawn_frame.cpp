#include "tests/study/judge/drawn_frame.hpp"

#include "walkthroughs/picture/draw.hpp"

namespace study {
namespace {

/// Where two runs part, or the end.
std::size_t telling_frame(const walkthroughs::Story& story) {
  return story.parting().value_or(story.frames.size() - 1);
}

}  // namespace

render::Image FrameDrawing::operator()(const walkthroughs::Story& story) {
  const walkthroughs::StagedStory staged(story);
  const walkthroughs::Look look;
  render::Canvas canvas({960, 540}, walkthroughs::frame_page, look.style.theme.paper, studio_.font);
  walkthroughs::draw_frame(canvas, staged, telling_frame(story), look);
  return studio_.rasterizer.draw(canvas);
}

}  // namespace study
