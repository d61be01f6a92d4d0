#include "walkthroughs/picture/draw.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "walkthroughs/picture/footer.hpp"
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
constexpr double panels_height = 448, margin_without_text = 20;
constexpr double title_top = 18, below_title_line = 24;  // around the line of the title
constexpr double share_of_space = 0.4, decision_margin = 34;
constexpr double line_pitch = 30;
constexpr double unlimited = std::numeric_limits<double>::infinity();
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
  if (look.text == Text::none) return {margin_without_text, margin_without_text + panels_height};
  return {title_top + look.style.scaled(30) + below_title_line, frame_page.height - footer_height(look.style)};
}

Box panel_box(double left, double right, const Interval& rows) { return {{left, rows.from}, {right, rows.to}}; }

/// One scene of one frame, as it is drawn.
struct SceneOfFrame {
  SceneOfFrame(const StagedStory& story, std::size_t frame, std::size_t scene)
      : stage(story.stages[scene]),
        now(story.drawn(frame, scene)),
        names(story.walkthrough.naming, stage.telling->hull, now),
        focus(story.frames[frame].focus_of(scene)),
        is_parting(story.frames[frame].focus == Focus::parting) {}
  SceneOfFrame(const SceneOfFrame&) = delete;  // names refer to it
  SceneOfFrame& operator=(const SceneOfFrame&) = delete;

  Shown shown(const Lens& lens, const Look& look) const {
    return {*stage.telling, stage, now, names, focus, lens, look.style, look.values, false, is_parting};
  }

  const Stage& stage;
  const Moment now;
  const Names names;
  const Focus focus;
  const bool is_parting;
};

Lens turned(const Lens& lens, double degrees) {
  return lens.camera && degrees != 0 ? Lens{lens.camera->turned(degrees)} : lens;
}

// -- Around the panels ------------------------------------------------------------------------------------------------

/// The title, smaller where it is long, and the source as far as there is room for it.
void draw_header(Canvas& canvas, const Walkthrough& walkthrough, const Style& style) {
  const std::string title = literal(walkthrough.title);
  TextStyle heading = style.title;
  const double baseline = title_top + heading.size;
  const double width = canvas.text_box({0, 0}, title, heading).width(), room = right_margin - left_margin;
  if (width > room) heading.size *= room / width;
  canvas.text({left_margin, baseline}, title, heading);
  TextStyle source = style.small;
  source.align = render::Align::right;
  if (canvas.text_box({right_margin, baseline}, walkthrough.source, source).min.x() > left_margin + width + panel_gap)
    canvas.text({right_margin, baseline}, walkthrough.source, source);
}

// -- One scene --------------------------------------------------------------------------------------------------------

/// The panels of a search from left to right: objects, difference, algorithm.
struct Columns {
  std::optional<Box> objects, algorithm;
  Box difference;
};

/// `is_decision`: the view in space stands where the objects are in other frames.
Columns columns(const Panels& panels, const Interval& rows, bool is_decision, const Style& style) {
  double left = left_margin, right = right_margin;
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

/// At most at that scale, and no larger than what doubles can place.
View fit(const Bounds& bounds, const Box& room, double max_scale = unlimited) {
  const double farthest = std::max(bounds.low.cwiseAbs().maxCoeff(), bounds.high.cwiseAbs().maxCoeff());
  const double sharp = most_page_units / (farthest > 0 ? farthest : 1);
  return View::fit(bounds.low, bounds.high, room, std::min(max_scale, sharp));
}

/// Where a simplex would be small in the whole set, its regions are shown close up; beside the plane pictures of a decision
/// from the vertex that joins it to those that leave it, so that nothing jumps.
bool is_close_up(const Shown& what, const Box& room) {
  const bool is_beside = what.regions_beside && what.focus != Focus::crossing;
  if ((what.focus != Focus::region && !is_beside) || what.now.processed.size() < 2) return false;
  const double whole = fit(bounds_of_difference(what.telling, what.stage, what.lens), room).scale();
  return fit(bounds_of_decision(what.now, what.lens), room).scale() > least_magnification * whole;
}

View view_of_difference(const Shown& what, const Box& room) {
  return is_close_up(what, room) ? fit(bounds_of_decision(what.now, what.lens), room)
                                 : fit(bounds_of_difference(what.telling, what.stage, what.lens), room);
}

/// The difference beside the picture of a decision, small.
int draw_beside(Canvas& canvas, const Box& frame, const Shown& what) {
  Shown beside = what;
  beside.regions_beside = true;
  const View view = view_of_difference(what, below_title(frame, what.style).grown(-decision_margin));
  return draw_difference(canvas, {frame, "a − b", view}, beside);
}

/// The view in space beside the plane pictures of its decision, which are what to look at first. At the end the objects
/// stand there: the gap that is seen in the plane is a gap between them.
int draw_decision_in_space(Canvas& canvas, const Columns& boxes, const std::vector<DecisionView>& views,
                           const Shown& what) {
  if (what.focus == Focus::end && what.telling.panels.objects) {
    const View objects = fit(bounds_of_objects(what.telling, what.stage, what.lens),
                             below_title(*boxes.objects, what.style).grown(-objects_margin));
    return draw_objects(canvas, {*boxes.objects, "", objects}, what) +
           draw_decision(canvas, boxes.difference, views, what);
  }
  return draw_beside(canvas, *boxes.objects, what) + draw_decision(canvas, boxes.difference, views, what);
}

/// Short where the letters are large: the key stands beside it.
std::string title_of_difference(bool is_close_up, const Style& style) {
  if (style.theme.text > 1) return is_close_up ? "close up" : "a − b";
  return is_close_up ? "a − b, close up" : "difference a − b";
}

/// The difference, and where asked for the objects.
int draw_whole_set(Canvas& canvas, const Columns& boxes, const Shown& what) {
  const Box room = below_title(boxes.difference, what.style).grown(-difference_margin);
  const bool is_near = is_close_up(what, room);
  View view = view_of_difference(what, room);
  int crowded = 0;
  if (boxes.objects) {
    const Bounds objects = bounds_of_objects(what.telling, what.stage, what.lens);
    const Box room_left = below_title(*boxes.objects, what.style).grown(-objects_margin);
    View left = fit(objects, room_left);
    if (!what.lens.camera && !is_near) {  // One scale for both, so that a length in one panel is the same in the other.
      const double scale = std::min(left.scale(), view.scale());
      left = fit(objects, room_left, scale);
      view = view.with_scale(scale);
    }
    crowded = draw_objects(canvas, {*boxes.objects, "", left}, what);
  }
  return crowded + draw_difference(canvas, {boxes.difference, title_of_difference(is_near, what.style), view}, what);
}

int draw_search(Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look) {
  const Telling& telling = *story.stages[0].telling;
  const Lens lens = turned(story.stages[0].lens, look.turn);
  const SceneOfFrame scene(story, index, 0);
  const Shown what = scene.shown(lens, look);
  const std::vector<DecisionView> views =
      shows_decision(story) ? decision_views(what.now, what.focus) : std::vector<DecisionView>{};
  const std::optional<NumberLine> line =
      telling.panels.decision ? number_line(what.now, what.focus, what.names) : std::nullopt;
  const Columns boxes = columns(telling.panels, rows_of_panels(look), !views.empty() || line, look.style);
  const int crowded = line            ? draw_beside(canvas, *boxes.objects, what)
                      : views.empty() ? draw_whole_set(canvas, boxes, what)
                                      : draw_decision_in_space(canvas, boxes, views, what);
  if (line) draw_number_line(canvas, boxes.difference, *line, what);
  if (boxes.algorithm && look.code) draw_algorithm(canvas, *boxes.algorithm, what);
  return crowded;
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

Bounds bounds_of_scene(const StagedStory& story, std::size_t scene, std::size_t frame, const Lens& lens) {
  return shows_a_move(story) ? bounds_of_move(story.drawn(frame, scene), lens)
                             : bounds_of_difference(*story.stages[scene].telling, story.stages[scene], lens);
}

int draw_scene(Canvas& canvas, const StagedStory& story, const Place& place, const Shown& what) {
  return shows_a_move(story) ? draw_move(canvas, place, what) : draw_difference(canvas, place, what);
}

int draw_pair(Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look) {
  const double middle = (left_margin + right_margin) / 2;
  const Interval rows = rows_of_panels(look);
  const Box boxes[] = {panel_box(left_margin, middle - panel_gap / 2, rows),
                       panel_box(middle + panel_gap / 2, right_margin, rows)};
  const auto view = [&](std::size_t s, const Lens& lens, double scale) {
    const std::size_t last = story.frames.size() - 1;  // of which the bounds are, so that nothing jumps
    return fit(bounds_of_scene(story, s, last, lens), below_title(boxes[s], look.style).grown(-difference_margin),
               scale);
  };
  const Lens lenses[] = {turned(story.stages[0].lens, look.turn), turned(story.stages[1].lens, look.turn)};
  const double scale = std::min(view(0, lenses[0], unlimited).scale(), view(1, lenses[1], unlimited).scale());
  int crowded = 0;
  for (std::size_t s = 0; s < 2; ++s) {
    const SceneOfFrame scene(story, index, s);
    crowded +=
        draw_scene(canvas, story, {boxes[s], title_of_scene(story, s, story.frames[index]), view(s, lenses[s], scale)},
                   scene.shown(lenses[s], look));
  }
  return crowded;
}

// -- The strip --------------------------------------------------------------------------------------------------------

// In page units.
constexpr int cell_width = 420, caption_height = 104;
constexpr double cell_gap = 10, cell_panel_bottom = 386, cell_margin = 44;

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
      std::string said;
      for (const Fact& fact : story.frames[last].facts)
        if (said.empty() && fact.text.starts_with(story.tellings[s].scene.name)) said = fact.text;
      list.push_back({last, s, title_of_scene(story, s, story.frames[last]), said});
    }
    return list;
  }
  for (const std::size_t i : last_of_each_iteration(story.frames)) {
    const Frame& frame = story.frames[i];
    list.push_back({i, 0, "iteration " + std::to_string(frame.moments[0].iteration), frame.headline});
  }
  return list;
}

int draw_cell_picture(Canvas& canvas, const StagedStory& story, const Cell& cell, const Box& frame, const Look& look) {
  if (story.walkthrough.layout == Layout::diagrams) return story.diagrams[cell.frame].draw(canvas, frame, look.style);
  const Lens lens = turned(story.stages[cell.scene].lens, look.turn);
  const SceneOfFrame scene(story, cell.frame, cell.scene);
  const Bounds box = bounds_of_scene(story, cell.scene, cell.frame, lens);
  const Place place{frame, cell.title, fit(box, below_title(frame, look.style).grown(-cell_margin))};
  return draw_scene(canvas, story, place, scene.shown(lens, look));
}

/// The width of one cell; a diagram keeps the shape that it has in a frame.
int width_of_cell(const StagedStory& story) { return story.walkthrough.layout == Layout::diagrams ? 1220 : cell_width; }

double bottom_of_panel(const StagedStory& story) {
  return story.walkthrough.layout == Layout::diagrams ? cell_gap + panels_height : cell_panel_bottom;
}

int draw_cell(Canvas& canvas, const StagedStory& story, const Cell& cell, double left, const Look& look) {
  const Box frame{{left + cell_gap, cell_gap}, {left + width_of_cell(story) - cell_gap, bottom_of_panel(story)}};
  const int crowded = draw_cell_picture(canvas, story, cell, frame, look);
  double y = frame.max.y() + look.style.scaled(line_pitch);
  for (const std::string& line : render::wrap(canvas, cell.caption, look.style.fact, frame.width())) {
    canvas.text({frame.min.x(), y}, line, look.style.fact);
    y += look.style.scaled(line_pitch * 0.95);
  }
  return crowded;
}

// -- The frame --------------------------------------------------------------------------------------------------------

int draw_panels(Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look) {
  switch (story.walkthrough.layout) {
    case Layout::search: return draw_search(canvas, story, index, look);
    case Layout::diagrams:
      return story.diagrams[index].draw(canvas, panel_box(left_margin, right_margin, rows_of_panels(look)), look.style);
    default: return draw_pair(canvas, story, index, look);
  }
}

}  // namespace

render::Size page_of_frame(Text text) {
  if (text == Text::around) return frame_page;
  return {frame_page.width, static_cast<int>(panels_height + 2 * margin_without_text)};
}

Box pictures_of_frame(const Walkthrough& walkthrough, const Look& look) {
  const bool has_code = walkthrough.layout == Layout::search && walkthrough.panels.algorithm;
  const double right = has_code ? right_margin - algorithm_width(look.style) - panel_gap : right_margin;
  return panel_box(left_margin, right, rows_of_panels(look)).grown(panel_gap / 2 - 1);
}

int draw_frame(Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look) {
  if (look.text != Text::around) return draw_panels(canvas, story, index, look);
  draw_header(canvas, story.walkthrough, look.style);
  const Box below{{left_margin, rows_of_panels(look).to}, {right_margin, frame_page.height}};
  const int left_out = draw_footer(canvas, below, story, index, look.style);
  return draw_panels(canvas, story, index, look) + left_out;
}

render::Size strip_page(const StagedStory& story, const Look& look) {
  const double larger = look.style.theme.text * look.style.theme.text;  // higher lines, and more of them
  const int height = static_cast<int>(bottom_of_panel(story) + caption_height * larger);
  return {width_of_cell(story) * static_cast<int>(cells(story).size()), height};
}

int draw_strip(Canvas& canvas, const StagedStory& story, const Look& look) {
  int crowded = 0;
  double left = 0;
  for (const Cell& cell : cells(story)) {
    crowded += draw_cell(canvas, story, cell, left, look);
    left += width_of_cell(story);
  }
  return crowded;
}

}  // namespace walkthroughs::picture
