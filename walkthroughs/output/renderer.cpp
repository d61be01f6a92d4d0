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

render::Image Renderer::draw(const StagedStory& story, std::size_t index, const Output& output) {
  return draw(page_of_frame(output.look.text), output,
              [&](render::Canvas& canvas) { draw_frame(canvas, story, index, output.look); });
}

render::Image Renderer::draw(render::Size page, const Output& output,
                             const std::function<void(render::Canvas&)>& paint) {
  return draw_page(pixels_of(page, output), page, output.look.style.theme.paper, paint);
}

render::Image Renderer::draw_page(render::Size pixels, render::Size page, render::Color paper,
                                  const std::function<void(render::Canvas&)>& paint) {
  render::Canvas canvas(pixels, page, paper, studio_.font);
  paint(canvas);
  return studio_.rasterizer.draw(canvas);
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

}  // namespace walkthroughs
