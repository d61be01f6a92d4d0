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

render::Image draw_one(const Story& story, std::size_t index, const Output& output, Studio& studio) {
  const render::Size page = page_of_frame(output.look.text);
  render::Canvas canvas(pixels_of(page, output), page, output.look.style.theme.paper, studio.font);
  draw_frame(canvas, story, index, output.look);
  return studio.rasterizer.draw(canvas);
}

}  // namespace

void render_frames(const Story& story, const Output& output, Studio& studio, const FrameWritten& written) {
  const fs::path folder = make_folder(output.folder / story.walkthrough.name);
  const std::size_t count = story.frames.size();
  for (std::size_t i = 0; i < count; ++i) {
    const fs::path file = folder / file_name(i);
    const std::string title =
        story.walkthrough.title + ", step " + std::to_string(i + 1) + " of " + std::to_string(count);
    render::write_png(file, draw_one(story, i, output, studio), {title, alternative_text(story, i)});
    written(file, i);
  }
  std::error_code ignored;
  for (std::size_t stale = count; fs::is_regular_file(folder / file_name(stale), ignored); ++stale)
    fs::remove(folder / file_name(stale), ignored);
}

fs::path render_strip(const Story& story, const Output& output, Studio& studio) {
  const render::Size page = strip_page(story);
  render::Canvas canvas(pixels_of(page, output), page, output.look.style.theme.paper, studio.font);
  draw_strip(canvas, story, output.look);
  const fs::path file = make_folder(output.folder / story.walkthrough.name) / "strip.png";
  render::write_png(file, studio.rasterizer.draw(canvas), {story.walkthrough.title, story.walkthrough.summary});
  return file;
}

fs::path render_sheet(const Story& story, const Output& output, Studio& studio) {
  const auto reduced = [](int pixels) { return std::max(render::min_pixels, static_cast<int>(pixels * sheet_scale)); };
  const Output small{output.folder, {reduced(output.size.width), reduced(output.size.height)}, output.look};
  const render::Size cell = pixels_of(page_of_frame(output.look.text), small);
  const int count = static_cast<int>(story.frames.size());
  const int columns = std::min(count, sheet_columns), rows = (count + columns - 1) / columns;
  const auto length = [](int cells, int pixels) { return cells * (pixels + sheet_gap) + sheet_gap; };
  render::Image sheet({length(columns, cell.width), length(rows, cell.height)});
  sheet.fill(render::palette::faint);
  for (int i = 0; i < count; ++i)
    sheet.paste(draw_one(story, static_cast<std::size_t>(i), small, studio),
                sheet_gap + (i % columns) * (cell.width + sheet_gap),
                sheet_gap + (i / columns) * (cell.height + sheet_gap));
  const fs::path file = make_folder(output.folder / story.walkthrough.name) / "sheet.png";
  render::write_png(file, sheet, {story.walkthrough.title, story.walkthrough.summary});
  return file;
}

}  // namespace walkthroughs
