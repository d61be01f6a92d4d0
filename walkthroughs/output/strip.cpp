#include "walkthroughs/output/strip.hpp"

namespace walkthroughs {

void Strip::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  const Walkthrough& w = story->walkthrough;
  const auto paint = [&](render::Canvas& canvas) { draw_strip(canvas, *story, output.look); };
  renderer.write(folder_of(output, w) / "strip.png", renderer.draw(strip_page(*story, output.look), output, paint),
                 {w.title, w.summary},
                 [written = written_, story](const std::filesystem::path& file) { written(file, *story); });
}

}  // namespace walkthroughs
