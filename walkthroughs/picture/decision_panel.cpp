#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/inset.hpp"
#include "walkthroughs/picture/near_origin.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/picture/pencil.hpp"
#include "walkthroughs/picture/region_picture.hpp"

namespace walkthroughs::picture {
namespace {

using gjk::Role;
using gjk::Roles;
using Kind = DecisionView::Kind;
using Region = gjk::RegionTested<double>;
using render::Box;
using render::Stroke;
using render::Vec2;
using render::View;

// Page units.
constexpr double gap = 8, margin = 42, narrow_margin = 30, low_margin = 34, flat_margin = 46, least_height = 24,
                 wanted_height = 60;
constexpr double most_margin = 0.32;                        // above and below, of the room
constexpr double right_angle_side = 9, normal_length = 40;  // for which there is little room
constexpr double narrow = 300, narrow_text = 0.8;           // a view that has no room for words
constexpr double share_of_true_shape = 0.58;                // of the panel, where it decides
constexpr double share_of_base = 0.31;                      // of what is left behind, below the faces of a tetrahedron
constexpr double rounding = 1e-12;  // of a length: below that it is what a projection has rounded
constexpr double dropped_arm = 9;   // of the cross through a vertex that leaves the simplex
constexpr double deepest = 0.9;     // of the fourth vertex that is shown, in widths of the face

Point vertex(const Shown& shown, Role role) { return shown.now.processed.point(role); }

/// Returns: the role of the vertex of a tetrahedron that is not on that face.
Role fourth(const Roles& face) {
  for (const Role role : {Role::B, Role::C, Role::D})
    if (!face.has(role)) return role;
  return Role::A;
}

/// One view, ready to be drawn.
class DecisionPicture {
 public:
  DecisionPicture(const Box& frame, const DecisionView& view, const Shown& shown, bool is_alone)
      : frame_(frame),
        view_(view),
        shown_(shown),
        style_(shown.style),
        is_alone_(is_alone),
        room_(below_title(frame, shown.style)),
        lens_{std::nullopt, view.plane} {
    bounds = bounds_now();
    stretch();
  }

  View fit() const {
    const double across = frame_.width() < narrow        ? narrow_margin
                          : view_.kind == Kind::crossing ? style_.arrow_length + gap  // d leads from the origin
                                                         : margin;
    const double upright = std::min(margin_below(), most_margin * room_.height());
    const double most =
        bounds.longer_side() > 0 ? std::numeric_limits<double>::infinity() : 1;  // where all is one point
    return View::fit(bounds.min, bounds.max, room_.grown(-Vec2(across, upright)), most);
  }

  /// Draws the title and the key, which leave less room where they take several lines.
  void draw_head(render::Canvas& canvas) { room_ = draw_panel_title(canvas, frame_, title(), style_, key()); }

  /// After the head.
  void draw(render::Canvas& canvas, const View& view) {
    render::Panel panel(canvas, room_, view);
    Pencil pencil(panel, lens_, style_, normal_length);
    switch (view_.kind) {
      case Kind::crossing: crossing(pencil); break;
      case Kind::segment:
      case Kind::true_shape: flat(pencil); break;
      case Kind::edge_on: edge_on(pencil); break;
    }
    finish_with_insets(canvas, panel, at_origin(), insets_in(view), style_, [this](render::Panel& magnified) {
      const Style small = style_of_inset(style_);
      const Shown inside = shown_.in(small);
      DecisionPicture(frame_, view_, inside, is_alone_).inset(magnified);
    });
    if (shown_.grips) tell_origin(canvas, panel);
  }

  Box bounds;  ///< what must be shown, in scene units

 private:
  /// What a small picture around the origin shows.
  void inset(render::Panel& panel) {
    lens_.plane.on = Point::Zero();  // coordinates near the origin keep their digits
    Pencil pencil(panel, lens_, style_, style_.arrow_length);
    draw_regions_in_plane(pencil, shown_, view_.face);
    edges(pencil);
    panel.drop_labels();
    vertices(pencil);
    name_origin(panel, -middle_of(corners()));
  }

  void tell_origin(render::Canvas& canvas, const render::Panel& panel) const {
    if (view_.kind != Kind::true_shape && view_.kind != Kind::edge_on) return;
    const Plane& plane = lens_.plane;
    const double unit = 1 / (panel.view().scale() * shown_.stage.placing.scale);
    canvas.add_grip({difference_grip_of(view_.face, view_.kind == Kind::edge_on),
                     panel.view().page(lens_(Point::Zero())), plane.right * (unit / plane.stretch.x()),
                     plane.up * (unit / plane.stretch.y()), std::nullopt, frame_});
  }

  /// Chooses how much what decides is stretched: an origin that stands nearer to its plane than its mark is wide is told
  /// from one in the plane.
  void stretch() {
    if (view_.kind != Kind::edge_on && view_.kind != Kind::crossing) return;
    const double length = std::abs(view_.height) * fit().scale();
    if (length == 0 || length >= least_height) return;
    (view_.kind == Kind::crossing ? lens_.plane.stretch.x() : lens_.plane.stretch.y()) =
        round_factor(wanted_height / length);
    bounds = bounds_now();
  }

  /// Returns: what must be shown where things are stretched as now.
  Box bounds_now() const {
    Box box = Box::around(corners());
    box.add(at_origin());
    if (view_.kind == Kind::true_shape) box = box.grown(0.1 * (box.max - box.min));  // room for the regions around
    if (view_.kind == Kind::crossing) box.add({0, -0.15 * box.max.y()});             // room for the product
    if (view_.kind != Kind::edge_on) return box;
    box.add({box.min.x(), -0.35 * at_origin().y()});  // room for the normal, or for names
    if (!is_alone_) return box;
    const double width = box.width();
    for (const double side : {-0.22, 0.18})
      box.add({box.min.x(), side * width});  // so that an empty side is seen to be empty
    if (has_fourth() && lens_.plane.stretch.y() == 1) {
      const Vec2 at = lens_(vertex(shown_, fourth(view_.face)));
      if (std::abs(at.y()) <= deepest * width) box.add(at);
    }
    return box;
  }

  double margin_below() const {
    if (is_alone_) return margin;
    return view_.kind == Kind::true_shape ? flat_margin : low_margin;
  }

  /// Returns: where the origin stands in the picture; in an edge-on view as high as the search has computed.
  Vec2 at_origin() const {
    const Vec2 at = lens_(Point::Zero());
    return view_.kind == Kind::edge_on ? Vec2(at.x(), lens_.plane.stretch.y() * view_.height) : at;
  }

  /// Returns: where a vertex stands. Seen edge-on a triangle's own corners lie on its line, whatever rounding says.
  Vec2 at(Role role) const {
    const Vec2 place = lens_(vertex(shown_, role));
    const bool is_on_line = view_.kind == Kind::edge_on && view_.face.has(role);
    return is_on_line ? Vec2(place.x(), 0) : place;
  }

  std::vector<Vec2> corners() const {
    std::vector<Vec2> points;
    for (const Role role : view_.face) points.push_back(at(role));
    if (view_.kind == Kind::crossing) points.push_back(at_found());
    return points;
  }
  /// Returns: where P stands, as far along d as the search has computed.
  Vec2 at_found() const { return {lens_.plane.stretch.x() * view_.height, lens_(shown_.now.found->w).y()}; }

  /// Around the foot of the origin, where it stands near an edge.
  std::vector<Inset> insets_in(const View& view) const {
    if (view_.kind != Kind::true_shape && view_.kind != Kind::segment) return {};
    Surroundings around{at_origin(), {}, {}, {}, {}};
    for (int i = 0; i < view_.face.size(); ++i) {
      const Role from = view_.face[i], to = view_.face[(i + 1) % view_.face.size()];
      around.shape.emplace_back(at(from), at(to));
      around.vertices.push_back(at(from) - around.origin);
      const Point foot = foot_on_line(vertex(shown_, from), vertex(shown_, to));
      const Vec2 seen = lens_(lens_.plane.on + foot);  // from below or above the origin
      const double distance = seen.norm();
      if (distance > rounding * foot.norm()) around.nearest.push_back({seen, distance});
    }
    return insets_of(around, room_, view, shown_.telling.panels.close_up, style_);
  }

  void mark_origin(render::Panel& panel) {
    if (view_.kind == Kind::segment)
      draw_origin_among(panel, at_origin(), corners(), style_);
    else
      draw_origin_beside(panel, at_origin(), view_.height, style_);
  }

  std::vector<KeyEntry> key() const {
    std::vector<KeyEntry> key;
    if (view_.kind == Kind::crossing) {
      if (lens_.plane.stretch.x() != 1)
        key.push_back(key_of_stretch("along d", {1, 0}, lens_.plane.stretch.x(), style_));
      key.push_back(key_of_line(shown_.names.of(shown_.now.found->w) + "·d / |d|", style_.projection));
      key.push_back(key_of_out_of_reach("out of reach", style_));
    }
    if (view_.kind == Kind::edge_on && lens_.plane.stretch.y() != 1)
      key.push_back(key_of_stretch("heights", {0, 1}, lens_.plane.stretch.y(), style_));
    const bool hatches = view_.kind == Kind::true_shape && !shown_.now.regions.empty();
    if (hatches) key.push_back(key_of_skipped(style_));
    const bool has_no_key_in_space = face_in_question(shown_.now, shown_.focus).empty();  // there the origin is a plus
    if (view_.kind == Kind::edge_on && has_no_key_in_space && frame_.width() >= narrow)
      std::ranges::move(key_of_origin(view_.height, style_), std::back_inserter(key));
    return key;
  }

  bool has_fourth() const { return view_.kind == Kind::edge_on && shown_.now.processed.size() == 4; }

  std::string title() const {
    const std::string face = shown_.names.sorted(view_.face);
    switch (view_.kind) {
      case Kind::crossing: return "plane of d and O" + shown_.names.of(shown_.now.found->w);
      case Kind::segment: return "plane of " + face + " and O";
      case Kind::true_shape: return face + (style_.theme.text > 1 ? " in true shape" : " from above, in true shape");
      case Kind::edge_on:
        if (view_.is_left_behind()) return face + " edge-on, hatched: left behind";
        return frame_.width() < narrow ? face : face + " edge-on";
    }
    return "";
  }

  // -- Parts --

  render::TextStyle label(render::Color color, render::Weight weight = render::Weight::regular) const {
    render::TextStyle text = style_.label(color, weight);
    if (frame_.width() < narrow) text.size *= narrow_text;
    return text;
  }

  void vertices(Pencil& pencil) {
    render::Panel& panel = pencil.panel();
    const Vec2 middle = middle_of(corners());
    Roles vertices = view_.face;
    if (has_fourth()) vertices.add(fourth(view_.face));
    for (const Role role : vertices) {
      if (!panel.holds(at(role), style_.point_radius + 7)) continue;  // stretched too far
      panel.disc(at(role), style_.point_radius + 2, style_.theme.paper);
      if (is_dropped(role))
        pencil.cross(at(role), dropped_arm);
      else
        panel.disc(at(role), style_.point_radius, style_.theme.green);
      if (role == Role::A) panel.circle(at(role), style_.point_radius + 5, {style_.theme.ink, 2.5});
      const bool is_on_line = view_.kind == Kind::edge_on && at(role).y() == 0;
      panel.label(at(role), is_on_line ? Vec2(0, view_.height < 0 ? 1 : -1) : Vec2(at(role) - middle),
                  shown_.names.of(role),
                  is_dropped(role) ? label(style_.theme.grey) : label(style_.theme.ink, render::Weight::bold));
    }
  }

  bool is_dropped(Role role) const {
    return shown_.focus == Focus::reduction && shown_.now.reduction->dropped().has(role);
  }
  /// Whether the triangle stays and only its order changes, so that its normal turns over.
  bool is_turned_over() const {
    return shown_.focus == Focus::reduction && shown_.now.processed.size() == 3 &&
           shown_.now.reduction->dropped().empty();
  }

  void edges(Pencil& pencil) {
    const Stroke solid{style_.simplex.color, style_.simplex.width};
    for (int i = 0; i < view_.face.size(); ++i) {
      const Role from = view_.face[i], to = view_.face[(i + 1) % view_.face.size()];
      const Stroke& stroke = is_dropped(from) || is_dropped(to) ? style_.former : solid;
      if (view_.kind == Kind::edge_on)
        pencil.panel().line(at(from), at(to), stroke);
      else
        pencil.line(vertex(shown_, from), vertex(shown_, to), stroke);
    }
  }

  void name_origin(render::Panel& panel, const Vec2& toward) {
    mark_origin(panel);
    panel.label(at_origin(), toward, "O", label(style_.theme.ink));
  }

  // -- Views --

  /// A segment or a triangle with the regions beside it.
  void flat(Pencil& pencil) {
    const bool is_segment = view_.kind == Kind::segment;
    const Vec2 origin = at_origin();
    draw_regions_in_plane(pencil, shown_, view_.face);
    edges(pencil);
    if (is_segment && shown_.now.processed.size() > 2)  // one edge of several
      pencil.panel().line(origin, {origin.x(), at(Role::A).y()}, style_.foot);
    vertices(pencil);
    name_origin(pencil.panel(), is_segment ? Vec2(0, 1) : Vec2(origin - middle_of(corners())));
  }

  void edge_on(Pencil& pencil) {
    render::Panel& panel = pencil.panel();
    halves(panel);
    const std::vector<Vec2> page = panel.corners();
    panel.line({page[0].x(), 0}, {page[2].x(), 0}, style_.thin);
    if (has_fourth()) {
      for (const Role role : view_.face)
        panel.line(
            at(role), at(fourth(view_.face)),
            shown_.focus == Focus::reduction ? style_.former : Stroke{style_.simplex.color, 1.6 * style_.theme.line});
    }
    edges(pencil);
    drop(pencil);
    normal(pencil);
    vertices(pencil);
    name_origin(pencil.panel(), {1, view_.height < 0 ? -1.0 : 1.0});
  }

  /// Above and below the plane, as far as the search has come.
  void halves(render::Panel& panel) {
    const Region* const found = test_of(shown_.now, view_.face);
    if (view_.is_left_behind())
      fill_region(panel, half(panel.corners(), Vec2::Zero(), {0, -1.0}), RegionState::skipped, style_);
    if (!found) return;
    const double* const value = std::get_if<double>(&found->value);
    const bool below =
        shown_.now.processed.size() == 3 && value && *value < 0;  // either side of a triangle may be taken
    fill_region(panel, half(panel.corners(), Vec2::Zero(), {0, below ? -1.0 : 1.0}), state_of(found, shown_.now),
                style_);
  }

  /// From the origin to the plane, with a right angle, and the product that decides.
  void drop(Pencil& pencil) {
    render::Panel& panel = pencil.panel();
    const Vec2 at = at_origin(), foot(at.x(), 0);
    const double side = pencil.length(right_angle_side), up = at.y() < 0 ? -side : side;
    if (std::abs(at.y()) > 1.5 * side) {
      panel.line(at, foot, style_.foot);
      const double left = at.x() > middle_of(corners()).x() ? -side : side;
      panel.line(foot + Vec2(left, 0), foot + Vec2(left, up), style_.foot);
      panel.line(foot + Vec2(left, up), foot + Vec2(0, up), style_.foot);
    }
    if (!shown_.values || frame_.width() < narrow) return;
    const Region* const found = test_of(shown_.now, view_.face);
    if (!found) return;
    const char* const where = view_.height > 0 ? ", above" : view_.height < 0 ? ", below" : ", in the plane";
    const std::string product = inequality_of(*found, shown_.names);
    panel.name_area(half(panel.corners(), Vec2::Zero(), {0, view_.height < 0 ? -1.0 : 1.0}), product + where,
                    style_.small_label(), {product, ""});
  }

  /// On the line, away from the drop.
  void normal(Pencil& pencil) {
    const auto [left, right] = std::ranges::minmax(corners(), {}, [](const Vec2& p) { return p.x(); });
    const double near = at_origin().x() < (left.x() + right.x()) / 2 ? 0.75 : 0.25;
    const double x = left.x() + near * (right.x() - left.x());
    const Vec2 tail(x, 0),
        up(0, pencil.length((is_alone_ && frame_.width() >= narrow ? 1 : 0.6) * style_.arrow_length));
    const auto arrow = [&](const Vec2& along, const gjk::Expression& name, const Stroke& stroke) {
      pencil.panel().arrow(tail, tail + along, stroke);
      pencil.panel().label(tail + along * 0.8, {-1, 0}, shown_.names.translate(name),
                           label(stroke.color, render::Weight::bold));
    };
    const gjk::NamedVector normal = gjk::NamedVector::normal(view_.face);
    if (is_turned_over()) arrow(-up, {gjk::Expression::Form::negative, normal}, style_.normal);
    arrow(up, normal, is_turned_over() ? Stroke{style_.theme.grey, style_.normal.width} : style_.normal);
  }

  /// "P·d = 148 > 0, past O"; without the last words, which the caption has, where the letters are large.
  std::string product_with_d() const {
    const double value = shown_.now.crossing->value.value_or(0);
    const std::string sign = value > 0 ? " > 0" : value < 0 ? " < 0" : "";
    const std::string where = value > 0 ? ", past O" : value < 0 ? ", short of O" : ", at O";
    return shown_.names.of(shown_.now.found->w) + "·d = " + number(value) + sign + (style_.theme.text > 1 ? "" : where);
  }

  /// Eq. 9: whether the foot of P on the line of d lies past the origin.
  void crossing(Pencil& pencil) {
    render::Panel& panel = pencil.panel();
    const Point P = shown_.now.found->w, d = shown_.now.direction->value;
    const Vec2 at = at_found(), foot(at.x(), 0);
    const std::vector<Vec2> page = panel.corners();
    if (shown_.telling.panels.hull) difference(panel);
    pencil.out_of_reach(lens_.plane.out(at), d);
    panel.line({page[0].x(), 0}, {page[2].x(), 0}, style_.thin);
    panel.line(Vec2::Zero(), foot, style_.projection);
    panel.line(at, foot, style_.foot);
    if (!P.isZero(0))
      panel.arrow(Vec2::Zero(), at - at.stableNormalized() * pencil.length(style_.point_radius + 6), style_.normal);
    const Vec2 tip(pencil.length(style_.arrow_length), 0);
    panel.arrow(Vec2::Zero(), tip, style_.direction);
    panel.label(tip * 0.8, {0, 1}, "d", label(style_.direction.color, render::Weight::bold));
    if (shown_.values)  // beside the supporting line, on the origin's side
      panel.label(foot / 2, {-0.3 * at.x(), -std::abs(at.x())}, product_with_d(), style_.small_label(), 12);
    draw_point(panel, at, shown_.now.added ? style_.theme.green : style_.theme.vermillion, style_);
    panel.circle(at, style_.point_radius + 5, {style_.theme.ink, 2.5});
    panel.label(at, at, shown_.names.of(P), label(style_.theme.ink, render::Weight::bold));
    draw_origin_among(panel, Vec2::Zero(), {at}, style_);
    panel.label(Vec2::Zero(), {at.x() > 0 ? -1.0 : 1.0, -0.5}, "O", label(style_.theme.ink));
  }

  /// Its shadow on this plane: it ends where P is.
  void difference(render::Panel& panel) {
    const std::vector<Vec2> shadow = outline_of_difference(shown_.telling.scene, shown_.stage.difference, lens_);
    panel.polygon(half(shadow, at_found(), {-1, 0}), style_.hull_fill);  // P is the farthest, however it is stretched
    panel.name_area(shadow, "shadow of a − b", style_.small_label(), {""});
  }

  const Box frame_;
  const DecisionView& view_;
  const Shown& shown_;
  const Style& style_;
  const bool is_alone_;  ///< no other view stands above or below
  Box room_;             ///< of the picture
  Lens lens_;
};

/// Whether the views show one triangle, so that in both the foot of the origin stands below it.
bool are_below_each_other(const std::vector<DecisionView>& views) {
  return views.size() == 2 && views[0].face == views[1].face;
}

/// Whether the last view stands below the others, as wide as they are together.
bool has_base(const std::vector<DecisionView>& views) { return views.size() == 4; }

void share_width(Box& one, Box& other) {
  one.min.x() = other.min.x() = std::min(one.min.x(), other.min.x());
  one.max.x() = other.max.x() = std::max(one.max.x(), other.max.x());
}

/// Returns: a place for each view.
std::vector<Box> places_of(const Box& frame, const std::vector<DecisionView>& views, const Style& style) {
  std::vector<Box> places;
  const bool below_each_other = are_below_each_other(views);
  const auto weight = [&](const DecisionView& view) {
    if (!below_each_other || views[1].kind != Kind::true_shape || !views[1].decides) return 0.5;
    return &view == &views[1] ? share_of_true_shape : 1 - share_of_true_shape;
  };
  if (has_base(views)) {
    const double title = below_title(frame, style).min.y() - frame.min.y();
    const double share = share_of_base * std::max(1.0, style.theme.text);  // which larger names take
    const double top = frame.max.y() - gap - title - share * (frame.height() - gap - 2 * title);
    places = places_of({frame.min, {frame.max.x(), top}}, {views.begin(), views.end() - 1}, style);
    places.push_back({{frame.min.x(), top + gap}, frame.max});
    return places;
  }
  Vec2 corner = frame.min;
  const double count = static_cast<double>(views.size());
  for (const DecisionView& view : views) {
    const double width = below_each_other ? frame.width() : (frame.width() - gap * (count - 1)) / count;
    const double height = below_each_other ? (frame.height() - gap) * weight(view) : frame.height();
    places.push_back({corner, corner + Vec2(width, height)});
    corner += below_each_other ? Vec2(0, height + gap) : Vec2(width + gap, 0);
  }
  return places;
}

}  // namespace

void draw_decision(render::Canvas& canvas, const Box& frame, const std::vector<DecisionView>& views,
                   const Shown& shown) {
  const std::vector<Box> places = places_of(frame, views, shown.style);
  const bool below_each_other = are_below_each_other(views);
  std::vector<DecisionPicture> pictures;
  for (std::size_t i = 0; i < views.size(); ++i)
    pictures.emplace_back(places[i], views[i], shown, !below_each_other && !views[i].is_left_behind());
  for (DecisionPicture& picture : pictures) picture.draw_head(canvas);
  if (below_each_other) share_width(pictures[0].bounds, pictures[1].bounds);
  double scale = std::numeric_limits<double>::infinity();
  for (const DecisionPicture& picture : pictures) scale = std::min(scale, picture.fit().scale());
  for (DecisionPicture& picture : pictures)
    picture.draw(canvas, below_each_other ? picture.fit().with_scale(scale) : picture.fit());
}

}  // namespace walkthroughs::picture
