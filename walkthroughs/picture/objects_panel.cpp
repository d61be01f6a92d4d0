#include <algorithm>
#include <optional>
#include <utility>

#include "walkthroughs/picture/light.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/picture/pencil.hpp"

namespace walkthroughs::picture {
namespace {

using render::Vec2;

constexpr double least_object = 18, ring_radius = 16;  // page units

KeyEntry swatch(const std::string& text, render::Color fill, const render::Stroke& outline) {
  return {text,
          [=](render::Canvas& canvas, const Vec2& at) {
            const render::Box box{at - Vec2(9, 7), at + Vec2(9, 7)};
            canvas.rectangle(box, fill);
            canvas.outline(box.corners(), {outline.color, 2.5});
          },
          10, true};
}

/// The flat parts of a round object: those in sight whole, the others as far as they lie behind thin and dashed.
void draw_flats(Pencil& pencil, const Body& body, const render::Stroke& stroke) {
  if (!pencil.in_space()) return;
  for (const Flat& flat : body.flats) {
    const bool seen = pencil.lens().camera->sees(flat.outward);
    const render::Stroke thin{stroke.color, stroke.width / 2, seen ? render::Dash{} : pencil.style().hidden_edge.dash};
    pencil.panel().outline(pencil.at(flat.rim), thin);
  }
}

/// One that is too small to be found beside the other has a ring around it, and its name.
void draw_object(Pencil& pencil, const Object& object, const Body& body, render::Color fill,
                 const render::Stroke& stroke) {
  const std::vector<Vec2> corners = outline(object, body, pencil.lens());
  const bool is_round = pencil.in_space() && body.faces.empty();
  pencil.body(corners, body.faces, fill, stroke,
              is_round ? lit_parts(object, pencil.lens()) : std::vector<std::vector<Vec2>>{});
  draw_flats(pencil, body, stroke);
  const render::Box box = render::Box::around(corners);
  if (box.longer_side() >= pencil.length(least_object)) return;
  pencil.panel().circle(box.center(), ring_radius, {stroke.color, 2});
  pencil.panel().label(box.center(), {0, 1}, literal(object.name), pencil.style().small_label());
}

/// Where their surfaces cross, as far as it is in sight, on a border of paper: no edge of either.
void draw_crossing(Pencil& pencil, const std::vector<CrossingPiece>& crossing) {
  const Style& style = pencil.style();
  for (const render::Stroke& stroke : {style.crossing_border, style.crossing})
    for (const CrossingPiece& piece : crossing)
      if (pencil.lens().sees(piece.outward_a) && pencil.lens().sees(piece.outward_b))
        pencil.line(piece.from, piece.to, stroke);
}

// -- What can be taken hold of, called as scene files call it ----------------------------------------------------------

constexpr std::size_t most_grips = 64;  // of one object: more would cover it

/// Its middle, by which it is moved as a whole, and its corners, each in the object's own place.
void add_grips(render::Canvas& canvas, const Pencil& pencil, double scale, const std::string& key, const Object& object,
               const Point& middle) {
  pencil.grip(canvas, scale, key, middle);
  const std::vector<Point> corners = vertices_of(object);
  for (std::size_t i = 0; i < std::min(corners.size(), most_grips); ++i)
    pencil.grip(canvas, scale, key + ".points[" + std::to_string(i) + "]", corners[i],
                object.pose.rotation.transpose());
}

/// The tip of the first direction, as long as it is drawn; where that is out of sight, a point before it.
void add_grip_of_direction(render::Canvas& canvas, const Pencil& pencil, double scale, const Point& from,
                           const Point& d) {
  const Point whole = d.stableNormalized() * pencil.length(pencil.style().arrow_length);
  for (const Point& arrow : {whole, Point(0.6 * whole), Point(0.3 * whole)})
    if (pencil.holds(from + arrow))
      return pencil.grip(canvas, scale, "first_direction", from + arrow, Eigen::Matrix3d::Identity(), arrow / scale);
}

Point middle_of_object(const Object& object, const Body& body) {
  if (!body.vertices.empty()) return middle_of(body.vertices);
  return object.pose(middle(object.form));
}

}  // namespace

render::Box bounds_of_objects(const Stage& stage, const Lens& lens) {
  std::vector<Vec2> points = outline(stage.telling->scene.a, stage.a, lens);
  const std::vector<Vec2> b = outline(stage.telling->scene.b, stage.b, lens);
  points.insert(points.end(), b.begin(), b.end());
  return render::Box::around(points);
}

void draw_objects(render::Canvas& canvas, const Place& place, const Shown& shown) {
  const Style& style = shown.style;
  const Scene& scene = shown.telling.scene;
  const render::Box room = draw_panel_title(canvas, place.frame, place.title, style,
                                            {swatch(literal(scene.a.name), style.object_a_fill, style.object_a),
                                             swatch(literal(scene.b.name), style.object_b_fill, style.object_b)});
  render::Panel panel(canvas, room, view_in(room, place.frame, place.view, style));
  Pencil pencil(panel, shown.lens, style);
  const Placing& placing = shown.stage.placing;
  if (!pencil.in_space()) panel.grid(placing.scale, style.grid, pencil.at(Point(-placing.center * placing.scale)));
  draw_object(pencil, scene.a, shown.stage.a, style.object_a_fill, style.object_a);
  draw_object(pencil, scene.b, shown.stage.b, style.object_b_fill, style.object_b);
  draw_crossing(pencil, shown.stage.crossing);
  pencil.triad(canvas, place.frame);
  const Point middle_a = middle_of_object(scene.a, shown.stage.a), middle_b = middle_of_object(scene.b, shown.stage.b);
  if (shown.grips) {
    add_grips(canvas, pencil, placing.scale, "a", scene.a, middle_a);
    add_grips(canvas, pencil, placing.scale, "b", scene.b, middle_b);
  }
  if (!shown.now.direction) {  // nothing of a search
    panel.label(pencil.at(middle_a), Vec2::Zero(), "a", style.label(style.object_a.color, render::Weight::bold));
    panel.label(pencil.at(middle_b), Vec2::Zero(), "b", style.label(style.object_b.color, render::Weight::bold));
    return canvas.add_crowded(panel.place_labels(style.smallest_label()));
  }
  const Point d = shown.now.direction->value;
  if (shown.grips && shown.now.processed.size() == 0)
    add_grip_of_direction(canvas, pencil, placing.scale, shown.now.found ? shown.now.found->a.point : middle_a, d);
  if (!shown.now.found) {
    pencil.direction(middle_a, d, style.direction, "d");
    pencil.direction(middle_b, -d, style.direction, "−d");
    return canvas.add_crowded(panel.place_labels(style.smallest_label()));
  }
  const Point &a = shown.now.found->a.point, &b = shown.now.found->b.point;
  if ((shown.focus == Focus::support || shown.focus == Focus::crossing) && !pencil.in_space()) {
    pencil.supporting_line(a, d, style.support_line);
    pencil.supporting_line(b, d, style.support_line);
  }
  const Vec2 along = pencil.at(d);
  panel.label(pencil.at(a), -along, "a", style.label(style.object_a.color, render::Weight::bold));
  panel.label(pencil.at(b), along, "b", style.label(style.object_b.color, render::Weight::bold));
  if (shown.focus != Focus::reduction && shown.focus != Focus::kept) {  // which choose another d
    pencil.direction(a, d, style.direction, "d");
    pencil.direction(b, -d, style.direction, "−d");
  }
  pencil.point(a, style.object_a.color);
  pencil.point(b, style.object_b.color);
  canvas.add_crowded(panel.place_labels(style.smallest_label()));
}

}  // namespace walkthroughs::picture
