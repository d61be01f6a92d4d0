/// Drawing things of a scene, flat or through a camera, on a panel: bodies, points, directions, planes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/lens.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

class Pencil {
 public:
  /// `arrow_length`: that of directions, in page units.
  Pencil(render::Panel& panel, const Lens& lens, const Style& style, double arrow_length)
      : panel_(panel), lens_(lens), style_(style), arrow_length_(arrow_length) {}
  Pencil(render::Panel& panel, const Lens& lens, const Style& style) : Pencil(panel, lens, style, style.arrow_length) {}

  render::Panel& panel() const { return panel_; }
  const Style& style() const { return style_; }
  const Lens& lens() const { return lens_; }
  render::Vec2 at(const Point& p) const { return lens_(p); }
  std::vector<render::Vec2> at(const std::vector<Point>& points) const { return lens_(points); }
  /// Returns: a vector of the scene, wherever it begins.
  render::Vec2 in_picture(const Point& vector) const { return at(vector + lens_.plane.on) - at(lens_.plane.on); }
  /// Returns: whether the picture has depth; none of a plane has.
  bool in_space() const { return lens_.camera.has_value(); }
  /// Returns: whether a direction leads anywhere in the picture; one across the plane does in none of it.
  bool is_seen(const Point& d) const { return in_space() ? !d.isZero(0) : !in_picture(d).isZero(0); }
  /// Returns: so many page units as a length in the scene.
  double length(double page_units) const { return page_units / panel_.view().scale(); }

  /// Where they reach far beyond the panel, which is magnified then: with all digits near the origin.
  void line(const Point& from, const Point& to, const render::Stroke& stroke);
  void polygon(const std::vector<Point>& corners, render::Color fill);
  /// Returns: whether a point is in the panel, its mark whole.
  bool holds(const Point& p) const { return panel_.holds(at(p), style_.point_radius); }
  void point(const Point& p, render::Color color);
  /// An arrow along `d`, named. In space its picture is shorter the more it points at the viewer.
  void direction(const Point& from, const Point& d, const render::Stroke& stroke, const std::string& name);
  /// Where nothing lies beyond `on` in direction `d`: the far half of the plane; in space a patch of the plane between.
  void out_of_reach(const Point& on, const Point& d);
  /// The border of that alone.
  void supporting_line(const Point& on, const Point& d, const render::Stroke& stroke);
  /// A cross of `arm` page units through a place of the picture.
  void cross(const render::Vec2& middle, double arm);

  /// The filled outline of a body and, in space, its faces in sight, shaded, with the edges behind thin and dashed. `lit`: of
  /// what has no faces, as from lit_parts().
  void body(const std::vector<render::Vec2>& outline, const std::vector<render::Face>& faces, render::Color fill,
            const render::Stroke& stroke, const std::vector<std::vector<render::Vec2>>& lit = {});
  /// The edges of a closed surface, those behind thin and dashed in the same colour.
  void edges(const std::vector<render::Face>& faces, const render::Stroke& stroke);

  /// Tells of something that can be taken hold of where `at` is drawn, unless that is outside of the panel. `scale`: what scenes are
  /// drawn in, in their own unit.
  void grip(render::Canvas& canvas, double scale, const std::string& name, const Point& at,
            const Eigen::Matrix3d& turned_back = Eigen::Matrix3d::Identity(), std::optional<Point> value = {}) const;

  /// Three small arrows in the lower left corner of the panel's `frame` that tell where x, y and z point. Nothing in the
  /// plane.
  void triad(render::Canvas& canvas, const render::Box& frame);

 private:
  bool is_dark() const { return style_.theme.paper.g < style_.theme.ink.g; }
  /// Returns: the fill of a surface that gets so much light.
  render::Color shaded(render::Color fill, double light) const;
  /// The outline of what is round, filled, and over it what gets more light than the rest.
  void round(const std::vector<render::Vec2>& outline, render::Color fill,
             const std::vector<std::vector<render::Vec2>>& lit);
  bool is_far(const Point& p) const;
  /// Returns: whether the origin is in the panel or near it.
  bool shows_origin() const;
  /// Returns: that of two places of the picture which is nearer to its middle.
  render::Vec2 nearer(const render::Vec2& p, const render::Vec2& q) const;
  /// Returns: a square in the plane through `on` across `d`.
  std::vector<Point> patch(const Point& on, const Point& d) const;

  render::Panel& panel_;
  const Lens& lens_;
  const Style& style_;
  const double arrow_length_;
};

/// Returns: where on the page the arrows of the triad begin.
render::Vec2 start_of_triad(const render::Box& frame);

/// Returns: the part of a convex polygon on the side of `on` that `toward` points to.
std::vector<render::Vec2> half(const std::vector<render::Vec2>& polygon, const render::Vec2& on,
                               const render::Vec2& toward);

/// Requires: at least one point.
template <class Points>
auto middle_of(const Points& points) {
  auto sum = points.front();
  sum.setZero();
  for (const auto& p : points) sum += p;
  return decltype(sum)(sum / static_cast<double>(points.size()));
}

/// Returns: the vertices of a simplex, oldest first.
std::vector<Point> points_of(const gjk::Simplex<double>& simplex);

/// Returns: the faces of a tetrahedron, seen from outside counter-clockwise, whatever the order of its vertices.
std::vector<render::Face> faces_of_tetrahedron(const std::vector<Point>& vertices);

}  // namespace walkthroughs::picture
