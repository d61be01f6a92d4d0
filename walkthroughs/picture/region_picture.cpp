#include "walkthroughs/picture/region_picture.hpp"

#include <algorithm>
#include <array>

#include "walkthroughs/picture/near_origin.hpp"
#include "walkthroughs/story/decision.hpp"

namespace walkthroughs::picture {
namespace {

using gjk::Role;
using gjk::Roles;
using Label = gjk::RegionLabel;
using gjk::Verdict;
using render::Vec2;
using Region = gjk::RegionTested<double>;

constexpr double cross_label_gap = 34;  // far enough for a leader: faces overlap in the picture
constexpr double foot_radius = 3.5;
constexpr double margin_in_space = 0.45;  // of the drawn part of a plane around its triangle, in widths of it

/// Draws the regions in one plane.
class RegionPicture {
 public:
  RegionPicture(Pencil& pencil, const Shown& shown)
      : pencil_(pencil), shown_(shown), style_(shown.style), plane_(pencil.lens().plane) {}

  void segment() {
    const Point A = vertex(Role::A), B = vertex(Role::B);
    if (A == B) return;
    const std::vector<Vec2> clip = drawn_part_beside(A, B);
    const auto areas = regions_of_segment(plane_(A), plane_(B), plane_(foot_on_line(A, B)), clip);
    const Region* sides = find(Label::R3_or_R4);
    const bool scene_in_space = shown_.telling.scene.dimension == Dimension::space;
    const Vec2 origin = plane_(Point::Zero());
    const bool left = areas[2].empty() || render::turn(plane_(A) - plane_(B), origin - plane_(B)) > 0;
    draw("R1", areas[0], find(Label::R1));
    draw("R2", areas[1], find(Label::R2));
    draw(scene_in_space ? "" : left ? "R4" : "R3", areas[left ? 3 : 2], scene_in_space ? sides : nullptr);
    draw(scene_in_space ? "R3 or R4" : left ? "R3" : "R4", areas[left ? 2 : 3], sides);
  }

  /// On one side of the plane through A across the edge the edge leads toward the origin, on the other it does not.
  void sides_along(const Roles& edge) {
    const Point A = vertex(Role::A), X = vertex(edge[1]);
    if (A == X) return;
    const std::vector<Vec2> clip = drawn_part_beside(A, X);
    const Vec2 along = plane_(X) - plane_(A);
    const Region* asked = nullptr;
    for (const Region& region : shown_.now.regions)
      if (region.feature == edge && asks_along_edge(region)) asked = &region;
    draw("", half(clip, plane_(A), -along), nullptr);
    draw("toward " + shown_.names.of(edge[1]), half(clip, plane_(A), along), asked);
  }

  void triangle() {
    const auto areas = areas_beside(vertex(Role::A), vertex(Role::B), vertex(Role::C));
    if (areas.empty()) return;
    for (const Label label : {Label::R4, Label::R5, Label::R6, Label::R2, Label::R3, Label::R7, Label::R1})
      draw(std::string(to_string(label)), areas[static_cast<std::size_t>(label) - 1], find(label));
    foot_of_origin();
  }

  void tetrahedron() {
    const Region& now = shown_.now.regions.back();
    faces();
    edges_looking_back();
    if (edges_shown())
      edges_of_face(now.face);
    else
      normal(now);
  }

  /// Without the regions, which are shown elsewhere: what is asked about, its normal, and what was rejected.
  void in_question() {
    const Roles face = face_in_question(shown_.now, shown_.focus);
    if (shown_.now.simplex.size() == 4) {
      faces();
      edges_looking_back();
    }
    if (!face.empty()) pencil_.polygon({vertex(face[0]), vertex(face[1]), vertex(face[2])}, style_.tested_fill);
    normal(shown_.now.regions.back());
  }

  /// The regions beside a face APQ in its plane: beyond AQ, beyond AP, and above the face itself.
  void edges_of_face(const Roles& face) {
    const Role P = face[1], Q = face[2];
    const auto areas = areas_beside(vertex(Role::A), vertex(P), vertex(Q));
    if (areas.empty()) return;
    const auto beyond = [&](Role other) { return "beyond " + shown_.names.sorted({Role::A, other}); };
    if (!pencil_.in_space()) {  // what the search has left behind, as far as it lies in this plane
      draw("", areas[1], find({}, "A"));
      draw("", areas[3], find({}, {P}));
      draw("", areas[4], find({}, {P, Q}));
      draw("", areas[5], find({}, {Q}));
    }
    const Region* const now = last();
    const bool neither = now && now->verdict == Verdict::rejected && now->feature == Roles{Role::A, P};
    draw(beyond(Q), areas[6], find(face, {Role::A, Q}));
    draw(beyond(P), areas[2], find(face, {Role::A, P}));
    const std::string above = shown_.now.in_exact_fallback ? "" : "above ";  // which may lie below
    draw(above + shown_.names.sorted(face), areas[0], neither ? find({}, face) : nullptr);
    foot_of_origin();
  }

  void name_rejected_faces() {
    if (edges_shown()) return;
    render::TextStyle text = style_.small_label();
    text.size *= 0.85;
    for (const Roles& face : {Roles("ABC"), Roles("ACD"), Roles("ADB")}) {
      const Region* region = find({}, face);
      if (state_of(region) != RegionState::rejected) continue;      // the one just tested is named by its normal
      if (!pencil_.lens().sees(face_of(face).outward())) continue;  // seen through others it has its name already
      const Point middle = (vertex(face[0]) + vertex(face[1]) + vertex(face[2])) / 3;
      pencil_.panel().label(pencil_.at(middle), Vec2::Zero(), shown_.names.sorted(face) + " ✗", text, cross_label_gap);
    }
  }

 private:
  Point vertex(Role role) const { return shown_.now.processed.point(role); }

  /// Looks, in space, at the plane of AB and the origin, or at any through AB where the origin lies on its line.
  /// Returns: what is drawn of the plane.
  std::vector<Vec2> drawn_part_beside(const Point& A, const Point& B) {
    const Point across = (B - A).cross(-A).cross(B - A);
    if (pencil_.in_space())
      plane_ = Plane::spanned(A, B - A, across.isZero(0) ? Point((B - A).unitOrthogonal()) : across);
    return drawn_part({A, B, Point::Zero()});
  }

  /// Looks, in space, at the plane of the triangle. Returns: its regions there; none where it is a line.
  std::vector<std::vector<Vec2>> areas_beside(const Point& A, const Point& B, const Point& C) {
    if ((B - A).cross(C - A).isZero(0)) return {};
    if (pencil_.in_space()) plane_ = Plane::spanned(A, B - A, C - A);
    const Feet feet = {plane_(foot_on_line(A, B)), plane_(foot_on_line(B, C)), plane_(foot_on_line(C, A))};
    return regions_of_triangle(plane_(A), plane_(B), plane_(C), feet, drawn_part({A, B, C, Point::Zero()}));
  }

  std::vector<Vec2> drawn_part(const std::vector<Point>& points) const {
    if (!pencil_.in_space()) return pencil_.panel().corners();
    const render::Box box = render::Box::around(Lens{std::nullopt, plane_}(points));
    return box.grown(margin_in_space * box.longer_side()).corners();
  }

  /// Returns: what has been said of a region, by its feature.
  const Region* find(const Roles& face, const Roles& feature) const {
    return find_if([&](const Region& region) {
      return region.face == face && region.feature == feature && !asks_along_edge(region);
    });
  }
  const Region* find(Label label) const {
    return find_if([&](const Region& region) { return label_of(region) == label; });
  }
  const Region* find_if(const auto& is_it) const {
    const auto found = std::ranges::find_if(shown_.now.regions, is_it);
    return found == shown_.now.regions.end() ? nullptr : &*found;
  }

  /// Returns: what was said last; nothing before the first test.
  const Region* last() const { return shown_.now.regions.empty() ? nullptr : &shown_.now.regions.back(); }
  RegionState state_of(const Region* region) const { return walkthroughs::picture::state_of(region, shown_.now); }

  std::vector<Vec2> picture(const std::vector<Vec2>& area) const {
    std::vector<Vec2> corners;
    for (const Vec2& p : area) corners.push_back(pencil_.at(plane_.out(p)));
    return corners;
  }

  /// `name`: "R3", or what it is: "beyond AC". `area`: in the plane. `region`: what was said of it, if anything was.
  void draw(const std::string& name, const std::vector<Vec2>& area, const Region* region) {
    if (area.size() < 3) return;
    const std::vector<Vec2> corners = picture(area);
    const RegionState state = state_of(region);
    fill(corners, state);
    if (!name.empty()) write(name, corners, region, state);
    const bool is_decision_view = shown_.telling.scene.dimension == Dimension::space && !pencil_.in_space();
    if (region && (region == last() || is_decision_view)) normal(*region);
  }

  void fill(const std::vector<Vec2>& corners, RegionState state) {
    fill_region(pencil_.panel(), corners, state, style_);
    pencil_.panel().outline(corners, style_.thin);
    if (state == RegionState::just_rejected || state == RegionState::just_possible)
      pencil_.panel().outline(corners, style_.tested);
    if (state == RegionState::chosen) pencil_.panel().outline(corners, {style_.theme.green, 3 * style_.theme.line});
  }

  void write(const std::string& name, const std::vector<Vec2>& corners, const Region* region, RegionState state) {
    render::TextStyle text = style_.small_label();
    std::string mark;
    switch (state) {
      case RegionState::pending: text.color = style_.theme.grey; break;
      case RegionState::skipped: text.color = style_.theme.grey; break;
      case RegionState::rejected:
      case RegionState::just_rejected: mark = "✗"; break;
      case RegionState::just_possible: mark = "✓ so far"; break;
      case RegionState::chosen:
        // Without the crossing test the ends of a segment are not ruled out: nothing is certain yet.
        mark = uncertain(*region) ? "if not R2" : "✓";
        text.weight = render::Weight::bold;
        break;
    }
    const std::string inequality = region && shown_.values ? inequality_of(*region, shown_.names) : "";
    text.size *= 0.85;
    if (mark.empty()) return pencil_.panel().name_area(corners, name, text, {""});
    const std::string with_mark = name + (mark == "if not R2" ? ", " : " ") + mark;
    pencil_.panel().name_area(corners, inequality.empty() ? with_mark : with_mark + "  " + inequality, text,
                              {with_mark, mark});
  }

  bool uncertain(const Region& region) const {
    return shown_.now.crossing->verdict == gjk::Crossing::switched_off && region.simplex_size == 2;
  }

  /// The normal of the region just tested, from the middle of its feature; where searches part, also a vector that was found.
  void normal(const Region& region) {
    const Point* const found = shown_.is_parting ? std::get_if<Point>(&region.value) : nullptr;
    const Point* const vector = region.normal ? &*region.normal : found;
    const bool out_of_page = !pencil_.in_space() && region.feature.size() == 3;
    if (!vector || vector->isZero(0) || out_of_page || asks_along_edge(region)) return;
    std::vector<Point> corners;
    for (const Role role : region.feature) corners.push_back(vertex(role));
    const gjk::Expression& asked = region.expression;
    const bool is_height = asked.form == gjk::Expression::Form::dot;
    pencil_.direction(middle_of(corners), *vector, style_.normal,
                      shown_.names.translate(is_height ? gjk::Expression(asked.X) : asked));
  }

  /// Where the origin lies in the plane of the triangle, above or below which it is.
  void foot_of_origin() {
    if (!pencil_.in_space()) return;
    const Point foot = plane_.out(plane_(Point::Zero()));
    pencil_.line(Point::Zero(), foot, style_.foot);
    pencil_.panel().disc(pencil_.at(foot), foot_radius, style_.foot.color);
  }

  // -- A tetrahedron --

  /// Whether the last test was of an edge in the plane of a face, so that the regions beside that face are drawn.
  bool edges_shown() const { return !shown_.now.regions.back().face.empty(); }

  render::Face face_of(const Roles& name) const { return {{vertex(name[0]), vertex(name[1]), vertex(name[2])}}; }

  /// The faces from back to front. Of the three that meet A each may have been tested; BCD is behind the search.
  void faces() {
    const Roles names[] = {"ABC", "ACD", "ADB", "BCD"};
    std::vector<render::Face> list;
    for (const Roles& name : names) list.push_back(face_of(name));
    for (const std::size_t i : pencil_.lens().back_to_front(list)) face(names[i], list[i]);
    if (const Region* inside = find({}, "ABCD"); inside != nullptr)
      for (const render::Face& face : list) pencil_.panel().polygon(pencil_.at(face.corners), style_.chosen_fill);
    outline_tested(names, list);
  }

  void face(const Roles& feature, const render::Face& face) {
    const std::vector<Vec2> corners = pencil_.at(face.corners);
    const RegionState state = state_of(find({}, feature));
    render::Panel& panel = pencil_.panel();
    if (state == RegionState::skipped)  // only BCD
      panel.hatch(corners, style_.hatch_spacing, bcd_is_behind() ? style_.hidden_hatching : style_.hatching);
    else if (state == RegionState::pending || state == RegionState::just_possible)
      panel.polygon(corners, style_.simplex_fill);
    else if (state != RegionState::chosen || !edges_shown())
      fill_region(panel, corners, state, style_);
    // Not the cross that stands at a vertex which leaves the simplex.
    if (state != RegionState::rejected && state != RegionState::just_rejected) return;
    const bool is_in_front = pencil_.lens().sees(face.outward());
    const std::string mark =
        is_in_front ? "✗" : shown_.names.sorted(feature) + " ✗";  // which it is, seen through others
    panel.name_area(corners, mark, is_in_front ? style_.label(style_.theme.ink) : style_.small_label(), {mark});
  }

  /// Whether the viewer looks at the inside of BCD, through the other faces. Its outward normal is BD×BC: A lies in the
  /// direction BC×BD (Section 3.2.4).
  bool bcd_is_behind() const {
    const Point B = vertex(Role::B);
    return !pencil_.lens().sees((vertex(Role::D) - B).cross(vertex(Role::C) - B));
  }

  void outline_tested(std::span<const Roles> names, const std::vector<render::Face>& list) {
    const Region& now = shown_.now.regions.back();
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (now.feature != names[i] || now.verdict == Verdict::skipped) continue;
      const bool chosen = now.verdict == Verdict::chosen;
      pencil_.panel().outline(pencil_.at(list[i].corners),
                              chosen ? render::Stroke{style_.theme.green, 4 * style_.theme.line} : style_.tested);
    }
  }

  /// B, C, D and the edges between them: the search has just moved away from there.
  void edges_looking_back() {
    for (const Roles& edge : {Roles("BC"), Roles("CD"), Roles("DB")})
      pencil_.line(vertex(edge[0]), vertex(edge[1]), style_.thin);
  }

  Pencil& pencil_;
  const Shown& shown_;
  const Style& style_;
  Plane plane_;
};

}  // namespace

RegionState state_of(const Region* region, const Moment& now) {
  if (!region) return RegionState::pending;
  if (region->verdict == Verdict::skipped) return RegionState::skipped;
  if (region->verdict == Verdict::chosen) return RegionState::chosen;
  const bool is_last = region == &now.regions.back() && !now.reduction;
  if (region->verdict == Verdict::possible) return is_last ? RegionState::just_possible : RegionState::pending;
  return is_last ? RegionState::just_rejected : RegionState::rejected;
}

void fill_region(render::Panel& panel, const std::vector<Vec2>& corners, RegionState state, const Style& style) {
  switch (state) {
    case RegionState::pending: break;
    case RegionState::skipped: panel.hatch(corners, style.hatch_spacing, style.hatching); break;
    case RegionState::rejected: panel.polygon(corners, style.rejected_fill); break;
    case RegionState::just_possible:
    case RegionState::just_rejected: panel.polygon(corners, style.tested_fill); break;
    case RegionState::chosen: panel.polygon(corners, style.chosen_fill); break;
  }
}

std::string inequality_of(const Region& region, const Names& names) {
  const double* value = std::get_if<double>(&region.value);
  if (!value) return "";
  return names.translate(region.expression) + " = " + number(*value) + compared_with_zero(region, *value);
}

std::vector<std::vector<Vec2>> regions_of_segment(const Vec2& A, const Vec2& B, const Vec2& foot,
                                                  const std::vector<Vec2>& clip) {
  const Vec2 along = A - B, left(-along.y(), along.x());
  const std::vector<Vec2> between = half(half(clip, A, -along), B, along);
  return {half(clip, B, -along), half(clip, A, along), half(between, foot, left), half(between, foot, -left)};
}

std::vector<std::vector<Vec2>> regions_of_triangle(const Vec2& A, const Vec2& B, const Vec2& C, const Feet& feet,
                                                   const std::vector<Vec2>& clip) {
  /// Away from the third corner R.
  const auto outward = [](const Vec2& P, const Vec2& Q, const Vec2& R) {
    const Vec2 across(Q.y() - P.y(), P.x() - Q.x());
    return across.dot(R - P) > 0 ? Vec2(-across) : across;
  };
  /// The part beyond the edge PQ, between the lines across its ends; R is the third corner.
  const auto beyond_edge = [&](const Vec2& P, const Vec2& Q, const Vec2& R, const Vec2& foot) {
    return half(half(half(clip, foot, outward(P, Q, R)), P, Q - P), Q, P - Q);
  };
  const auto beyond_corner = [&](const Vec2& P, const Vec2& Q, const Vec2& R) {
    return half(half(clip, P, P - Q), P, P - R);
  };
  const auto inside = [&] {
    return half(half(half(clip, feet[0], -outward(A, B, C)), feet[1], -outward(B, C, A)), feet[2], -outward(C, A, B));
  };
  const render::Box drawn = render::Box::around(clip), corners = render::Box::around(std::array{A, B, C});
  const bool is_whole = (corners.min.array() >= drawn.min.array() && corners.max.array() <= drawn.max.array()).all();
  return {is_whole ? std::vector{A, B, C} : inside(),
          beyond_corner(A, B, C),
          beyond_edge(A, B, C, feet[0]),
          beyond_corner(B, C, A),
          beyond_edge(B, C, A, feet[1]),
          beyond_corner(C, A, B),
          beyond_edge(A, C, B, feet[2])};
}

void draw_regions(Pencil& pencil, const Shown& shown) {
  if (shown.now.regions.empty()) return;  // of two scenes side by side, only the other one tests
  RegionPicture picture(pencil, shown);
  if (shown.regions_beside) return picture.in_question();
  if (asks_along_edge(shown.now.regions.back())) return picture.sides_along(shown.now.regions.back().feature);
  switch (shown.now.simplex.size()) {
    case 2: picture.segment(); break;
    case 3: picture.triangle(); break;
    case 4: picture.tetrahedron(); break;
    default: break;
  }
}

void draw_regions_in_plane(Pencil& pencil, const Shown& shown, const Roles& feature) {
  RegionPicture picture(pencil, shown);
  const int size = shown.now.processed.size();
  if (!shown.now.regions.empty() && asks_along_edge(shown.now.regions.back())) return picture.sides_along(feature);
  if (feature.size() == 2 && size == 2) return picture.segment();
  if (feature.size() == 3) return size == 3 ? picture.triangle() : picture.edges_of_face(feature);
}

void name_rejected_faces(Pencil& pencil, const Shown& shown) {
  if (shown.now.simplex.size() != 4 || shown.now.regions.empty() || shown.regions_beside) return;
  RegionPicture(pencil, shown).name_rejected_faces();
}

}  // namespace walkthroughs::picture
