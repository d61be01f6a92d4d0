#include <algorithm>
#include <functional>

#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/lens.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::catalogue {
namespace {

using render::Panel;
using render::Vec2;

constexpr double margin = 18;       // page units
constexpr int questions = 360;      // directions in which the difference is asked for its farthest point
constexpr double name_height = 22;  // of the middle of a line's name above the edge
constexpr double any_scale = 1e9;

/// What the two panels show, in scene units.
const Vec2 objects_low(-3.15, -2.4), objects_high(3.15, 2.4), difference_low(-5.9, -2.4), difference_high(0.8, 2.4);

const Point plus_x(1, 0, 0);

Vec2 plane(const Point& p) { return p.head<2>(); }

using PointSet = gjk::PointSet<double>;

/// Everything that the three frames show. Section 2.4 puts the points of C farthest along +x on the line x = -1 and those of D
/// farthest along -x on x = 1; "multiple points could be selected" of both.
struct Example {
  PointSet C{{{-1, 1, 0}, {-1, -1, 0}, {-3, -0.5, 0}}}, D{{{1, -1, 0}, {1, 1, 0}, {2.5, 0.5, 0}}};
  gjk::Vertex<double> farthest = gjk::MinkowskiDifference<double, PointSet, PointSet>(C, D).vertex(plus_x);
  std::vector<Vec2> outline = outline_by_support(gjk::MinkowskiDifference<double, PointSet, PointSet>(C, D), questions);
};

enum class Step { sets, supports, difference };

/// The line x = `x` across the whole panel, named.
void draw_level(Panel& panel, double x, const Style& style) {
  const std::vector<Vec2> corners = panel.corners();
  const double bottom = std::min(corners[0].y(), corners[2].y()), top = std::max(corners[0].y(), corners[2].y());
  panel.line({x, bottom}, {x, top}, style.support_line);
  panel.label({x, bottom + name_height / panel.view().scale()}, {1, 0}, "x = " + number(x),
              style.label(style.theme.vermillion), 10);
}

void draw_arrow(Panel& panel, const Vec2& from, double sign, const std::string& name, const Style& style) {
  const Vec2 to = from + Vec2(sign * style.arrow_length / panel.view().scale(), 0);
  panel.arrow(from, to, style.direction);
  panel.label((from + to) / 2, {0, 1}, name, style.label(style.theme.vermillion, render::Weight::bold), 12);
}

/// The points that are as far as the one returned, and the one returned.
void draw_farthest(Panel& panel, const std::vector<Vec2>& points, const Vec2& returned, const Style& style) {
  for (const Vec2& p : points)
    if (p.x() == returned.x() && p != returned) draw_hollow_point(panel, p, style.theme.vermillion, style);
  draw_point(panel, returned, style.theme.vermillion, style);
}

void draw_supports(Panel& panel, const Example& example, const Style& style) {
  const Vec2 c = plane(example.farthest.a.point), d = plane(example.farthest.b.point);
  draw_level(panel, c.x(), style);
  draw_level(panel, d.x(), style);
  draw_farthest(panel, Lens{}(example.C.points()), c, style);
  draw_farthest(panel, Lens{}(example.D.points()), d, style);
  draw_arrow(panel, c, 1, "+x", style);
  draw_arrow(panel, d, -1, "−x", style);
  panel.label(c, {-1, 0.25}, "support(C, +x)", style.small_label(), 10);
  panel.label(d, {1, -0.25}, "support(D, −x)", style.small_label(), 10);
}

int draw_sets(render::Canvas& canvas, const render::Box& frame, const Style& style, const Example& example, Step step,
              double scale) {
  const render::Box room = draw_panel_title(canvas, frame, "the triangles C and D", style);
  Panel panel(canvas, room, render::View::fit(objects_low, objects_high, room.grown(-margin), scale));
  panel.grid(1, style.grid);
  const std::vector<Vec2> c = Lens{}(example.C.points()), d = Lens{}(example.D.points());
  panel.polygon(c, style.object_a_fill);
  panel.outline(c, style.object_a);
  panel.polygon(d, style.object_b_fill);
  panel.outline(d, style.object_b);
  draw_origin(panel, style);
  if (step != Step::sets) draw_supports(panel, example, style);
  panel.name_area(c, "C", style.label(style.theme.ink, render::Weight::bold));
  panel.name_area(d, "D", style.label(style.theme.ink, render::Weight::bold));
  return panel.place_labels(style.smallest_label());
}

int draw_difference(render::Canvas& canvas, const render::Box& frame, const Style& style, const Example& example,
                    Step step, double scale) {
  const render::Box room = draw_panel_title(canvas, frame, "their Minkowski Difference Mdiff(C, D)", style);
  Panel panel(canvas, room, render::View::fit(difference_low, difference_high, room.grown(-margin), scale));
  panel.grid(1, style.grid);
  draw_origin(panel, style);
  const Vec2 w = plane(example.farthest.w);
  if (step == Step::difference) {
    panel.polygon(example.outline, style.hull_fill);
    panel.outline(example.outline, style.hull);
    draw_level(panel, w.x(), style);
    draw_farthest(panel, example.outline, w, style);
    draw_arrow(panel, w, 1, "+x", style);
    panel.name_area(example.outline, "Mdiff(C, D)", style.label(style.theme.ink, render::Weight::bold));
  }
  if (step != Step::sets) {
    draw_point(panel, w, style.theme.vermillion, style);
    panel.label(w, {-1, 0.2}, "w", style.label(style.theme.vermillion, render::Weight::bold));
  }
  return panel.place_labels(style.smallest_label());
}

int draw_example(const Example& example, Step step, render::Canvas& canvas, const render::Box& box,
                 const Style& style) {
  const std::vector<render::Box> frames = side_by_side(box, 2);
  // One scale for both, so that a length in one panel is the same length in the other.
  const auto scale_of = [&](const Vec2& low, const Vec2& high) {
    return render::View::fit(low, high, below_title(frames[0], style).grown(-margin), any_scale).scale();
  };
  const double scale = std::min(scale_of(objects_low, objects_high), scale_of(difference_low, difference_high));
  return draw_sets(canvas, frames[0], style, example, step, scale) +
         draw_difference(canvas, frames[1], style, example, step, scale);
}

std::vector<Diagram> figure_3_diagrams() {
  const Example example;
  const Point c = example.farthest.a.point, d = example.farthest.b.point, w = example.farthest.w;
  const std::string any = "; any point of that side would do";
  const std::string choices = "the report also names (0, −1) and (0, 1), against its own x = −1 and x = 1";
  return {
      Diagram{"Of two triangles C and D, the support point of Mdiff(C, D) along +x is looked for.",
              {"Mdiff(C, D): the differences X − Y of all points X of C and Y of D (Eq. 4)"},
              "Left, triangle C on one side of the origin O and triangle D on the other, each with an upright side "
              "facing the origin. Right, an empty plane with the origin, for their difference.",
              std::bind_front(draw_example, example, Step::sets)},
      Diagram{
          "The point w = support(C, +x) − support(D, −x) needs no other point of Mdiff (Eq. 8).",
          {"support(C, +x) = " + vector(c) + ", on the line x = " + number(c.x()) + any,
           "support(D, −x) = " + vector(d) + ", on the line x = " + number(d.x()) + any, choices},
          "The upright side of C lies on the dashed line x = -1, that of D on x = 1. One end of each is filled: the "
          "point that the support function returned. The other end, as far, is hollow. Right, a single point w.",
          std::bind_front(draw_example, example, Step::supports)},
      Diagram{
          "No point of Mdiff(C, D) lies farther along +x than w.",
          {"w = support(C, +x) − support(D, −x) = " + vector(c) + " − " + vector(d) + " = " + vector(w),
           "x = " + number(w.x()) + ", whichever points of the two sides are taken",
           "outline: " + std::to_string(questions) + " directions asked, " + std::to_string(example.outline.size()) +
               " corners found; O is not inside"},
          "Left as before. Right the Minkowski Difference, a polygon left of the origin. Its upright right side lies "
          "on the dashed line x = -2. The end w of it that was found is filled, the other end is hollow.",
          std::bind_front(draw_example, example, Step::difference)}};
}

}  // namespace

std::vector<Walkthrough> figure_3() {
  return {diagrams_of("figure-3", "Figure 3: two triangles and their Minkowski Difference", "Sections 2.3 and 2.4",
                      "the support point of the difference, from the support points of two triangles",
                      figure_3_diagrams)};
}

}  // namespace walkthroughs::catalogue
