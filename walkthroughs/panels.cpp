#include "walkthroughs/panels.hpp"

#include <algorithm>
#include <functional>
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

// Page units.
constexpr double title_height = 36;
constexpr double arrow_length = 60;  // directions have no length of their own
constexpr double point_radius = 7;
constexpr double line_label_gap = 9;
constexpr double key_pitch = 54;  // a sign with the space around it
constexpr double page_diagonal = 1500;

const Stroke grid_line{palette::faint, 1};
const Stroke hull_line{palette::grey, 2.5};
const Stroke added_line{palette::green, 4, {11, 9}};
const Stroke move_line{palette::green, 2, {11, 9}};
const Stroke former_line{palette::ink, 2.5, {3, 7}};
const Stroke direction_line{palette::vermillion, 4.5};
const Stroke support_line{palette::vermillion, 2, {14, 5}};
const Stroke normal_line{palette::blue, 4};
const Stroke thin_line{palette::grey, 1.5, {2, 5}};
const Stroke projection_line{palette::ink.with_alpha(90), 9};
const render::Color out_of_reach = palette::orange.with_alpha(50);

TextStyle label_style(render::Color color, render::Weight weight = render::Weight::regular) {
  return {.size = 26, .weight = weight, .color = color, .halo = palette::white};
}
const TextStyle small_label{.size = 22, .color = palette::ink, .halo = palette::white};

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

/// Returns: the part of a polygon on the side of `on` that `toward` points to.
std::vector<Vec2> half(const std::vector<Vec2>& polygon, const Vec2& on, const Vec2& toward) {
  return render::clip_polygon(polygon, toward, -toward.dot(on));
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
  panel.label(from + (to - from) * 0.8, Vec2(-unit.y(), unit.x()), name,
              label_style(stroke.color, render::Weight::bold));
}

/// A line across the whole panel through `on`, at right angles to `normal`.
void draw_line_across(Panel& panel, const Vec2& on, const Vec2& normal, const Stroke& stroke) {
  const Vec2 along = Vec2(-normal.y(), normal.x()).normalized() * (page_diagonal / panel.view().scale());
  panel.line(on - along, on + along, stroke);
}

// -- Title and key ----------------------------------------------------------------------------------------------------

const TextStyle title_style{.size = 20, .color = palette::grey};

/// A sign and what it stands for; `draw` gets the middle of the sign.
struct KeyEntry {
  std::string text;
  std::function<void(render::Canvas&, const Vec2&)> draw;
};

KeyEntry swatch(const std::string& text, render::Color fill, render::Color outline) {
  return {text, [=](render::Canvas& canvas, const Vec2& at) {
            const render::Box box{at - Vec2(9, 7), at + Vec2(9, 7)};
            const Vec2 corners[] = {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
            canvas.polygon(corners, fill);
            canvas.outline(corners, {outline, 2.5});
          }};
}

KeyEntry dashes(const std::string& text, const Stroke& stroke) {
  return {text,
          [=](render::Canvas& canvas, const Vec2& at) { canvas.line(at - Vec2(15, 0), at + Vec2(15, 0), stroke); }};
}

KeyEntry ringed_point(const std::string& text) {
  return {text, [=](render::Canvas& canvas, const Vec2& at) {
            canvas.disc(at, point_radius - 1, palette::green);
            canvas.circle(at, point_radius + 3, {palette::ink, 2});
          }};
}

/// An area with the supporting line as its border.
KeyEntry far_side(const std::string& text) {
  return {text, [=](render::Canvas& canvas, const Vec2& at) {
            canvas.rectangle({at - Vec2(15, 8), at + Vec2(15, 8)}, out_of_reach);
            canvas.line(at + Vec2(-15, -8), at + Vec2(15, -8), support_line);
          }};
}

/// Draws the frame of a panel, its title at the left and its key at the right, if there is room for it.
void draw_title(render::Canvas& canvas, const Place& place, const std::vector<KeyEntry>& key) {
  const render::Box& f = place.frame;
  const Vec2 corners[] = {f.min, {f.max.x(), f.min.y()}, f.max, {f.min.x(), f.max.y()}};
  canvas.outline(corners, {palette::faint, 1.5});
  canvas.line(below_title(f).min, {f.max.x(), below_title(f).min.y()}, {palette::faint, 1.5});
  const double baseline = f.min.y() + 26;
  canvas.text({f.min.x() + 14, baseline}, place.title, title_style);
  const auto width = [&](const std::string& text) { return canvas.text_box({0, 0}, text, title_style).width(); };
  double needed = width(place.title);
  for (const KeyEntry& entry : key) needed += key_pitch + width(entry.text);
  if (needed > f.width() - 28) return;
  double x = f.max.x() - 14;
  for (auto entry = key.rbegin(); entry != key.rend(); ++entry) {
    x -= width(entry->text);
    canvas.text({x, baseline}, entry->text, title_style);
    entry->draw(canvas, {x - 23, baseline - 7});
    x -= key_pitch;
  }
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
    const Point w(corner.x(), corner.y(), 0);
    panel_.label(corner, corner - center_, hull_.name(w),
                 label_style(palette::ink, in_simplex(w) ? render::Weight::bold : render::Weight::regular));
  }

  void origin() {
    panel_.plus(Vec2::Zero(), 10, {palette::ink, 3.5});
    panel_.label(Vec2::Zero(), center_, "O", label_style(palette::ink));
  }

  /// Where the origin would have to lie for the tested region to be chosen, and whether it does.
  void tested_region() {
    const auto& region = now_.regions.back();
    if (region.feature == "ABC") shade(points_of(now_.simplex), region);
    if (region.feature.size() != 2) return;
    const Vec2 from = plane(now_.simplex.point(Role::A));
    const Vec2 to = plane(now_.simplex.point(region.feature == "AB" ? Role::B : Role::C));
    if (region.normal)
      beyond_edge(region, from, to);
    else
      beside_segment(region, from, to);
  }

  /// The part of the plane where no point of the set can lie, because the support function has looked.
  void beyond_found() {
    const Vec2 w = plane(now_.found->w), d = plane(now_.direction->value);
    panel_.polygon(half(panel_.corners(), w, d), out_of_reach);
    draw_line_across(panel_, w, d, support_line);
  }

  /// Eq. 9: the vector from the origin to the point found, and d, drawn from the origin. The origin was crossed where
  /// the foot of that vector on the line of d lies ahead of the origin.
  void crossing() {
    const Vec2 w = plane(now_.found->w), d = plane(now_.direction->value);
    draw_line_across(panel_, Vec2::Zero(), {-d.y(), d.x()}, thin_line);
    panel_.line(Vec2::Zero(), projection(), projection_line);
    panel_.arrow(Vec2::Zero(), w - w.normalized() * ((point_radius + 6) / panel_.view().scale()), normal_line);
    panel_.label(w / 2, {-w.y(), w.x()}, "O" + hull_.name(now_.found->w),
                 label_style(palette::blue, render::Weight::bold), line_label_gap);
    draw_arrow(panel_, Vec2::Zero(), d, direction_line, "d");
  }

  void name_projection() {
    panel_.label(projection(), projection(), hull_.name(now_.found->w) + "·d", small_label, line_label_gap);
  }

  void segments() {
    const std::vector<Vec2> corners = points_of(now_.simplex);
    for (const auto& [from, to] : now_.segments)
      if (!in_simplex(from) || !in_simplex(to)) panel_.line(plane(from), plane(to), former_line);
    if (corners.size() == 3) panel_.polygon(corners, palette::green.with_alpha(40));
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j) panel_.line(corners[i], corners[j], added_line);
    if (now_.found && !in_simplex(now_.found->w))
      for (const Vec2& corner : corners) panel_.line(corner, plane(now_.found->w), move_line);
  }

  void vertices() {
    for (const Vec2& corner : points_of(now_.simplex)) draw_point(panel_, corner, palette::green);
    if (now_.found && !in_simplex(now_.found->w)) draw_point(panel_, plane(now_.found->w), palette::vermillion);
    if (now_.found)
      newest(plane(now_.found->w));
    else if (now_.simplex.size() > 0)
      newest(plane(now_.simplex.point(Role::A)));
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
    draw_arrow(panel_, from.size() == 0 ? center_ : middle(points_of(from)), plane(now_.direction->value),
               direction_line, "d");
  }

 private:
  /// Returns: the foot of w on the line through the origin along d. The sign of w·d tells on which side of the origin.
  Vec2 projection() const {
    const Vec2 d = plane(now_.direction->value);
    return d * (*now_.crossing->value / d.squaredNorm());
  }

  void shade(const std::vector<Vec2>& area, const gjk::RegionTested<double>& region) {
    const bool chosen = region.verdict == Verdict::chosen;
    panel_.polygon(area, chosen ? palette::green.with_alpha(64) : palette::grey.with_alpha(44));
    // Without the crossing test the ends of a segment are not ruled out: nothing is certain yet.
    const bool uncertain = now_.crossing->verdict == gjk::Crossing::switched_off && region.simplex_size == 2;
    panel_.name_area(area, region.label + (uncertain ? ", if not R2" : chosen ? " ✓" : " ✗"), small_label);
  }

  /// R3 or R7 of a triangle, on the outer side of an edge.
  void beyond_edge(const gjk::RegionTested<double>& region, const Vec2& a, const Vec2& b) {
    const Vec2 outward = plane(*region.normal);
    shade(half(panel_.corners(), a, outward), region);
    draw_line_across(panel_, a, outward, thin_line);
    draw_arrow(panel_, (a + b) / 2, outward, normal_line, Letters(now_.simplex, hull_).translate(region.feature + "n"));
  }

  /// R3 or R4 of the segment from A to B, between the lines across its ends; beyond them lie R1 and R2.
  void beside_segment(const gjk::RegionTested<double>& region, const Vec2& a, const Vec2& b) {
    const std::vector<Vec2> beyond_a = half(panel_.corners(), a, a - b), beyond_b = half(panel_.corners(), b, b - a);
    const Vec2 toward_origin = plane(std::get<Point>(region.value));
    shade(half(half(half(panel_.corners(), a, toward_origin), a, b - a), b, a - b), region);
    draw_line_across(panel_, a, a - b, thin_line);
    draw_line_across(panel_, b, a - b, thin_line);
    panel_.name_area(beyond_a, "R2", small_label);
    panel_.name_area(beyond_b, "R1", small_label);
  }

  bool in_simplex(const Point& w) const { return std::ranges::count(points_of(now_.simplex), plane(w)) > 0; }

  void newest(const Vec2& at) { panel_.circle(at, point_radius + 5, {palette::ink, 2.5}); }

  Panel& panel_;
  const LabelledHull& hull_;
  const Moment& now_;
  const Vec2 center_;
};

}  // namespace

Bounds bounds_of_objects(const Scene& scene) {
  std::vector<Vec2> points = plane(vertices_of(scene.a));
  std::ranges::copy(plane(vertices_of(scene.b)), std::back_inserter(points));
  return bounds(points);
}

Bounds bounds_of_difference(const LabelledHull& hull) {
  std::vector<Vec2> points = hull.corners;
  points.push_back(Vec2::Zero());
  return bounds(points);
}

Bounds bounds_of_move(const Moment& now) {
  std::vector<Vec2> points = points_of(now.simplex);
  if (now.found) points.push_back(plane(now.found->w));
  points.push_back(Vec2::Zero());
  points.push_back(plane(now.direction->value).normalized());
  return bounds(points);
}

render::Box below_title(const render::Box& frame) { return {frame.min + Vec2(0, title_height), frame.max}; }

int draw_objects(render::Canvas& canvas, const Place& place, const Scene& scene, const Moment& now, Focus focus) {
  draw_title(canvas, place,
             {swatch(scene.a.name, palette::sky.with_alpha(110), palette::blue),
              swatch(scene.b.name, palette::orange.with_alpha(110), palette::ink)});
  Panel panel(canvas, below_title(place.frame), place.view);
  panel.grid(1, grid_line);
  const std::vector<Vec2> a = plane(vertices_of(scene.a)), b = plane(vertices_of(scene.b));
  panel.polygon(a, palette::sky.with_alpha(110));
  panel.polygon(b, palette::orange.with_alpha(110));
  panel.outline(a, {palette::blue, 3});
  panel.outline(b, {palette::ink, 3});
  const Vec2 d = plane(now.direction->value);
  if (now.found) {
    const Vec2 at_a = plane(now.found->a.point), at_b = plane(now.found->b.point);
    if (focus == Focus::support || focus == Focus::crossing) {
      draw_line_across(panel, at_a, d, support_line);
      draw_line_across(panel, at_b, d, support_line);
    }
    draw_arrow(panel, at_a, d, direction_line, "d");
    draw_arrow(panel, at_b, -d, direction_line, "−d");
    draw_point(panel, at_a, palette::blue);
    draw_point(panel, at_b, palette::ink);
    panel.label(at_a, -d, "a", label_style(palette::blue, render::Weight::bold));
    panel.label(at_b, d, "b", label_style(palette::ink, render::Weight::bold));
  } else {
    draw_arrow(panel, middle(a), d, direction_line, "d");
    draw_arrow(panel, middle(b), -d, direction_line, "−d");
  }
  return panel.place_labels();
}

int draw_difference(render::Canvas& canvas, const Place& place, const LabelledHull& hull, const Moment& now,
                    Focus focus) {
  draw_title(canvas, place,
             {ringed_point("newest"), dashes("simplex", added_line), dashes("earlier", former_line),
              far_side("out of reach")});
  Panel panel(canvas, below_title(place.frame), place.view);
  DifferencePicture picture(panel, hull, now);
  picture.set();
  const bool separated = now.result && now.result->separation;
  const bool searching = focus == Focus::support || focus == Focus::crossing || separated;
  if (focus == Focus::region) picture.tested_region();
  if (now.found && searching) picture.beyond_found();
  picture.segments();
  if (focus == Focus::support || focus == Focus::direction || separated) picture.direction();
  if (focus == Focus::crossing) picture.crossing();
  picture.vertices();
  if (focus == Focus::reduction) picture.dropped();
  picture.origin();
  picture.corner_names();
  return panel.place_labels();
}

int draw_move(render::Canvas& canvas, const Place& place, const LabelledHull& hull, const Moment& now, Focus focus) {
  draw_title(canvas, place, {ringed_point("newest"), far_side("out of reach")});
  Panel panel(canvas, below_title(place.frame), place.view);
  DifferencePicture picture(panel, hull, now);
  picture.set();
  if (now.found) picture.beyond_found();
  picture.segments();
  picture.direction();
  if (focus == Focus::crossing) {
    picture.crossing();
    picture.name_projection();
  }
  picture.vertices();
  picture.origin();
  for (const Vec2& corner : points_of(now.simplex)) picture.name(corner);
  if (now.found) picture.name(plane(now.found->w));
  return panel.place_labels();
}

}  // namespace walkthroughs
