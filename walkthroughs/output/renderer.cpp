#include "walkthroughs/output/renderer.hpp"

#include <algorithm>
#include <future>
#include <thread>

#include "render/file.hpp"
#include "render/image.hpp"
#include "walkthroughs/output/manifest.hpp"

namespace walkthroughs::output {

namespace fs = std::filesystem;

render::Size pixels_of(render::Size page, const Output& output) {
  if (page == frame_page) return output.size;
  const double scale = std::min({1.0 * output.size.width / frame_page.width,
                                 1.0 * output.size.height / frame_page.height, 1.0 * render::max_pixels / page.width});
  const auto pixels = [&](int units) { return std::max(render::min_pixels, static_cast<int>(units * scale)); };
  return {pixels(page.width), pixels(page.height)};
}

fs::path folder_of(const Output& output, const Walkthrough& walkthrough) {
  fs::path folder = output.folder / walkthrough.name;
  if (output.is_staged) folder /= stage_folder;
  render::make_folder(folder, "choose another with --out");
  return folder;
}

render::Canvas Renderer::canvas(render::Size page, const Output& output) {
  return {pixels_of(page, output), page, output.look.style.theme.paper, studio_.font};
}

render::Canvas Renderer::frame(const StagedStory& story, std::size_t index, const Output& output) {
  render::Canvas frame = canvas(page_of_frame(output.look), output);
  draw_frame(frame, story, index, output.look);
  return frame;
}

Renderer::Content Renderer::png(render::Image image, render::PngText text) {
  // Where the system gives no further thread, it is encoded in its turn.
  const auto beside = std::launch::async | std::launch::deferred;
  const std::shared_future<std::vector<std::uint8_t>> encoded = std::async(
      beside, [image = std::move(image), text = std::move(text)] { return render::encode_png(image, text); });
  return [encoded] { return encoded.get(); };
}

void Renderer::write(fs::path file, Content content, std::shared_ptr<const StagedStory> story,
                     std::optional<std::size_t> frame) {
  then([this, file = std::move(file), content = std::move(content), story = std::move(story), frame] {
    write_output(file, content());
    written_(file, *story, frame);
  });
}

void Renderer::then(std::function<void()> job) {
  const std::size_t most_waiting = 2 + std::max(1u, std::thread::hardware_concurrency());
  while (jobs_.size() >= most_waiting) do_next();
  jobs_.push_back(std::move(job));
}

void Renderer::finish() {
  while (!jobs_.empty()) do_next();
}

void Renderer::do_next() try {
  const std::function<void()> job = std::move(jobs_.front());
  jobs_.pop_front();
  job();
} catch (...) {
  jobs_.clear();
  throw;
}

Renderer::~Renderer() {
  try {
    finish();
  } catch (...) {
  }
}

}  // namespace walkthroughs::output
