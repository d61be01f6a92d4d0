#include "walkthroughs/picture/draw.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Canvas;
using render::Interval;
using render::TextStyle;
using render::Vec2;
using render::View;

// The page, in page units.
constexpr double left_margin = 40, right_margin = 1240, panel_gap = 14;
constexpr double stacked_right = 600;  // of panels below each other
constexpr int margin_without_text = 20;
constexpr double title_top = 18, below_title_line = 24;  // around the line of the title
constexpr double share_of_space = 0.4, decision_margin = 34;
constexpr double line_pitch = 30;
/// From the zero of a scene to its points, so that these are placed to a thousandth.
constexpr double most_page_units = 1e12;
constexpr double least_magnification = 1.3;                    // below that a close-up tells no more than the whole
constexpr double objects_margin = 64, difference_margin = 64;  // around a scene: room for arrows, for labels

/// A length at the usual size of text, and what half as large text again adds.
double with_text(const Style& style, double usual, double added) { return usual + 2 * added * (style.theme.text - 1); }

double objects_width(const Style& style) { return with_text(style, 300, -30); }
double algorithm_width(const Style& style) { return with_text(style, 372, 120); }
double footer_height(const Style& style) { return with_text(style, 200, 75); }

/// From where to where the panels of a frame reach down.
Interval rows_of_panels(const Look& look) {
  if (look.text == Text::none) return {margin_without_text, static_cast<double>(margin_without_text + look.height)};
  return {title_top + look.style.scaled(30) + below_title_line, frame_page.height - footer_height(look.style)};
}

Box panel_box(double left, double right, const Interval& rows) { return {{left, rows.from}, {right, rows.to}}; }

Lens turned(const Lens& lens, const Look& look) {
  return lens.camera && (look.turn != 0 || look.rise != 0) ? Lens{lens.camera->turned(look.turn, look.rise)} : lens;
}

/// That of `kept`, where there is one; of a scene that is moved or scaled otherwise before it is drawn nothing can be kept.
const Stage& kept_stage(const StagedStory* kept, const StagedStory& story, std::size_t scene) {
  const Stage& own = story.stages[scene];
  return kept && kept->stages[scene].placing == own.placing ? kept->stages[scene] : own;
}

/// One scene of one frame, as it is drawn.
struct SceneOfFrame {
  SceneOfFrame(const StagedStory& story, std::size_t frame, std::size_t scene, const Look& look)
      : stage(story.stages[scene]),
        now(story.drawn(frame, scene)),
        names(story.walkthrough.naming, stage.telling->hull, now),
        framing(kept_stage(look.framing, story, scene)),
        lens(turned(kept_stage(look.cameras, story, scene).lens, look)),
        shown{*stage.telling, stage,      now,         names, story.frames[frame].focus_of(scene),
              lens,           look.style, look.values, false, story.frames[frame].focus == Focus::parting,
              framing,        look.zoom,  look.grips} {}
  SceneOfFrame(const SceneOfFrame&) = delete;  // what is shown refers to it
  SceneOfFrame& operator=(const SceneOfFrame&) = delete;

  const Stage& stage;
  const Moment now;
  const Names names;
  const Stage& framing;
  const Lens lens;
  const Shown shown;
};

// -- Around the panels ------------------------------------------------------------------------------------------------

/// The title, smaller where it is long, and the source as far as there is room for it.
void draw_header(Canvas& canvas, const Walkthrough& walkthrough, const Style& style) {
  const std::string title = literal(walkthrough.title);
  const double baseline = title_top + style.title.size, width = canvas.width(title, style.title);
  canvas.text({left_margin, baseline}, title, canvas.fitted(title, style.title, right_margin - left_margin));
  TextStyle source = style.small;
  source.align = render::Align::right;
  if (canvas.text_box({right_margin, baseline}, walkthrough.source, source).min.x() > left_margin + width + panel_gap)
    canvas.text({right_margin, baseline}, walkthrough.source, source);
}

// -- One scene --------------------------------------------------------------------------------------------------------

/// One above the other.
std::pair<Box, Box> halves_of(const Interval& rows, double left, double right) {
  const double middle = (rows.from + rows.to) / 2;
  return {panel_box(left, right, {rows.from, middle - panel_gap / 2}),
          panel_box(left, right, {middle + panel_gap / 2, rows.to})};
}

/// The panels of a search from left to right: objects, difference, algorithm.
struct Columns {
  std::optional<Box> objects, algorithm;
  Box difference;
};

/// `is_decision`: the view in space stands where the objects are in other frames.
Columns columns(const Panels& panels, bool is_decision, const Box& box, const Look& look) {
  const Interval rows{box.min.y(), box.max.y()};
  const Style& style = look.style;
  double left = box.min.x(), right = box.max.x();
  if (look.stacked) {
    if (!panels.objects && !is_decision) return {{}, {}, box};
    const auto [above, below] = halves_of(rows, left, right);
    return {above, {}, below};
  }
  Columns all;
  if (panels.objects || is_decision) {
    const double width = panels.algorithm || !is_decision ? objects_width(style) : share_of_space * (right - left);
    all.objects = panel_box(left, left + width, rows);
    left += width + panel_gap;
  }
  if (panels.algorithm) {
    all.algorithm = panel_box(right - algorithm_width(style), right, rows);
    right -= algorithm_width(style) + panel_gap;
  }
  all.difference = panel_box(left, right, rows);
  return all;
}

/// Where the panels of a frame stand.
Box box_of_panels(const Walkthrough& walkthrough, const Look& look) {
  const bool is_narrow = look.stacked && walkthrough.layout != Layout::diagrams;
  return panel_box(left_margin, is_narrow ? stacked_right : right_margin, rows_of_panels(look));
}

/// Returns: what is left of it so many times as large.
Box zoomed(const Box& bounds, double zoom) {
  const Vec2 half = (bounds.max - bounds.min) / (2 * zoom);
  return zoom == 1 ? bounds : Box{bounds.center() - half, bounds.center() + half};
}

/// No larger than what doubles can place.
View fit(const Box& bounds, const Box& room) {
  const double farthest = std::max(bounds.min.cwiseAbs().maxCoeff(), bounds.max.cwiseAbs().maxCoeff());
  return View::fit(bounds.min, bounds.max, room, most_page_units / (farthest > 0 ? farthest : 1));
}

Box whole_difference(const Shown& what) { return zoomed(bounds_of_difference(what.framing, what.lens), what.zoom); }

/// Returns: the regions of a simplex close up, where it would be small in the view of the whole set.
std::optional<View> close_up(const Shown& what, const View& whole, const Box& room) {
  if (what.focus != Focus::region || what.now.processed.size() < 2) return std::nullopt;
  const View near = fit(bounds_of_decision(what.now, what.lens), room);
  return near.scale() > least_magnification * whole.scale() ? std::optional(near) : std::nullopt;
}

/// The difference beside the picture of a decision, small.
void draw_beside(Canvas& canvas, const Box& frame, const Shown& what) {
  Shown beside = what;
  beside.regions_beside = true;
  const Box room = below_title(frame, what.style).grown(-decision_margin);
  const View whole = fit(whole_difference(what), room);
  draw_difference(canvas, {frame, "a − b", close_up(what, whole, room).value_or(whole)}, beside);
}

View view_of_objects(const Box& frame, const Shown& what) {
  return fit(zoomed(bounds_of_objects(what.framing, what.lens), what.zoom),
             below_title(frame, what.style).grown(-objects_margin));
}

/// The view in space beside the plane pictures of its decision, which are what to look at first. At the end the objects
/// stand there: the gap that is seen in the plane is a gap between them.
void draw_decision_in_space(Canvas& canvas, const Columns& boxes, const std::vector<DecisionView>& views,
                            const Shown& what) {
  if (what.focus == Focus::end && what.telling.panels.objects)
    draw_objects(canvas, {*boxes.objects, "", view_of_objects(*boxes.objects, what)}, what);
  else
    draw_beside(canvas, *boxes.objects, what);
  draw_decision(canvas, boxes.difference, views, what);
}

/// The difference, and where asked for the objects.
void draw_whole_set(Canvas& canvas, const Columns& boxes, const Shown& what) {
  const Box room = below_title(boxes.difference, what.style).grown(-difference_margin);
  View whole = fit(whole_difference(what), room);
  const std::optional<View> near = close_up(what, whole, room);
  if (boxes.objects) {
    View left = view_of_objects(*boxes.objects, what);
    if (!what.lens.camera && !near) {  // One scale for both, so that a length in one panel is the same in the other.
      const double scale = std::min(left.scale(), whole.scale());
      left = left.with_scale(scale);
      whole = whole.with_scale(scale);
    }
    draw_objects(canvas, {*boxes.objects, "", left}, what);
  }
  draw_difference(canvas, {boxes.difference, near ? "a − b, close up" : "difference a − b", near.value_or(whole)},
                  what);
}

void draw_search(Canvas& canvas, const Box& box, const StagedStory& story, std::size_t index, const Look& look) {
  const Telling& telling = *story.stages[0].telling;
  const SceneOfFrame scene(story, index, 0, look);
  const Shown& what = scene.shown;
  const std::vector<DecisionView> views =
      shows_decision(story) ? decision_views(what.now, what.focus) : std::vector<DecisionView>{};
  const std::optional<NumberLine> line =
      telling.panels.decision ? number_line(what.now, what.focus, what.names) : std::nullopt;
  const Columns boxes = columns(telling.panels, !views.empty() || line, box, look);
  if (line) {
    draw_beside(canvas, *boxes.objects, what);
    draw_number_line(canvas, boxes.difference, *line, what);
  } else if (views.empty()) {
    draw_whole_set(canvas, boxes, what);
  } else {
    draw_decision_in_space(canvas, boxes, views, what);
  }
  if (boxes.algorithm && look.code) draw_algorithm(canvas, *boxes.algorithm, what);
}

// -- Two scenes -------------------------------------------------------------------------------------------------------

/// "left set"; of two searches of one set "as printed", with the answer once the search has ended.
std::string title_of_scene(const StagedStory& story, std::size_t scene, const Frame& frame) {
  const std::string& name = story.tellings[scene].scene.name;
  const bool are_of_one_set = story.walkthrough.layout == Layout::until_they_part ||
                              story.tellings.front().scene.rules != story.tellings.back().scene.rules;
  if (!are_of_one_set) return name + " set";
  const std::optional<gjk::Result<double>>& result = frame.moments[scene].result;
  return result ? name + ": " + std::string(gjk::to_string(result->status)) : name;
}

bool shows_a_move(const StagedStory& story) { return story.walkthrough.layout == Layout::close_ups; }

Box bounds_of_scene(const StagedStory& story, std::size_t scene, std::size_t frame, const Lens& lens) {
  return shows_a_move(story) ? bounds_of_move(story.drawn(frame, scene), lens)
                             : bounds_of_difference(story.stages[scene], lens);
}

void draw_scene(Canvas& canvas, const StagedStory& story, const Place& place, const Shown& what) {
  return shows_a_move(story) ? draw_move(canvas, place, what) : draw_difference(canvas, place, what);
}

void draw_pair(Canvas& canvas, const Box& box, const StagedStory& story, std::size_t index, const Look& look) {
  const double middle = (box.min.x() + box.max.x()) / 2;
  const Interval rows{box.min.y(), box.max.y()};
  const auto [above, below] = halves_of(rows, box.min.x(), box.max.x());
  const Box boxes[] = {look.stacked ? above : panel_box(box.min.x(), middle - panel_gap / 2, rows),
                       look.stacked ? below : panel_box(middle + panel_gap / 2, box.max.x(), rows)};
  const SceneOfFrame scenes[] = {{story, index, 0, look}, {story, index, 1, look}};
  const StagedStory& framing = look.framing ? *look.framing : story;
  const auto view = [&](std::size_t s) {
    const std::size_t last = framing.frames.size() - 1;  // of which the bounds are, so that nothing jumps
    return fit(zoomed(bounds_of_scene(framing, s, last, scenes[s].lens), look.zoom),
               below_title(boxes[s], look.style).grown(-difference_margin));
  };
  const View views[] = {view(0), view(1)};
  const double scale = std::min(views[0].scale(), views[1].scale());
  for (std::size_t s = 0; s < 2; ++s) {
    const std::string title = title_of_scene(story, s, story.frames[index]);
    draw_scene(canvas, story, {boxes[s], title, views[s].with_scale(scale)}, scenes[s].shown);
  }
}

void draw_diagram(Canvas& canvas, const StagedStory& story, std::size_t index, const Box& box, const Look& look) {
  Style style = look.style;
  style.turn = look.turn;
  style.rise = look.rise;
  canvas.add_crowded(story.diagrams[index].draw(canvas, box, style));
}

// -- The strip --------------------------------------------------------------------------------------------------------

// In page units.
constexpr int cell_width = 420, caption_height = 104;
constexpr int longest_row = 12 * cell_width;
constexpr double pitch_of_caption = 0.95, next_smaller = 0.93, least_caption = 0.6;
constexpr double wanted_shape = 16.0 / 9;  // of what has more than one row
constexpr double cell_gap = 10, cell_panel_bottom = 386, cell_margin = 44, room_for_arrows = 24;
constexpr double small_margin = 0.13;  // of the width of a picture

/// One panel of the strip: its picture fills the box and `caption` stands below.
struct Cell {
  std::size_t frame, scene;
  std::string title, caption;
};

std::vector<Cell> cells(const StagedStory& story) {
  std::vector<Cell> list;
  if (story.walkthrough.layout == Layout::diagrams) {
    for (std::size_t i = 0; i < story.frames.size(); ++i) list.push_back({i, 0, "", story.frames[i].caption});
    return list;
  }
  if (story.walkthrough.layout != Layout::search) {
    const std::size_t last = story.frames.size() - 1;
    for (std::size_t s = 0; s < story.tellings.size(); ++s) {
      const std::vector<Fact>& facts = story.frames[last].facts;
      const auto said = std::ranges::find(facts, &story.tellings[s].scene, &Fact::of);
      list.push_back({last, s, title_of_scene(story, s, story.frames[last]), said == facts.end() ? "" : said->text});
    }
    return list;
  }
  for (const std::size_t i : last_of_each_iteration(story.frames)) {
    const Frame& frame = story.frames[i];
    list.push_back({i, 0, "iteration " + std::to_string(frame.moments[0].iteration), frame.headline});
  }
  return list;
}

void draw_cell_picture(Canvas& canvas, const StagedStory& story, const Cell& cell, const Box& frame, const Look& look) {
  if (story.walkthrough.layout == Layout::diagrams) return draw_diagram(canvas, story, cell.frame, frame, look);
  const SceneOfFrame scene(story, cell.frame, cell.scene, look);
  const Box box = bounds_of_scene(story, cell.scene, cell.frame, scene.lens);
  Box room = below_title(frame, look.style).grown(-cell_margin);
  room.min.y() += room_for_arrows;
  const Place place{frame, cell.title, fit(box, room)};
  draw_scene(canvas, story, place, scene.shown);
}

/// The width of one cell; a diagram keeps the shape that it has in a frame.
int width_of_cell(const StagedStory& story) { return story.walkthrough.layout == Layout::diagrams ? 1220 : cell_width; }

double bottom_of_panel(const StagedStory& story) {
  return story.walkthrough.layout == Layout::diagrams ? cell_gap + Look().height : cell_panel_bottom;
}

render::Size size_of_cell(const StagedStory& story, const Look& look) {
  const double larger = look.style.theme.text * look.style.theme.text;  // higher lines, and more of them
  return {width_of_cell(story), static_cast<int>(bottom_of_panel(story) + caption_height * larger)};
}

/// Returns: how many cells stand in a row: all, where that can be read; else as many as make rows of the wanted shape, the last
/// as long as the others or hardly shorter.
int columns_of_strip(int count, render::Size cell) {
  if (count * cell.width <= longest_row) return count;
  const double columns = std::ceil(std::sqrt(count * wanted_shape * cell.height / cell.width));
  const int rows = static_cast<int>(std::ceil(count / columns));
  return (count + rows - 1) / rows;
}

/// In smaller letters where it would need more lines than there is room for.
void draw_caption(Canvas& canvas, const std::string& caption, const Box& room, const Style& style) {
  double part = 1;
  TextStyle text = style.fact;
  std::vector<std::string> lines = render::wrap(canvas, caption, text, room.width());
  const auto height = [&] {
    return style.scaled(line_pitch) * part * (1 + pitch_of_caption * (static_cast<double>(lines.size()) - 1));
  };
  while (height() > room.height() && part > least_caption) {
    part *= next_smaller;
    text.size = style.fact.size * part;
    lines = render::wrap(canvas, caption, text, room.width());
  }
  double y = room.min.y() + style.scaled(line_pitch) * part;
  for (const std::string& line : lines) {
    canvas.text({room.min.x(), y}, line, text);
    y += style.scaled(line_pitch * pitch_of_caption) * part;
  }
}

/// `corner`: the upper left one of the cell.
void draw_cell(Canvas& canvas, const StagedStory& story, const Cell& cell, const Vec2& corner, const Look& look) {
  const Box frame{corner + Vec2(cell_gap, cell_gap),
                  corner + Vec2(width_of_cell(story) - cell_gap, bottom_of_panel(story))};
  draw_cell_picture(canvas, story, cell, frame, look);
  draw_caption(
      canvas, cell.caption,
      {{frame.min.x(), frame.max.y()}, corner + Vec2(frame.max.x() - corner.x(), size_of_cell(story, look).height)},
      look.style);
}

// -- The frame --------------------------------------------------------------------------------------------------------

}  // namespace

render::Size page_of_frame(const Look& look) {
  if (look.text == Text::around) return frame_page;
  return {frame_page.width, look.height + 2 * margin_without_text};
}

Box pictures_of_frame(const Walkthrough& walkthrough, const Look& look) {
  Box box = box_of_panels(walkthrough, look);
  const bool has_code = walkthrough.layout == Layout::search && walkthrough.panels.algorithm && !look.stacked;
  if (has_code) box.max.x() -= algorithm_width(look.style) + panel_gap;
  return box.grown(panel_gap / 2 - 1);
}

void draw_frame(Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look) {
  if (look.text == Text::around) {
    draw_header(canvas, story.walkthrough, look.style);
    const double below = rows_of_panels(look).to;
    draw_footer(canvas, {{left_margin, below}, {right_margin, frame_page.height}}, story, index, look.style);
  }
  draw_panels(canvas, box_of_panels(story.walkthrough, look), story, index, look);
}

void draw_panels(Canvas& canvas, const Box& box, const StagedStory& story, std::size_t index, const Look& look) {
  switch (story.walkthrough.layout) {
    case Layout::search: return draw_search(canvas, box, story, index, look);
    case Layout::diagrams: return draw_diagram(canvas, story, index, box, look);
    default: return draw_pair(canvas, box, story, index, look);
  }
}

void draw_objects_alone(Canvas& canvas, const StagedStory& story, std::size_t index, std::size_t scene,
                        const Look& look) {
  const SceneOfFrame what(story, index, scene, look);
  const Box frame{Vec2::Zero(), Vec2(objects_page.width, objects_page.height)};
  draw_objects(canvas, {frame, "", view_of_objects(frame, what.shown)}, what.shown);
}

void draw_small(Canvas& canvas, const Box& box, const StagedStory& story, std::size_t index, std::size_t scene,
                const Look& look) {
  const SceneOfFrame of_frame(story, index, scene, look);
  Shown what = of_frame.shown;
  what.regions_beside = true;  // and nothing magnified: there is no room
  const Box room = below_title(box, look.style).grown(-small_margin * box.width());
  draw_scene(canvas, story, {box, "", fit(bounds_of_scene(story, scene, index, of_frame.lens), room)}, what);
}

render::Size strip_page(const StagedStory& story, const Look& look) {
  const int count = static_cast<int>(cells(story).size());
  const render::Size cell = size_of_cell(story, look);
  const int columns = columns_of_strip(count, cell);
  return {columns * cell.width, (count + columns - 1) / columns * cell.height};
}

void draw_strip(Canvas& canvas, const StagedStory& story, const Look& look) {
  const std::vector<Cell> all = cells(story);
  const render::Size size = size_of_cell(story, look);
  const int columns = columns_of_strip(static_cast<int>(all.size()), size);
  for (int i = 0; const Cell& cell : all) {
    draw_cell(canvas, story, cell, {i % columns * size.width, i / columns * size.height}, look);
    ++i;
  }
}

}  // namespace walkthroughs::picture
