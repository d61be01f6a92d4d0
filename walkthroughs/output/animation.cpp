#include "render/image.hpp"
#include "walkthroughs/output/frames.hpp"

namespace walkthroughs::output {

OneFile animated_png(double seconds, double of_last) {
  const auto make = [=](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer&) {
    return [=, folder = folder_of(output, story->walkthrough)] {
      const std::size_t count = story->frames.size();
      const auto png = [&](std::size_t i) { return written_picture(folder, i); };
      const auto shown = [&](std::size_t i) { return i + 1 == count ? of_last : seconds; };
      return render::encode_apng(count, png, shown, text_of(story->walkthrough));
    };
  };
  return {"animation.png", make};
}

}  // namespace walkthroughs::output
