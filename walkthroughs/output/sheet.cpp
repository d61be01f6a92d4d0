#include "walkthroughs/output/sheet.hpp"

#include <algorithm>

#include "render/file.hpp"
#include "render/image.hpp"

namespace walkthroughs::output {

SheetLayout sheet_layout(int count, const Output& output) {
  static_assert(sheet_columns * (sheet_scale * render::max_pixels + sheet_gap) + sheet_gap <= render::max_image_side);
  const auto fitting = [](int pixels) { return (render::max_image_side - sheet_gap) / (pixels + sheet_gap); };
  for (double scale = sheet_scale;; scale *= 0.95) {
    const auto reduced = [&](int pixels) { return std::max(render::min_pixels, static_cast<int>(pixels * scale)); };
    Output small = output;
    small.size = {reduced(output.size.width), reduced(output.size.height)};
    const render::Size cell = pixels_of(page_of_frame(output.look), small);
    const int most_rows = fitting(cell.height), columns = (count + most_rows - 1) / most_rows;
    if (columns <= fitting(cell.width))
      return {count, std::max(columns, std::min(count, sheet_columns)), small.size, cell};
    if (std::max(cell.width, cell.height) == render::min_pixels)
      throw render::FileError(
          "cannot draw a sheet of " + std::to_string(count) +
          " frames: they do not fit into one picture; leave out --sheet, or choose --detail iteration");
  }
}

OneFile sheet() {
  const auto make = [](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    const SheetLayout layout = sheet_layout(static_cast<int>(story->frames.size()), output);
    Output small = output;
    small.size = layout.frame;
    render::Image sheet(layout.size());
    sheet.fill(output.look.style.theme.faint);
    for (int i = 0; i < layout.count; ++i)
      sheet.paste(renderer.draw(renderer.frame(*story, static_cast<std::size_t>(i), small)), layout.left(i),
                  layout.top(i));
    return Renderer::png(std::move(sheet), text_of(story->walkthrough));
  };
  return {"sheet.png", make};
}

}  // namespace walkthroughs::output
