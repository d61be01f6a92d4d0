#include "walkthroughs/picture/render_frames.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include "render/apng.hpp"
#include "render/image.hpp"
#include "walkthroughs/story/alternative_text.hpp"

namespace walkthroughs {
namespace {

namespace fs = std::filesystem;

/// Returns: the folder of a walkthrough's pictures, which is there.
fs::path folder_of(const Output& output, const Walkthrough& walkthrough) {
  render::make_folder(output.folder / walkthrough.name, "choose another with --out");
  return output.folder / walkthrough.name;
}

/// Returns: the size of a picture of `page` at the scale of `output`, smaller where it would not fit.
render::Size pixels_of(render::Size page, const Output& output) {
  if (page == frame_page) return output.size;
  const double scale = std::min({1.0 * output.size.width / frame_page.width,
                                 1.0 * output.size.height / frame_page.height, 1.0 * render::max_pixels / page.width});
  const auto pixels = [&](int units) { return std::max(render::min_pixels, static_cast<int>(units * scale)); };
  return {pixels(page.width), pixels(page.height)};
}

bool in_space(const Walkthrough& walkthrough) {
  return std::ranges::any_of(walkthrough.scenes,
                             [](const Scene& scene) { return scene.dimension == Dimension::space; });
}

/// Removes the views of frame `index` from number `first` on. Returns: whether there was one.
bool remove_views(const fs::path& folder, std::size_t index, int first) {
  std::error_code ignored;
  int turn = first;
  while (fs::is_regular_file(folder / picture_name(index, turn), ignored) &&
         fs::remove(folder / picture_name(index, turn), ignored))
    ++turn;
  return turn > first;
}

/// Removes the frames that an earlier run with more of them has left in `folder`, and the views beyond `turns`.
void remove_stale(const fs::path& folder, std::size_t count, int turns) {
  for (std::size_t index = 0; index < count; ++index) remove_views(folder, index, turns + 1);
  for (std::size_t stale = count; remove_views(folder, stale, 0); ++stale) {
  }
}

}  // namespace

std::string picture_name(std::size_t index, int turn) {
  char name[64];
  if (turn == 0)
    std::snprintf(name, sizeof name, "%03zu.png", index);
  else
    std::snprintf(name, sizeof name, "%03zu-turn-%d.png", index, turn);
  return name;
}

int turns_of(const Walkthrough& walkthrough, const Output& output) { return in_space(walkthrough) ? output.turns : 0; }

// ---------------------------------------------------------------------------------------------- Renderer

render::Image Renderer::draw(const StagedStory& story, std::size_t index, const Output& output) {
  const render::Size page = page_of_frame(output.look.text);
  render::Canvas canvas(pixels_of(page, output), page, output.look.style.theme.paper, studio_.font);
  draw_frame(canvas, story, index, output.look);
  return studio_.rasterizer.draw(canvas);
}

void Renderer::write(fs::path file, render::Image image, render::PngText text, FileWritten written) {
  writer_.prepare([file = std::move(file), image = std::move(image), text = std::move(text),
                   written = std::move(written)]() -> render::Worker::Job {
    return [=, png = render::encode_png(image, text)] {
      render::write_file(file, png);
      written(file);
    };
  });
}

void Renderer::frames(const StagedStory& story, const Output& output, FrameWritten written,
                      std::optional<double> animation_seconds, FileWritten animation_written) {
  const Walkthrough& w = story.walkthrough;
  const fs::path folder = folder_of(output, w);
  const std::size_t count = story.frames.size();
  const int turns = turns_of(w, output);
  const auto animation = std::make_shared<render::Animation>(render::PngText{w.title, w.summary});
  for (std::size_t i = 0; i < count; ++i) {
    const render::PngText text{w.title + ", step " + std::to_string(i + 1) + " of " + std::to_string(count),
                               alternative_text(story, i)};
    const double seconds = animation_seconds.value_or(0) * (i + 1 == count ? last_frame_times : 1);
    writer_.prepare([=, file = folder / picture_name(i), image = draw(story, i, output)]() -> render::Worker::Job {
      return [=, png = render::encode_png(image, text)] {
        render::write_file(file, png);
        if (animation_seconds) animation->add(png, seconds);
        written(file, i);
      };
    });
    Output turned = output;
    for (int turn = 1; turn <= turns; ++turn) {
      turned.look.turn = output.look.turn + 360.0 * turn / (turns + 1);
      write(folder / picture_name(i, turn), draw(story, i, turned), text,
            [=](const fs::path& file) { written(file, i); });
    }
  }
  writer_.post([=] {
    remove_stale(folder, count, turns);
    if (!animation_seconds) return;
    render::write_file(folder / "animation.png", animation->bytes());
    animation_written(folder / "animation.png");
  });
}

void Renderer::strip(const StagedStory& story, const Output& output, FileWritten written) {
  const render::Size page = strip_page(story);
  render::Canvas canvas(pixels_of(page, output), page, output.look.style.theme.paper, studio_.font);
  draw_strip(canvas, story, output.look);
  const fs::path file = folder_of(output, story.walkthrough) / "strip.png";
  write(file, studio_.rasterizer.draw(canvas), {story.walkthrough.title, story.walkthrough.summary},
        std::move(written));
}

void Renderer::sheet(const StagedStory& story, const Output& output, FileWritten written) {
  const SheetLayout layout = sheet_layout(static_cast<int>(story.frames.size()), output);
  Output small = output;
  small.size = layout.frame;
  render::Image sheet(layout.size());
  sheet.fill(output.look.style.theme.faint);
  for (int i = 0; i < layout.count; ++i)
    sheet.paste(draw(story, static_cast<std::size_t>(i), small), layout.left(i), layout.top(i));
  const fs::path file = folder_of(output, story.walkthrough) / "sheet.png";
  write(file, std::move(sheet), {story.walkthrough.title, story.walkthrough.summary}, std::move(written));
}

SheetLayout sheet_layout(int count, const Output& output) {
  static_assert(sheet_columns * (sheet_scale * render::max_pixels + sheet_gap) + sheet_gap <= render::max_image_side);
  const auto fitting = [](int pixels) { return (render::max_image_side - sheet_gap) / (pixels + sheet_gap); };
  for (double scale = sheet_scale;; scale *= 0.95) {
    const auto reduced = [&](int pixels) { return std::max(render::min_pixels, static_cast<int>(pixels * scale)); };
    Output small = output;
    small.size = {reduced(output.size.width), reduced(output.size.height)};
    const render::Size cell = pixels_of(page_of_frame(output.look.text), small);
    const int most_rows = fitting(cell.height), columns = (count + most_rows - 1) / most_rows;
    if (columns <= fitting(cell.width))
      return {count, std::max(columns, std::min(count, sheet_columns)), small.size, cell};
    if (std::max(cell.width, cell.height) == render::min_pixels)
      throw render::FileError("cannot draw a sheet of " + std::to_string(count) +
                              " frames: they do not fit into one picture; leave out --sheet, or choose --detail step");
  }
}

// ---------------------------------------------------------------------------------------------- one at a time

void render_frames(const StagedStory& story, const Output& output, Studio& studio, const FrameWritten& written) {
  Renderer renderer(studio);
  renderer.frames(story, output, written);
  renderer.finish();
}

fs::path render_strip(const StagedStory& story, const Output& output, Studio& studio) {
  fs::path written;
  Renderer renderer(studio);
  renderer.strip(story, output, [&](const fs::path& file) { written = file; });
  renderer.finish();
  return written;
}

fs::path render_sheet(const StagedStory& story, const Output& output, Studio& studio) {
  fs::path written;
  Renderer renderer(studio);
  renderer.sheet(story, output, [&](const fs::path& file) { written = file; });
  renderer.finish();
  return written;
}

}  // namespace walkthroughs
