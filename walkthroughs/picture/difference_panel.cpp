#include <algorithm>

#include "render/length.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/inset.hpp"
#include "walkthroughs/picture/light.hpp"
#include "walkthroughs/picture/near_origin.hpp"
#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/picture/pencil.hpp"
#include "walkthroughs/picture/region_picture.hpp"

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Stroke;
using render::Vec2;

constexpr double line_label_gap = 9;
constexpr double least_of_round = 1e-12;  // of a set, the part that may be magnified
constexpr double least_bend = 0.3;        // page units: a smaller one is drawn straight

// -- The key ----------------------------------------------------------------------------------------------------------

/// What the search direction tells of the far side: in space only its border is drawn.
KeyEntry key_beyond(const Shown& shown) {
  return key_of_out_of_reach(shown.lens.camera ? "supporting plane" : "out of reach", shown.style);
}

/// Returns: the origin, and everything that the search ever finds.
std::vector<Point> found_by(const Telling& telling) {
  std::vector<Point> found = {Point::Zero()};
  for (const auto& event : telling.trace.events)
    if (const auto* support = std::get_if<gjk::SupportFound<double>>(&event)) found.push_back(support->vertex.w);
  return found;
}

Stroke solid(Stroke stroke) {
  stroke.dash = {};
  return stroke;
}

// -- The picture ------------------------------------------------------------------------------------------------------

/// Whether the search has ended in front of the origin.
bool shows_gap(const Moment& now) {
  if (now.certified && now.in_exact_fallback) return now.certified->status == gjk::Status::separated;
  return now.result && now.result->separation;
}

/// Whether the picture shows how far the set reaches along d.
bool shows_supporting_line(const Shown& shown) {
  return shown.now.found && (shown.focus == Focus::support || shown.focus == Focus::crossing || shows_gap(shown.now));
}

bool shows_dropped(Focus focus) { return focus == Focus::reduction || focus == Focus::kept; }

/// Whether the picture shows d beside what it leads away from.
bool shows_direction(const Shown& shown) {
  return shown.now.direction && (shown.focus == Focus::support || shown.focus == Focus::direction ||
                                 shown.focus == Focus::repetition || shows_gap(shown.now));
}

Point start_of_direction(const Shown& shown) {
  const Simplex& from = shown.now.direction->from;
  return from.size() > 0 ? middle_of(points_of(from)) : middle_of(found_by(shown.telling));
}

/// Where that, a plane in space, is nearest to the origin: the foot of P on the line through the origin along d.
Point foot_of_supporting_line(const Moment& now) { return foot_on_plane(now.found->w, now.direction->value); }

/// Returns: the feet of the origin on what of the picture has an area in space.
std::vector<Point> feet_nearby(const Shown& shown) {
  std::vector<Point> feet;
  if (!shown.lens.camera || shown.focus == Focus::region) return feet;  // heights are told by other pictures
  const std::vector<Point> corners = points_of(shown.now.simplex);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j)
      for (std::size_t k = j + 1; k < corners.size(); ++k)
        if (const auto [foot, is_inside] = foot_in_triangle(corners[i], corners[j], corners[k]); is_inside)
          feet.push_back(foot);
  if (shows_supporting_line(shown)) feet.push_back(foot_of_supporting_line(shown.now));
  return feet;
}

bool is_in_simplex(const Moment& now, const Point& w) { return std::ranges::count(points_of(now.simplex), w) > 0; }

/// Returns: the edges that GJK added and that are none of the simplex. They would hide the regions of a scene in space.
std::vector<std::pair<Point, Point>> earlier_edges(const Shown& shown) {
  std::vector<std::pair<Point, Point>> edges;
  if (shown.lens.camera && shown.focus == Focus::region) return edges;
  for (const auto& [from, to] : shown.now.segments)
    if (!is_in_simplex(shown.now, from) || !is_in_simplex(shown.now, to)) edges.emplace_back(from, to);
  return edges;
}

/// Returns: the triangle in space above or below which the origin is drawn; empty where it is a plus.
gjk::Roles face_below_origin(const Shown& shown) {
  return shown.lens.camera ? face_in_question(shown.now, shown.focus) : gjk::Roles();
}

/// Returns: what is seen. Beside plane pictures there is little room: what these have words for is left out.
std::vector<KeyEntry> key(const Shown& shown) {
  const Style& style = shown.style;
  const Moment& now = shown.now;
  std::vector<KeyEntry> key;
  const gjk::Roles face = face_below_origin(shown);
  if (!face.empty()) key = key_of_origin(height_of_origin(now, face), style);
  const bool has_newest = now.found || now.simplex.size() > 0;
  if (has_newest && (face.empty() || !shown.regions_beside)) key.push_back(key_of_newest(style));
  if (!shown.regions_beside && now.simplex.size() > 1)
    key.push_back(key_of_line("simplex", shown.lens.camera ? solid(style.simplex) : style.simplex));
  if (!shown.regions_beside && shows_supporting_line(shown)) key.push_back(key_beyond(shown));
  if (!shown.regions_beside && shown.focus == Focus::region && now.processed.size() > 1)
    key.push_back(key_of_skipped(style));
  if (!earlier_edges(shown).empty()) key.push_back(key_of_line("earlier", style.former));
  return key;
}

/// Draws a difference set, and what the search does in it.
class DifferencePicture {
 public:
  DifferencePicture(render::Panel& panel, const Shown& shown)
      : panel_(panel),
        pencil_(panel, shown.lens, shown.style),
        shown_(shown),
        now_(shown.now),
        style_(shown.style),
        outline_(shown.telling.panels.hull
                     ? outline_of_difference(shown.telling.scene, shown.stage.difference, shown.lens)
                     : std::vector<Vec2>{}),
        center_(outline_.empty() ? pencil_.at(middle_of(found_by(shown.telling))) : middle_of(outline_)) {}

  /// All that the search has found so far. `frame`: of the panel.
  void search(render::Canvas& canvas, const Box& frame) {
    const Focus focus = shown_.focus;
    set();
    pencil_.triad(canvas, frame);  // behind the search, which it must not hide
    if (focus == Focus::region) draw_regions(pencil_, shown_);
    if (shows_supporting_line(shown_)) beyond_found();
    segments();
    if (shows_direction(shown_)) direction();
    if (focus == Focus::crossing) crossing();
    vertices();
    if (shows_dropped(focus)) dropped();
    if (focus == Focus::repetition) repetition();
    origin();
    names();
    if (focus == Focus::region) name_rejected_faces(pencil_, shown_);
    if (shown_.grips) pencil_.grip(canvas, shown_.stage.placing.scale, difference_grip, Point::Zero());
  }

  /// One move: where it started, where it ended, and whether it crossed the origin.
  void move() {
    set();
    if (now_.found) beyond_found();
    segments();
    direction();
    if (shown_.focus == Focus::crossing) {
      crossing();
      name_projection();
    }
    vertices();
    origin();
    for (const Point& corner : points_of(now_.simplex)) name(corner);
    if (now_.found) name(now_.found->w);
  }

  /// What a small picture around the origin shows.
  void inset() {
    hull_nearby();
    if (shown_.focus == Focus::region && !pencil_.in_space()) draw_regions(pencil_, shown_);
    panel_.drop_labels();
    feet_of_origin();
    if (shows_supporting_line(shown_)) {
      const Point& P = now_.found->w;
      pencil_.out_of_reach(pencil_.holds(P) ? P : foot_of_supporting_line(now_), now_.direction->value);
    }
    segments();
    if (shown_.focus == Focus::crossing) crossing();
    vertices();
    if (shows_dropped(shown_.focus)) dropped();
    origin();
    names();
  }

 private:
  void set() {
    if (!pencil_.in_space()) panel_.grid(shown_.stage.placing.scale, style_.grid);
    hull();
  }

  void names() {
    if (!shown_.telling.hull.corners.empty()) {
      for (const Vec2& corner : shown_.telling.hull.corners) name({corner.x(), corner.y(), 0});
      return;
    }
    std::vector<Point> named = points_of(now_.simplex);
    if (now_.found) named.push_back(now_.found->w);
    std::vector<Point> done;
    for (const Point& w : named) {
      if (std::ranges::count(done, w) == 0) name(w);
      done.push_back(w);
    }
  }

  void name(const Point& w) {
    if (!pencil_.holds(w)) return;  // which a magnified picture leaves out
    const std::string before = shown_.focus == Focus::added ? shown_.names.before(w) : "";
    panel_.label(pencil_.at(w), pencil_.at(w) - center_,
                 before.empty() ? shown_.names.label(w) : before + "→" + shown_.names.label(w),
                 style_.label(style_.theme.ink, in_simplex(w) ? render::Weight::bold : render::Weight::regular));
  }

  void mark_origin() {
    std::vector<Point> marked = points_of(now_.simplex);
    if (now_.found) marked.push_back(now_.found->w);
    draw_origin_among(panel_, pencil_.at(Point::Zero()), pencil_.at(marked), style_);
  }

  void origin() {
    const gjk::Roles face = face_below_origin(shown_);
    if (face.empty())
      mark_origin();
    else
      drop(face);
    const Vec2 at = pencil_.at(Point::Zero()), toward = center_ - at;
    if (pencil_.in_space())
      panel_.label(at, toward, "O", style_.label(style_.theme.ink));
    else  // where lines have sides
      panel_.label_on_its_side(at, toward, "O", style_.label(style_.theme.ink));
  }

  /// Where no point of the set can lie, because the support function has looked.
  void beyond_found() { pencil_.out_of_reach(now_.found->w, now_.direction->value); }

  /// Eq. 9: the vector from the origin to the point found, and d, drawn from the origin. The origin was crossed where
  /// the foot of that vector on the line of d lies ahead of the origin.
  void crossing() {
    const Point &w = now_.found->w, d = now_.direction->value.stableNormalized() * pencil_.length(1500);
    pencil_.line(-d, d, style_.thin);
    pencil_.line(Point::Zero(), projection(), style_.projection);
    if (!w.isZero(0)) {
      const Vec2 tip = pencil_.at(w);
      if (!pencil_.holds(w)) return pencil_.line(Point::Zero(), w, style_.normal);
      panel_.arrow(pencil_.at(Point::Zero()), tip - tip.stableNormalized() * pencil_.length(style_.point_radius + 6),
                   style_.normal);
      panel_.label(tip / 2, {-tip.y(), tip.x()}, "O" + shown_.names.of(w),
                   style_.label(style_.normal.color, render::Weight::bold), line_label_gap);
    }
    pencil_.direction(Point::Zero(), now_.direction->value, style_.direction, "d");
  }

  void name_projection() {
    panel_.label(pencil_.at(projection()), pencil_.at(projection()), shown_.names.of(now_.found->w) + "·d / |d|",
                 style_.small_label(), line_label_gap);
  }

  void segments() {
    for (const auto& [from, to] : earlier_edges(shown_)) pencil_.line(from, to, style_.former);
    simplex();
    if (now_.found && !in_simplex(now_.found->w))
      for (const Point& corner : points_of(now_.simplex)) pencil_.line(corner, now_.found->w, style_.move);
  }

  void vertices() {
    for (const Point& corner : points_of(now_.simplex)) point(corner, style_.theme.green);
    if (now_.found && !in_simplex(now_.found->w)) point(now_.found->w, style_.theme.vermillion);
    if (now_.found)
      ring(now_.found->w, style_.theme.ink);
    else if (now_.simplex.size() > 0)
      ring(now_.processed.point(gjk::Role::A), style_.theme.ink);  // also where the order has changed since
  }

  void point(const Point& p, render::Color color) {
    if (pencil_.holds(p)) pencil_.point(p, color);
  }

  void dropped() {
    if (now_.reduction) dropped(now_.reduction->dropped(), now_.reduction->before);
    if (now_.kept) dropped(now_.kept->dropped(), now_.kept->before);
  }

  /// `roles`: in `before`.
  void dropped(const gjk::Roles& roles, const Simplex& before) {
    for (const gjk::Role role : roles) {
      if (!pencil_.holds(before.point(role))) continue;
      const Vec2 at = pencil_.at(before.point(role));
      pencil_.cross(at, 11);
      if (shown_.telling.hull.corners.empty())
        panel_.label(at, at - center_, shown_.names.of(role), style_.label(style_.theme.grey));
    }
  }

  void direction() {
    if (!now_.direction) return;
    pencil_.direction(start_of_direction(shown_), now_.direction->value, style_.direction, "d");
  }

  /// Marks the simplex that was here before.
  void repetition() {
    for (const Point& corner : points_of(now_.simplex)) {
      panel_.circle(pencil_.at(corner), style_.point_radius + 9, style_.support_line);
      panel_.circle(pencil_.at(corner), style_.point_radius + 13, style_.support_line);
    }
    if (now_.simplex.size() > 1)
      panel_.label(pencil_.at(middle_of(points_of(now_.simplex))), Vec2::Zero(), "again",
                   style_.label(style_.theme.vermillion, render::Weight::bold), line_label_gap);
  }

  /// In space, where depth is not seen: the ways from the origin to the faces of the simplex and to the supporting plane.
  void feet_of_origin() {
    for (const Point& foot : feet_nearby(shown_)) {
      pencil_.line(Point::Zero(), foot, style_.foot);
      if (pencil_.holds(foot)) panel_.disc(pencil_.at(foot), 2.5, style_.foot.color);
    }
  }

  /// The origin above or below the plane of a triangle: its way there, hidden where the plane is in front of it.
  void drop(const gjk::Roles& face) {
    Point corners[3];
    for (int i = 0; i < 3; ++i) corners[i] = now_.processed.point(face[i]);
    const Point up = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
    const double height = height_of_origin(now_, face);
    const Point foot = -up * height, middle = (corners[0] + corners[1] + corners[2]) / 3;
    const bool is_hidden = shown_.lens.camera->sees(up) != (height > 0);
    pencil_.line(Point::Zero(), foot, is_hidden ? style_.foot : Stroke{style_.foot.color, style_.foot.width});
    const double side = pencil_.length(9);
    const Point level = (middle - foot).stableNormalized() * side, upright = up * (height < 0 ? -side : side);
    if (std::abs(height) > 1.5 * side) {
      pencil_.line(foot + level, foot + level + upright, {style_.foot.color, 1.2});
      pencil_.line(foot + level + upright, foot + upright, {style_.foot.color, 1.2});
    }
    panel_.disc(pencil_.at(foot), 2.5, style_.foot.color);
    draw_origin_beside(panel_, pencil_.at(Point::Zero()), height, style_);
  }

  /// Of a polytope, whose sides are straight however much they are magnified; in the plane of others, too.
  void hull_nearby() {
    const Body& body = shown_.stage.difference;
    if (pencil_.in_space()) {
      if (shown_.focus != Focus::region && !body.faces.empty())
        pencil_.body(outline_, body.faces, style_.hull_fill, hull_stroke());
      return;
    }
    if (outline_.empty()) return;
    std::vector<Point> corners;
    for (const Vec2& corner : body.vertices.empty() ? round_outline() : outline_)
      corners.emplace_back(corner.x(), corner.y(), 0);
    if (corners.empty()) return;
    pencil_.polygon(corners, style_.hull_fill);
    for (std::size_t i = 0; i < corners.size(); ++i)
      pencil_.line(corners[i], corners[(i + 1) % corners.size()], style_.hull);
  }

  /// Returns: the outline of a set that is not all corners, finer where the panel is; nothing where doubles have no digits left.
  std::vector<Vec2> round_outline() const {
    const Box nearby = Box::around(panel_.corners());
    if (nearby.longer_side() < least_of_round * Box::around(outline_).longer_side()) return {};
    return outline_nearby(shown_.telling.scene, shown_.lens, nearby, pencil_.length(least_bend));
  }

  void hull() {
    if (outline_.empty()) return;
    if (pencil_.in_space() && shown_.focus == Focus::region)  // its edges would hide the regions
      panel_.polygon(outline_, style_.hull_fill.with_alpha(60));
    else
      pencil_.body(outline_, shown_.stage.difference.faces,
                   pencil_.in_space() ? style_.hull_in_space : style_.hull_fill, hull_stroke(), lit_parts());
  }

  std::vector<std::vector<Vec2>> lit_parts() const {
    if (!pencil_.in_space() || !shown_.stage.difference.faces.empty()) return {};
    return lit_parts_of_difference(shown_.telling.scene, shown_.lens);
  }

  Stroke hull_stroke() const {
    return pencil_.in_space() ? Stroke{style_.hull.color, style_.hull.width * 0.6} : style_.hull;
  }

  /// The simplex itself. In space its edges in front are solid, because dashes tell there what lies behind.
  void simplex() {
    const std::vector<Point> corners = points_of(now_.simplex);
    if (corners.size() == 4 && pencil_.in_space()) {
      const std::vector<render::Face> faces = faces_of_tetrahedron(corners);
      if (shown_.focus != Focus::region)
        for (const std::size_t i : render::back_to_front(faces, *shown_.lens.camera))
          pencil_.polygon(faces[i].corners, style_.simplex_fill);
      pencil_.edges(faces, solid(style_.simplex));
      return;
    }
    if (corners.size() == 3 && shown_.focus != Focus::region) pencil_.polygon(corners, style_.simplex_fill);
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j)
        pencil_.line(corners[i], corners[j], pencil_.in_space() ? solid(style_.simplex) : style_.simplex);
  }

  /// The sign of w·d tells on which side of the origin.
  Point projection() const { return foot_of_supporting_line(now_); }

  bool in_simplex(const Point& w) const { return is_in_simplex(now_, w); }

  void ring(const Point& p, render::Color color) {
    if (pencil_.holds(p)) panel_.circle(pencil_.at(p), style_.point_radius + 5, {color, 2.5});
  }

  render::Panel& panel_;
  Pencil pencil_;
  const Shown& shown_;
  const Moment& now_;
  const Style& style_;
  const std::vector<Vec2> outline_;
  const Vec2 center_;
};

/// Returns: where else something is marked: what was found or dropped, and d.
std::vector<Point> marks_beside(const Shown& shown, const render::View& view) {
  const Moment& now = shown.now;
  std::vector<Point> marks;
  if (now.found) marks.push_back(now.found->w);
  if (shows_dropped(shown.focus))
    for (const Point& p : points_of(now.processed)) marks.push_back(p);
  if (shows_direction(shown)) {
    const Point start = start_of_direction(shown), d = now.direction->value;
    marks.push_back(start);
    marks.push_back(start + d.stableNormalized() * (shown.style.arrow_length / view.scale()));
  }
  return marks;
}

/// What the picture tells from the origin: the vertices and edges of the simplex, in space its faces, and what bounds the
/// set along d. Regions reach beyond the ends of an edge.
Surroundings around_origin(const Shown& shown, const Box& frame, const render::View& view) {
  const Moment& now = shown.now;
  Surroundings around{Vec2::Zero(), {}, {}, {}, {}};
  const auto near = [&](const Point& p) { around.nearest.push_back({shown.lens(p), render::length_of(p)}); };
  if (shown.regions_beside) return around;  // which magnify what they are about
  std::vector<Point> corners = points_of(now.simplex);
  const bool asks_regions = shown.focus == Focus::added || shown.focus == Focus::region;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      near(asks_regions ? foot_on_line(corners[i], corners[j]) : nearest_of_segment(corners[i], corners[j]));
      around.shape.emplace_back(shown.lens(corners[i]), shown.lens(corners[j]));
    }
  for (const Point& foot : feet_nearby(shown)) near(foot);
  if (shows_supporting_line(shown)) {
    if (!shown.lens.camera) near(foot_of_supporting_line(now));
    corners.push_back(now.found->w);
    around.shape.emplace_back(shown.lens(now.found->w), Vec2::Zero());
  }
  for (const Point& corner : corners) near(corner);
  around.vertices = shown.lens(corners);
  around.others = shown.lens(marks_beside(shown, view));
  if (shown.lens.camera) around.others.push_back(view.scene(start_of_triad(frame)));
  return around;
}

}  // namespace

void draw_difference(render::Canvas& canvas, const Place& place, const Shown& shown) {
  const Style& style = shown.style;
  const Box room = draw_panel_title(canvas, place.frame, place.title, style, key(shown));
  {
    const render::View view = view_in(room, place.frame, place.view, style);
    render::Panel panel(canvas, room, view);
    DifferencePicture(panel, shown).search(canvas, place.frame);
    const Surroundings around = around_origin(shown, place.frame, view);
    const std::vector<Inset> insets = insets_of(around, room, view, shown.telling.panels.close_up, style);
    finish_with_insets(canvas, panel, Vec2::Zero(), insets, style, [&shown](render::Panel& magnified) {
      const Style small = style_of_inset(shown.style);
      const Shown inside = shown.in(small);
      DifferencePicture(magnified, inside).inset();
    });
  }
  if (shown.is_parting) canvas.outline(place.frame.grown(3).corners(), style.parting);
}

Box bounds_of_difference(const Stage& stage, const Lens& lens) {
  Box box = Box::around(lens(found_by(*stage.telling)));
  if (stage.telling->panels.hull)
    for (const Vec2& corner : outline_of_difference(stage.telling->scene, stage.difference, lens)) box.add(corner);
  return box;
}

Box bounds_of_decision(const Moment& now, const Lens& lens) {
  Box box = Box::around(lens(points_of(now.processed)));
  box.add(lens(Point::Zero()));
  return box.grown(0.3 * box.longer_side());
}

Box bounds_of_move(const Moment& now, const Lens& lens) {
  std::vector<Point> points = points_of(now.simplex);
  points.insert(points.end(), {Point::Zero(), now.direction->value.stableNormalized()});
  if (now.found) points.push_back(now.found->w);
  return Box::around(lens(points));
}

void draw_move(render::Canvas& canvas, const Place& place, const Shown& shown) {
  const Box room = draw_panel_title(canvas, place.frame, place.title, shown.style, key(shown));
  render::Panel panel(canvas, room, view_in(room, place.frame, place.view, shown.style));
  DifferencePicture(panel, shown).move();
  canvas.add_crowded(panel.place_labels(shown.style.smallest_label()));
}

}  // namespace walkthroughs::picture
