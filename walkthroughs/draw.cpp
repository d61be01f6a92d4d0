#include "walkthroughs/draw.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "walkthroughs/panels.hpp"
#include "walkthroughs/words.hpp"

namespace walkthroughs {
namespace {

using render::Box;
using render::Canvas;
using render::TextStyle;
using render::Vec2;
using render::View;
namespace palette = render::palette;

// The page, in page units.
constexpr double left_margin = 40, right_margin = 1240;
constexpr double panels_top = 76, panels_bottom = 536;
constexpr double text_left = 232, mark_width = 34;
constexpr double first_line = 578, line_pitch = 32;
constexpr double panel_title_height = 30, panel_margin = 52;

const TextStyle caption_style{.size = 26};
const TextStyle fact_style{.size = 23};
const TextStyle small_style{.size = 20, .color = palette::grey};

Box panel_box(double left, double right) { return {{left, panels_top}, {right, panels_bottom}}; }

/// Returns: the part of a panel that the scene may fill, leaving room for the title and for labels outside the hull.
Box inside(const Box& frame) {
  return Box{frame.min + Vec2(0, panel_title_height), frame.max}.grown(-panel_margin);
}

/// Breaks `text` at spaces into lines no wider than `width`.
std::vector<std::string> wrap(const Canvas& canvas, const std::string& text, const TextStyle& style, double width) {
  std::vector<std::string> lines = {""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || canvas.text_box({0, 0}, longer, style).width() <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
    at = end + 1;
  }
  return lines;
}

void draw_header(Canvas& canvas, const Walkthrough& walkthrough) {
  canvas.text({left_margin, 52}, walkthrough.title, {.size = 30, .weight = render::Weight::bold});
  TextStyle source = small_style;
  source.align = render::Align::right;
  canvas.text({right_margin, 52}, walkthrough.source, source);
}

void draw_mark(Canvas& canvas, const Vec2& at, Fact::Mark mark) {
  TextStyle style{.size = 24, .weight = render::Weight::bold};
  style.color = mark == Fact::Mark::yes ? palette::green : palette::vermillion;
  if (mark == Fact::Mark::yes) canvas.text(at, "✓", style);
  if (mark == Fact::Mark::no) canvas.text(at, "✗", style);
}

/// "step n of N", the caption, and the numbers that decide.
void draw_footer(Canvas& canvas, const Story& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  canvas.text({left_margin, first_line},
              "step " + std::to_string(index + 1) + " of " + std::to_string(story.frames.size()),
              {.size = 24, .weight = render::Weight::bold});
  canvas.text({left_margin, first_line + line_pitch}, "iteration " + std::to_string(frame.moments[0].iteration), small_style);
  double y = first_line;
  for (const std::string& line : wrap(canvas, frame.caption, caption_style, right_margin - text_left)) {
    canvas.text({text_left, y}, line, caption_style);
    y += line_pitch;
  }
  for (const Fact& fact : frame.facts) {
    const bool skipped = fact.mark == Fact::Mark::skipped;
    draw_mark(canvas, {text_left, y}, fact.mark);
    canvas.text({text_left + mark_width, y}, skipped ? "skipped " + fact.text : fact.text, skipped ? small_style : fact_style);
    y += line_pitch;
  }
}

void draw_objects_and_difference(Canvas& canvas, const Story& story, const Frame& frame) {
  const Scene& scene = story.walkthrough.scenes[0];
  const Box left = panel_box(left_margin, 470), right = panel_box(490, right_margin);
  const Bounds objects = bounds_of_objects(scene), difference = bounds_of_difference(story.hulls[0]);
  // One scale for both, so that a length in one panel is the same length in the other.
  const double scale = std::min(View::fit(objects.low, objects.high, inside(left), 1e9).scale(),
                                View::fit(difference.low, difference.high, inside(right), 1e9).scale());
  draw_objects(canvas, {left, "the objects", View::fit(objects.low, objects.high, inside(left), scale)}, scene,
               frame.moments[0]);
  draw_difference(canvas, {right, "their difference, a − b", View::fit(difference.low, difference.high, inside(right), scale)},
                  story.hulls[0], frame.moments[0], frame.focus);
}

void draw_close_ups(Canvas& canvas, const Story& story, const Frame& frame) {
  const double middle = (left_margin + right_margin) / 2;
  const Box boxes[] = {panel_box(left_margin, middle - 10), panel_box(middle + 10, right_margin)};
  for (std::size_t s = 0; s < 2; ++s) {
    const Bounds box = bounds_of_difference(story.hulls[s]);
    draw_move(canvas, {boxes[s], story.walkthrough.scenes[s].name, View::fit(box.low, box.high, inside(boxes[s]), 1e9)},
              story.hulls[s], frame.moments[s], frame.focus);
  }
}

}  // namespace

void draw_frame(Canvas& canvas, const Story& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  draw_header(canvas, story.walkthrough);
  switch (story.walkthrough.layout) {
    case Layout::objects_and_difference: draw_objects_and_difference(canvas, story, frame); break;
    case Layout::close_ups: draw_close_ups(canvas, story, frame); break;
  }
  draw_footer(canvas, story, index);
}

}  // namespace walkthroughs
