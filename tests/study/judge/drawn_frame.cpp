#include "tests/study/judge/drawn_frame.hpp"

#include "walkthroughs/picture/draw.hpp"

namespace study {
namespace {

/// Where two runs part, or the end.
std::size_t telling_frame(const walkthroughs::story::Story& story) {
  return story.parting().value_or(story.frames.size() - 1);
}

}  // namespace

render::Image FrameDrawing::operator()(const walkthroughs::story::Story& story) {
  const walkthroughs::picture::StagedStory staged(story);
  const walkthroughs::picture::Look look;
  render::Canvas canvas({960, 540}, walkthroughs::picture::frame_page, look.style.theme.paper, studio_.font);
  walkthroughs::picture::draw_frame(canvas, staged, telling_frame(story), look);
  return studio_.rasterizer.draw(canvas);
}

}  // namespace study
