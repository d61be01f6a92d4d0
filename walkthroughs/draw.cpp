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
constexpr double panels_top = 76, panels_height = 460, margin_without_text = 20;
constexpr double text_left = 250, mark_width = 34;
constexpr double first_line = 576, line_pitch = 32;
constexpr double max_scale = 1e9;                              // for a scene that is a single point
constexpr double objects_margin = 70, difference_margin = 64;  // around a scene: room for arrows, for labels

const TextStyle caption_style{.size = 26};
const TextStyle fact_style{.size = 23};
const TextStyle small_style{.size = 20, .color = palette::grey};

Box panel_box(double left, double right, double top) { return {{left, top}, {right, top + panels_height}}; }

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

void draw_fact(Canvas& canvas, const Vec2& at, const Fact& fact) {
  TextStyle bold = fact_style;
  bold.weight = render::Weight::bold;
  switch (fact.mark) {
    case Fact::Mark::skipped: canvas.text(at, "skipped " + fact.text, small_style); break;
    case Fact::Mark::answer: canvas.text(at, fact.text, bold); break;
    default: canvas.text(at, fact.text, fact_style);
  }
}

/// "step n of N", the caption, and the numbers that decide.
void draw_footer(Canvas& canvas, const Story& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  canvas.text({left_margin, first_line},
              "step " + std::to_string(index + 1) + " of " + std::to_string(story.frames.size()),
              {.size = 24, .weight = render::Weight::bold});
  canvas.text({left_margin, first_line + line_pitch}, "iteration " + std::to_string(frame.moments[0].iteration),
              small_style);
  const Simplex& simplex = frame.moments[0].simplex;
  const std::string now = simplex.size() == 0 ? "no simplex yet" : "simplex " + list_of_names(simplex, story.hulls[0]);
  canvas.text({left_margin, first_line + 2 * line_pitch}, now, small_style);
  double y = first_line;
  for (const std::string& line : render::wrap(canvas, frame.caption, caption_style, right_margin - text_left)) {
    canvas.text({text_left, y}, line, caption_style);
    y += line_pitch;
  }
  for (const Fact& fact : frame.facts) {
    draw_mark(canvas, {text_left, y}, fact.mark);
    draw_fact(canvas, {text_left + mark_width, y}, fact);
    y += line_pitch;
  }
}

int draw_objects_and_difference(Canvas& canvas, const Story& story, const Frame& frame, double top) {
  const Scene& scene = story.walkthrough.scenes[0];
  const Box left = panel_box(left_margin, 470, top), right = panel_box(490, right_margin, top);
  const Bounds objects = bounds_of_objects(scene), difference = bounds_of_difference(story.hulls[0]);
  const Box room_left = below_title(left).grown(-objects_margin),
            room_right = below_title(right).grown(-difference_margin);
  // One scale for both, so that a length in one panel is the same length in the other.
  const double scale = std::min(View::fit(objects.low, objects.high, room_left, max_scale).scale(),
                                View::fit(difference.low, difference.high, room_right, max_scale).scale());
  return draw_objects(canvas, {left, "objects", View::fit(objects.low, objects.high, room_left, scale)}, scene,
                      frame.moments[0], frame.focus) +
         draw_difference(canvas,
                         {right, "difference a − b", View::fit(difference.low, difference.high, room_right, scale)},
                         story.hulls[0], frame.moments[0], frame.focus);
}

int draw_close_ups(Canvas& canvas, const Story& story, const Frame& frame, double top) {
  const double middle = (left_margin + right_margin) / 2;
  const Box boxes[] = {panel_box(left_margin, middle - 10, top), panel_box(middle + 10, right_margin, top)};
  const auto view = [&](std::size_t s, double scale) {
    const Bounds box = bounds_of_move(story.frames.back().moments[s]);  // of the whole move, so that nothing jumps
    return View::fit(box.low, box.high, below_title(boxes[s]).grown(-difference_margin), scale);
  };
  const double scale = std::min(view(0, max_scale).scale(), view(1, max_scale).scale());
  int crowded = 0;
  for (std::size_t s = 0; s < 2; ++s)
    crowded += draw_move(canvas, {boxes[s], story.walkthrough.scenes[s].name + " set", view(s, scale)}, story.hulls[s],
                         frame.moments[s], frame.focus);
  return crowded;
}

// The strip, in page units.
constexpr int cell_width = 420, cell_height = 490;
constexpr double cell_gap = 10, cell_panel_bottom = 386, cell_margin = 44;

/// One panel of the strip: its picture fills the box and `caption` stands below.
struct Cell {
  const Frame& frame;
  std::size_t scene;
  std::string title, caption;
};

std::vector<Cell> cells(const Story& story) {
  std::vector<Cell> list;
  if (story.walkthrough.layout == Layout::close_ups) {
    for (std::size_t s = 0; s < story.hulls.size(); ++s)
      list.push_back(
          {story.frames.back(), s, story.walkthrough.scenes[s].name + " set", story.frames.back().facts[s].text});
    return list;
  }
  for (const std::size_t i : last_of_each_iteration(story.frames)) {
    const Frame& frame = story.frames[i];
    list.push_back({frame, 0, "iteration " + std::to_string(frame.moments[0].iteration), frame.headline});
  }
  return list;
}

int draw_cell(Canvas& canvas, const Story& story, const Cell& cell, double left) {
  const Box frame{{left + cell_gap, cell_gap}, {left + cell_width - cell_gap, cell_panel_bottom}};
  const Box room = below_title(frame).grown(-cell_margin);
  const Moment& now = cell.frame.moments[cell.scene];
  const LabelledHull& hull = story.hulls[cell.scene];
  const bool close_up = story.walkthrough.layout == Layout::close_ups;
  const Bounds box = close_up ? bounds_of_move(now) : bounds_of_difference(hull);
  const Place place{frame, cell.title, View::fit(box.low, box.high, room, max_scale)};
  const int crowded = close_up ? draw_move(canvas, place, hull, now, cell.frame.focus)
                               : draw_difference(canvas, place, hull, now, cell.frame.focus);
  double y = cell_panel_bottom + line_pitch;
  for (const std::string& line : render::wrap(canvas, cell.caption, fact_style, frame.width())) {
    canvas.text({frame.min.x(), y}, line, fact_style);
    y += line_pitch * 0.9;
  }
  return crowded;
}

}  // namespace

render::Size page_of_frame(Text text) {
  if (text == Text::around) return frame_page;
  return {frame_page.width, static_cast<int>(panels_height + 2 * margin_without_text)};
}

int draw_frame(Canvas& canvas, const Story& story, std::size_t index, const Look& look) {
  const Text text = look.text;
  const Frame& frame = story.frames[index];
  const double top = text == Text::around ? panels_top : margin_without_text;
  if (text == Text::around) {
    draw_header(canvas, story.walkthrough);
    draw_footer(canvas, story, index);
  }
  switch (story.walkthrough.layout) {
    case Layout::search: return draw_objects_and_difference(canvas, story, frame, top);
    case Layout::close_ups: return draw_close_ups(canvas, story, frame, top);
    default: return 0;
  }
  return 0;
}

render::Size strip_page(const Story& story) {
  return {cell_width * static_cast<int>(cells(story).size()), cell_height};
}

int draw_strip(Canvas& canvas, const Story& story, const Look&) {
  int crowded = 0;
  double left = 0;
  for (const Cell& cell : cells(story)) {
    crowded += draw_cell(canvas, story, cell, left);
    left += cell_width;
  }
  return crowded;
}

}  // namespace walkthroughs
