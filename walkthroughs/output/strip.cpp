#include "walkthroughs/output/strip.hpp"

namespace walkthroughs {

void Strip::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  const Walkthrough& w = story->walkthrough;
  render::Canvas canvas = renderer.canvas(strip_page(*story, output.look), output);
  draw_strip(canvas, *story, output.look);
  renderer.write(folder_of(output, w) / "strip.png", renderer.draw(canvas), {w.title, w.summary},
                 [written = written_, story](const std::filesystem::path& file) { written(file, *story); });
}

}  // namespace walkthroughs
