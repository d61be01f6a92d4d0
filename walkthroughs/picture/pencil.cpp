#include "walkthroughs/picture/pencil.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/length.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/light.hpp"
#include "walkthroughs/picture/near_origin.hpp"

namespace walkthroughs::picture {
namespace {

using render::Stroke;
using render::Vec2;

constexpr double least_strength = 0.35, added_strength = 0.3;  // of a fill, with most light and least on white paper
constexpr double page_diagonal = 1500;                         // page units: longer than any panel
constexpr double farthest_end = 1e5, reach = 1e4;              // beyond the first a line is drawn as far as the second
constexpr double patch_half_side = 110;                        // page units
constexpr double triad_length = 30, triad_margin = 48, least_between_names = 14, least_named_axis = 0.3;
constexpr double name_beyond_tip = 9, name_beside_tip = 13, name_rise = 5, least_from_axis = 7;

/// The three axes of a triad in the picture, and where their names stand.
struct Triad {
  Vec2 start;
  Vec2 tips[3];

  /// Returns: where to write the name of an axis: beyond its tip; beside it where another axis runs there.
  Vec2 place_of_name(int axis) const {
    const Vec2 unit = (tips[axis] - start).stableNormalized(), beside(-unit.y(), unit.x());
    const Vec2 beyond = tips[axis] + unit * name_beyond_tip;
    if (clearance(axis, beyond) >= least_from_axis) return beyond;
    const Vec2 left = tips[axis] - beside * name_beside_tip, right = tips[axis] + beside * name_beside_tip;
    return clearance(axis, right) > clearance(axis, left) ? right : left;
  }

 private:
  /// Returns: how far a place is from the other axes.
  double clearance(int axis, const Vec2& place) const {
    double least = std::numeric_limits<double>::infinity();
    for (int other = 0; other < 3; ++other)
      if (other != axis) least = std::min(least, render::distance_to_segment(place, start, tips[other]));
    return least;
  }
};

/// Returns: two unit vectors that span the plane across `d`, the first level where possible.
std::pair<Point, Point> span_across(const Point& d) {
  const Point unit = d.stableNormalized();
  const Point level = unit.cross(Point::UnitZ());
  const Point first = level.norm() > 1e-3 ? Point(level.normalized()) : unit.unitOrthogonal();
  return {first, unit.cross(first)};
}

}  // namespace

bool Pencil::shows_origin() const { return panel_.holds(at(Point::Zero()), -reach); }

Vec2 Pencil::nearer(const Vec2& p, const Vec2& q) const {
  const Vec2 middle = middle_of(panel_.corners());
  return render::length_of(p - middle) < render::length_of(q - middle) ? p : q;
}

bool Pencil::is_far(const Point& p) const { return panel_.view().page(at(p)).cwiseAbs().maxCoeff() > farthest_end; }

void Pencil::line(const Point& from, const Point& to, const Stroke& stroke) {
  if (!shows_origin() || (!is_far(from) && !is_far(to))) return panel_.line(at(from), at(to), stroke);
  const auto [near_from, near_to] = part_near_origin(from, to, length(reach));
  panel_.line(at(near_from), at(near_to), stroke);
}

void Pencil::polygon(const std::vector<Point>& corners, render::Color fill) {
  const std::vector<Vec2> picture = at(corners);
  if (std::ranges::none_of(corners, [this](const Point& p) { return is_far(p); })) return panel_.polygon(picture, fill);
  std::vector<Vec2> seen = panel_.corners();
  const double sense = render::signed_area(picture) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    const Vec2 along = (picture[next] - picture[i]) * sense;
    const Vec2 on = shows_origin() ? at(foot_on_line(corners[i], corners[next])) : nearer(picture[i], picture[next]);
    seen = half(seen, on, {-along.y(), along.x()});
  }
  if (seen.size() > 2) panel_.polygon(seen, fill);
}

void Pencil::point(const Point& p, render::Color color) { draw_point(panel_, at(p), color, style_); }

void Pencil::direction(const Point& from, const Point& d, const Stroke& stroke, const std::string& name) {
  if (!is_seen(d) || !d.allFinite()) return;  // it leads nowhere
  const Point to = from + d.stableNormalized() * length(arrow_length_);
  const Vec2 tail = at(from), tip = at(to), along = tip - tail;
  panel_.arrow(tail, tip, stroke);
  panel_.label(tail + along * 0.8, Vec2(-along.y(), along.x()), name, style_.label(stroke.color, render::Weight::bold));
}

std::vector<Point> Pencil::patch(const Point& on, const Point& d) const {
  const auto [u, v] = span_across(d);
  const double half_side = length(patch_half_side);
  return {on + (u + v) * half_side, on + (u - v) * half_side, on - (u + v) * half_side, on - (u - v) * half_side};
}

void Pencil::supporting_line(const Point& on, const Point& d, const Stroke& stroke) {
  if (!is_seen(d)) return;
  if (in_space()) {
    panel_.outline(at(patch(on, d)), stroke);
    return;
  }
  const Vec2 normal = in_picture(d);
  const Vec2 along = Vec2(-normal.y(), normal.x()).stableNormalized() * length(page_diagonal);
  panel_.line(at(on) - along, at(on) + along, stroke);
}

void Pencil::out_of_reach(const Point& on, const Point& d) {
  if (!is_seen(d)) return;
  if (in_space())
    polygon(patch(on, d), style_.out_of_reach);
  else
    panel_.polygon(half(panel_.corners(), at(on), in_picture(d.stableNormalized())), style_.out_of_reach);
  supporting_line(on, d, style_.support_line);
}

void Pencil::cross(const Vec2& middle, double arm) {
  const Vec2 up(length(arm), length(arm)), down(length(arm), -length(arm));
  panel_.line(middle - up, middle + up, style_.cross);
  panel_.line(middle - down, middle + down, style_.cross);
}

void Pencil::edges(const std::vector<render::Face>& faces, const Stroke& stroke) {
  const std::vector<render::Edge> all = render::edges_of(faces, *lens_.camera);
  const Stroke behind{stroke.color.with_alpha(170), style_.hidden_edge.width, style_.hidden_edge.dash};
  for (const render::Edge& edge : all)
    if (edge.hidden) line(edge.from, edge.to, behind);
  for (const render::Edge& edge : all)
    if (!edge.hidden) line(edge.from, edge.to, stroke);
}

render::Color Pencil::shaded(render::Color fill, double light) const {
  const double strength = least_strength + (1 - least_strength + added_strength) * (is_dark() ? light : 1 - light);
  return fill.with_alpha(static_cast<std::uint8_t>(std::min(255.0, fill.a * strength)));
}

void Pencil::round(const std::vector<Vec2>& outline, render::Color fill, const std::vector<std::vector<Vec2>>& lit) {
  if (lit.empty()) return panel_.polygon(outline, fill);
  double now = shaded(fill, light_steps[0] - 0.1).a;
  panel_.polygon(outline, fill.with_alpha(static_cast<std::uint8_t>(now)));
  for (std::size_t i = 0; i < lit.size(); ++i) {  // paper makes what is translucent paler; more of the fill brighter
    const double next = shaded(fill, light_steps[i]).a, ratio = is_dark() ? (next - now) / (255 - now) : 1 - next / now;
    const render::Color over = is_dark() ? fill : style_.theme.paper;
    if (lit[i].size() > 2) panel_.polygon(lit[i], over.with_alpha(static_cast<std::uint8_t>(std::lround(255 * ratio))));
    now = next;
  }
}

void Pencil::body(const std::vector<Vec2>& outline, const std::vector<render::Face>& faces, render::Color fill,
                  const Stroke& stroke, const std::vector<std::vector<Vec2>>& lit) {
  if (outline.size() == 1) {
    panel_.disc(outline[0], style_.point_radius, stroke.color);
    return;
  }
  if (faces.empty() || !in_space()) {
    if (outline.size() > 2) round(outline, fill, lit);
    panel_.outline(outline, stroke);
    return;
  }
  for (const render::Face& face : faces)  // in any order: of a convex body none in sight covers another
    if (const Point outward = face.outward(); lens_.camera->sees(outward))
      polygon(face.corners, shaded(fill, light_on(outward, *lens_.camera)));
  edges(faces, stroke);
}

Vec2 start_of_triad(const render::Box& frame) { return {frame.min.x() + triad_margin, frame.max.y() - triad_margin}; }

void Pencil::grip(render::Canvas& canvas, double scale, const std::string& name, const Point& at,
                  const Eigen::Matrix3d& turned_back, std::optional<Point> value) const {
  if (!holds(at)) return;
  const double unit = length(1) / scale;
  const Point right = in_space() ? lens_.camera->right() : Point::UnitX(),
              up = in_space() ? lens_.camera->up() : Point::UnitY();
  canvas.add_grip({name, panel_.view().page(this->at(at)), turned_back * right * unit, turned_back * up * unit, value});
}

void Pencil::triad(render::Canvas& canvas, const render::Box& frame) {
  if (!in_space()) return;
  const Vec2 start = start_of_triad(frame);
  panel_.disc(panel_.view().scene(start), triad_margin - 2, style_.theme.paper.with_alpha(170));
  const render::TextStyle text{.size = style_.scaled(17), .color = style_.theme.grey, .align = render::Align::center};
  const char* const names[] = {"x", "y", "z"};
  Triad axes{start, {}};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2 picture = (*lens_.camera)(Point::Unit(axis));
    axes.tips[axis] = start + Vec2(picture.x(), -picture.y()) * triad_length;
  }
  std::vector<Vec2> named;
  for (int axis = 0; axis < 3; ++axis) {
    canvas.arrow(start, axes.tips[axis], {style_.theme.grey, 2});
    if ((axes.tips[axis] - start).norm() <= least_named_axis * triad_length) continue;
    Vec2 at = axes.place_of_name(axis) + Vec2(0, style_.scaled(name_rise));
    for (const Vec2& other : named)
      if ((at - other).norm() < style_.scaled(least_between_names))
        at = other + Vec2(0, at.y() < other.y() ? -1 : 1) * style_.scaled(least_between_names);
    named.push_back(at);
    canvas.text(at, names[axis], text);
    panel_.keep_clear(canvas.ink_box(at, names[axis], text));
  }
}

std::vector<Vec2> half(const std::vector<Vec2>& polygon, const Vec2& on, const Vec2& toward) {
  return render::clip_polygon(polygon, toward, -toward.dot(on));
}

std::vector<Point> points_of(const gjk::Simplex<double>& simplex) {
  std::vector<Point> points;
  for (int i = 0; i < simplex.size(); ++i) points.push_back(simplex[i].w);
  return points;
}

std::vector<render::Face> faces_of_tetrahedron(const std::vector<Point>& v) {
  const int corners[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};  // the last is not on the face
  std::vector<render::Face> faces;
  for (const auto& [i, j, k, opposite] : corners) {
    const auto at = [&](int index) -> const Point& { return v[static_cast<std::size_t>(index)]; };
    render::Face face{{at(i), at(j), at(k)}};
    if (face.outward().dot(at(opposite) - at(i)) > 0) std::swap(face.corners[1], face.corners[2]);
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace walkthroughs::picture
