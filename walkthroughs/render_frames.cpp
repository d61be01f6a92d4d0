#include "walkthroughs/render_frames.hpp"

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "render/image.hpp"
#include "walkthroughs/alternative_text.hpp"

namespace walkthroughs {
namespace {

namespace fs = std::filesystem;

std::string file_name(std::size_t index) {
  char name[32];
  std::snprintf(name, sizeof name, "%03zu.png", index);
  return name;
}

fs::path make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw render::FileError("cannot create the folder " + folder.string() + ": " + error.message() +
                            "; choose another with --out");
  return folder;
}

/// Returns: the size of a picture of `page` at the scale of `output`, smaller where it would not fit.
render::Size pixels_of(render::Size page, const Output& output) {
  if (page == frame_page) return output.size;
  const double scale = std::min({1.0 * output.size.width / frame_page.width,
                                 1.0 * output.size.height / frame_page.height, 1.0 * render::max_pixels / page.width});
  const auto pixels = [&](int units) { return std::max(render::min_pixels, static_cast<int>(units * scale)); };
  return {pixels(page.width), pixels(page.height)};
}

}  // namespace

void render_frames(const Story& story, const Output& output, Studio& studio, const FrameWritten& written) {
  const fs::path folder = make_folder(output.folder / story.walkthrough.name);
  const render::Size page = page_of_frame(output.text);
  const std::size_t count = story.frames.size();
  for (std::size_t i = 0; i < count; ++i) {
    render::Canvas canvas(pixels_of(page, output), page, render::palette::white, studio.font);
    draw_frame(canvas, story, i, output.text);
    const fs::path file = folder / file_name(i);
    const std::string title =
        story.walkthrough.title + ", step " + std::to_string(i + 1) + " of " + std::to_string(count);
    render::write_png(file, studio.rasterizer.draw(canvas), {title, alternative_text(story, i)});
    written(file, i);
  }
  std::error_code ignored;
  for (std::size_t stale = count; fs::is_regular_file(folder / file_name(stale), ignored); ++stale)
    fs::remove(folder / file_name(stale), ignored);
}

fs::path render_strip(const Story& story, const Output& output, Studio& studio) {
  const render::Size page = strip_page(story);
  render::Canvas canvas(pixels_of(page, output), page, render::palette::white, studio.font);
  draw_strip(canvas, story);
  const fs::path file = make_folder(output.folder / story.walkthrough.name) / "strip.png";
  render::write_png(file, studio.rasterizer.draw(canvas), {story.walkthrough.title, story.walkthrough.summary});
  return file;
}

}  // namespace walkthroughs
