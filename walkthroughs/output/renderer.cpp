#include "walkthroughs/output/renderer.hpp"

#include "render/file.hpp"
#include "render/image.hpp"
#include "render/limits.hpp"
#include "walkthroughs/output/manifest.hpp"

namespace walkthroughs {

namespace fs = std::filesystem;

render::Size pixels_of(render::Size page, const Output& output) {
  if (page == frame_page) return output.size;
  const double scale = std::min({1.0 * output.size.width / frame_page.width,
                                 1.0 * output.size.height / frame_page.height, 1.0 * render::max_pixels / page.width});
  const auto pixels = [&](int units) { return std::max(render::min_pixels, static_cast<int>(units * scale)); };
  return {pixels(page.width), pixels(page.height)};
}

fs::path folder_of(const Output& output, const Walkthrough& walkthrough) {
  render::make_folder(output.folder / walkthrough.name, "choose another with --out");
  return output.folder / walkthrough.name;
}

render::Canvas Renderer::canvas(render::Size page, const Output& output) {
  return {pixels_of(page, output), page, output.look.style.theme.paper, studio_.font};
}

render::Canvas Renderer::frame(const StagedStory& story, std::size_t index, const Output& output) {
  render::Canvas frame = canvas(page_of_frame(output.look.text), output);
  draw_frame(frame, story, index, output.look);
  return frame;
}

void Renderer::write(fs::path file, render::Image image, render::PngText text, Written written) {
  writer_.prepare([file = std::move(file), image = std::move(image), text = std::move(text),
                   written = std::move(written)]() -> render::Worker::Job {
    return [=, png = render::encode_png(image, text)] {
      write_output(file, png);
      written(file);
    };
  });
}

void Renderer::write(fs::path file, std::vector<std::uint8_t> bytes, Written written) {
  then([=, file = std::move(file), bytes = std::move(bytes), written = std::move(written)] {
    write_output(file, bytes);
    written(file);
  });
}

}  // namespace walkthroughs
