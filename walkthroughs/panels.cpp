#include "walkthroughs/panels.hpp"

#include <algorithm>
#include <vector>

#include "walkthroughs/words.hpp"

namespace walkthroughs {
namespace {

using gjk::Role;
using gjk::Verdict;
using render::Panel;
using render::Stroke;
using render::TextStyle;
using render::Vec2;
namespace palette = render::palette;

constexpr double arrow_length = 84;  // page units; directions have no length of their own
constexpr double point_radius = 7;

const Stroke grid_line{palette::faint, 1};
const Stroke hull_line{palette::grey, 2.5};
const Stroke added_line{palette::green, 4, {11, 9}};
const Stroke former_line{palette::grey, 2, {4, 7}};
const Stroke direction_line{palette::vermillion, 4.5};
const Stroke support_line{palette::vermillion, 2, {14, 5}};
const Stroke normal_line{palette::blue, 4};

TextStyle label_style(render::Color color, render::Weight weight = render::Weight::regular) {
  return {.size = 26, .weight = weight, .color = color, .halo = palette::white};
}

Vec2 plane(const Point& p) { return p.head<2>(); }

Bounds bounds(const std::vector<Vec2>& points) {
  Bounds box{points.front(), points.front()};
  for (const Vec2& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

std::vector<Vec2> plane(const std::vector<Point>& points) {
  std::vector<Vec2> out;
  for (const Point& p : points) out.push_back(plane(p));
  return out;
}

Vec2 middle(const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

std::vector<Vec2> points_of(const Simplex& simplex) {
  std::vector<Vec2> out;
  for (int i = 0; i < simplex.size(); ++i) out.push_back(plane(simplex[i].w));
  return out;
}

/// Returns: the part of the panel on the side of `on` that `toward` points to (Sutherland and Hodgman 1974, one edge).
std::vector<Vec2> half_plane(const Panel& panel, const Vec2& on, const Vec2& toward) {
  const std::vector<Vec2> corners = panel.corners();
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double at_p = toward.dot(p - on), at_q = toward.dot(q - on);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p < 0) != (at_q < 0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  return kept;
}

void draw_point(Panel& panel, const Vec2& at, render::Color color) {
  panel.disc(at, point_radius + 2, palette::white);
  panel.disc(at, point_radius, color);
}

/// An arrow of the usual length along `d`, named.
void draw_arrow(Panel& panel, const Vec2& from, const Vec2& d, const Stroke& stroke, const std::string& name) {
  const Vec2 unit = d.normalized();
  const Vec2 to = from + unit * (arrow_length / panel.view().scale());
  panel.arrow(from, to, stroke);
  panel.label(from + (to - from) * 0.8, Vec2(-unit.y(), unit.x()), name, label_style(stroke.color, render::Weight::bold));
}

/// The line through `on` at right angles to `d`: nothing of the set lies beyond it.
void draw_supporting_line(Panel& panel, const Vec2& on, const Vec2& d) {
  const Vec2 along = Vec2(-d.y(), d.x()).normalized() * 4000 / panel.view().scale();
  panel.line(on - along, on + along, support_line);
}

void draw_frame_and_title(render::Canvas& canvas, const Place& place) {
  const render::Box& f = place.frame;
  const Vec2 corners[] = {f.min, {f.max.x(), f.min.y()}, f.max, {f.min.x(), f.max.y()}};
  canvas.outline(corners, {palette::faint, 1.5});
  canvas.text(f.min + Vec2(14, 28), place.title, {.size = 20, .color = palette::grey, .halo = palette::white});
}

/// What both pictures of a difference set share.
class DifferencePicture {
 public:
  DifferencePicture(Panel& panel, const LabelledHull& hull, const Moment& now)
      : panel_(panel), hull_(hull), now_(now), center_(middle(hull.corners)) {}

  void set() {
    panel_.grid(1, grid_line);
    panel_.polygon(hull_.corners, palette::faint.with_alpha(110));
    panel_.outline(hull_.corners, hull_line);
  }

  void corner_names() {
    for (const Vec2& corner : hull_.corners) name(corner);
  }

  void name(const Vec2& corner) {
    const bool in_simplex = std::ranges::count(points_of(now_.simplex), corner) > 0;
    panel_.label(corner, corner - center_, hull_.name({corner.x(), corner.y(), 0}),
                 label_style(palette::ink, in_simplex ? render::Weight::bold : render::Weight::regular));
  }

  void origin() {
    panel_.plus(Vec2::Zero(), 10, {palette::ink, 3.5});
    panel_.label(Vec2::Zero(), center_, "O", label_style(palette::ink));
  }

  /// The half plane that the tested normal points to, or the triangle where the origin lies inside.
  void tested_region() {
    const auto& region = now_.regions.back();
    const bool chosen = region.verdict == Verdict::chosen;
    const render::Color shade = chosen ? palette::green.with_alpha(64) : palette::grey.with_alpha(44);
    const std::string label = region.label + (chosen ? " ✓" : " ✗");
    if (region.feature == "ABC") {
      panel_.polygon(points_of(now_.simplex), shade);
      panel_.label(middle(points_of(now_.simplex)), {0, 1}, label, label_style(palette::ink));
    } else if (region.normal) {
      const Vec2 from = plane(now_.simplex.point(Role::A));
      const Vec2 to = plane(now_.simplex.point(region.feature == "AB" ? Role::B : Role::C));
      const std::vector<Vec2> beyond = half_plane(panel_, from, plane(*region.normal));
      panel_.polygon(beyond, shade);
      draw_arrow(panel_, (from + to) / 2, plane(*region.normal), normal_line,
                 Letters(now_.simplex, hull_).translate(region.feature + "n"));
      panel_.label(middle(beyond), plane(*region.normal), label, label_style(palette::ink));
    }
  }

  /// The part of the plane where no point of the set can lie, because the support function has looked.
  void beyond_found() {
    const Vec2 w = plane(now_.found->w), d = plane(now_.direction->value);
    panel_.polygon(half_plane(panel_, w, d), palette::orange.with_alpha(50));
    draw_supporting_line(panel_, w, d);
  }

  void segments() {
    for (const auto& [from, to] : now_.segments) panel_.line(plane(from), plane(to), former_line);
    const std::vector<Vec2> corners = points_of(now_.simplex);
    if (corners.size() == 3) panel_.polygon(corners, palette::green.with_alpha(40));
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j) panel_.line(corners[i], corners[j], added_line);
  }

  void vertices() {
    for (const Vec2& corner : points_of(now_.simplex)) draw_point(panel_, corner, palette::green);
    if (now_.simplex.size() > 0) ring(plane(now_.simplex.point(Role::A)), palette::green);
    if (now_.found) {
      draw_point(panel_, plane(now_.found->w), palette::vermillion);
      ring(plane(now_.found->w), palette::vermillion);
    }
  }

  void dropped() {
    for (const char role : now_.reduction->dropped) {
      const Vec2 at = plane(now_.reduction->before.point(static_cast<Role>(role - 'A')));
      const double arm = 11 / panel_.view().scale();
      panel_.line(at - Vec2(arm, arm), at + Vec2(arm, arm), {palette::ink, 3.5});
      panel_.line(at - Vec2(arm, -arm), at + Vec2(arm, -arm), {palette::ink, 3.5});
    }
  }

  void direction() {
    if (!now_.direction) return;
    const Simplex& from = now_.direction->from;
    draw_arrow(panel_, from.size() == 0 ? center_ : middle(points_of(from)), plane(now_.direction->value), direction_line, "d");
  }

 private:
  void ring(const Vec2& at, render::Color color) { panel_.circle(at, point_radius + 5, {color, 2.5}); }

  Panel& panel_;
  const LabelledHull& hull_;
  const Moment& now_;
  const Vec2 center_;
};

}  // namespace

Bounds bounds_of_objects(const Scene& scene) {
  std::vector<Vec2> points = plane(scene.a.vertices);
  std::ranges::copy(plane(scene.b.vertices), std::back_inserter(points));
  return bounds(points);
}

Bounds bounds_of_difference(const LabelledHull& hull) {
  std::vector<Vec2> points = hull.corners;
  points.push_back(Vec2::Zero());
  return bounds(points);
}

void draw_objects(render::Canvas& canvas, const Place& place, const Scene& scene, const Moment& now) {
  draw_frame_and_title(canvas, place);
  Panel panel(canvas, place.frame, place.view);
  panel.grid(1, grid_line);
  const std::vector<Vec2> a = plane(scene.a.vertices), b = plane(scene.b.vertices);
  panel.polygon(a, palette::sky.with_alpha(110));
  panel.polygon(b, palette::orange.with_alpha(110));
  panel.outline(a, {palette::blue, 3});
  panel.outline(b, {palette::ink, 3});
  const Vec2 d = plane(now.direction->value);
  if (now.found) {
    const Vec2 at_a = plane(now.found->a.point), at_b = plane(now.found->b.point);
    draw_supporting_line(panel, at_a, d);
    draw_supporting_line(panel, at_b, d);
    draw_arrow(panel, at_a, d, direction_line, "d");
    draw_arrow(panel, at_b, -d, direction_line, "−d");
    draw_point(panel, at_a, palette::blue);
    draw_point(panel, at_b, palette::ink);
    panel.label(at_a, -d, "a", label_style(palette::blue, render::Weight::bold));
    panel.label(at_b, d, "b", label_style(palette::ink, render::Weight::bold));
  }
  panel.label(middle(a), {0, 1}, scene.a.name, label_style(palette::blue));
  panel.label(middle(b), {0, -1}, scene.b.name, label_style(palette::ink));
  panel.place_labels();
}

void draw_difference(render::Canvas& canvas, const Place& place, const LabelledHull& hull, const Moment& now, Focus focus) {
  draw_frame_and_title(canvas, place);
  Panel panel(canvas, place.frame, place.view);
  DifferencePicture picture(panel, hull, now);
  picture.set();
  if (focus == Focus::region) picture.tested_region();
  if (now.found && (focus == Focus::support || focus == Focus::crossing || (now.result && now.result->separation)))
    picture.beyond_found();
  picture.segments();
  if (focus == Focus::support || focus == Focus::crossing || focus == Focus::direction) picture.direction();
  picture.vertices();
  if (focus == Focus::reduction) picture.dropped();
  picture.origin();
  picture.corner_names();
  panel.place_labels();
}

void draw_move(render::Canvas& canvas, const Place& place, const LabelledHull& hull, const Moment& now, Focus focus) {
  draw_frame_and_title(canvas, place);
  Panel panel(canvas, place.frame, place.view);
  DifferencePicture picture(panel, hull, now);
  picture.set();
  if (now.found) picture.beyond_found();
  picture.segments();
  picture.direction();
  if (focus == Focus::crossing) {
    const Vec2 e = plane(now.found->w);
    panel.arrow(Vec2::Zero(), e, normal_line);
    panel.label(e / 2, {-e.y(), e.x()}, "O" + hull.name(now.found->w), label_style(palette::blue, render::Weight::bold));
    draw_arrow(panel, Vec2::Zero(), plane(now.direction->value), direction_line, "d");
  }
  picture.vertices();
  picture.origin();
  for (const Vec2& corner : points_of(now.simplex)) picture.name(corner);
  if (now.found) picture.name(plane(now.found->w));
  panel.place_labels();
}

}  // namespace walkthroughs
