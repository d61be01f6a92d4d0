#include "walkthroughs/output/sink.hpp"

namespace walkthroughs::output {

OneFile strip() {
  const auto make = [](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    render::Canvas canvas = renderer.canvas(strip_page(*story, output.look), output);
    draw_strip(canvas, *story, output.look);
    return Renderer::png(renderer.draw(canvas), text_of(story->walkthrough));
  };
  return {"strip.png", make};
}

}  // namespace walkthroughs::output
