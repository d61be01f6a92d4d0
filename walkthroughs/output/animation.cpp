#include "walkthroughs/output/animation.hpp"

#include "render/apng.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"

namespace walkthroughs {

void AnimatedPng::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  renderer.then([story, folder = folder_of(output, story->walkthrough), seconds = seconds_, written = written_] {
    render::Animation animation({story->walkthrough.title, story->walkthrough.summary});
    const std::size_t count = story->frames.size();
    for (std::size_t i = 0; i < count; ++i)
      animation.add(written_picture(folder, i), seconds * (i + 1 == count ? last_frame_times : 1));
    write_output(folder / "animation.png", animation.bytes());
    written(folder / "animation.png", *story);
  });
}

}  // namespace walkthroughs
