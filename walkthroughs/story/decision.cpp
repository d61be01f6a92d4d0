#include "walkthroughs/story/decision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/length.hpp"

namespace walkthroughs::story {
namespace {

using gjk::Role;
using Kind = DecisionView::Kind;
using Region = gjk::RegionTested<double>;

bool is_direction(const Point& v) { return v.allFinite() && !v.isZero(0); }

/// Returns: the part of `v` across the unit vector `along`; any vector across it where there is none.
Point across(const Point& v, const Point& along) {
  const Point part = v - along * along.dot(v);
  return render::length_of(part) > 1e-12 * render::length_of(v) ? part : Point(along.unitOrthogonal());
}

Point vertex(const Moment& now, Role role) { return now.processed.point(role); }

std::vector<DecisionView> view_of_crossing(const Moment& now) {
  const Point &d = now.direction->value, &P = now.found->w;
  const gjk::Crossing verdict = now.crossing->verdict;
  const bool is_tested = verdict == gjk::Crossing::crossed || verdict == gjk::Crossing::not_crossed;
  if (!is_tested || !std::isfinite(*now.crossing->value) || !is_direction(d) || !is_direction(P)) return {};
  const Point along = d.stableNormalized();
  return {{Kind::crossing,
           {},
           Plane::spanned(Point::Zero(), along, across(P, along)),
           *now.crossing->value / render::length_of(d) * now.scale}};
}

std::vector<DecisionView> view_of_segment(const Moment& now, const gjk::Roles& edge) {
  const Point A = vertex(now, edge[0]), X = vertex(now, edge[1]);
  if (!is_direction(A - X)) return {};
  return {{Kind::segment, edge, Plane::spanned(X, A - X, across(-X, (A - X).stableNormalized()))}};
}

/// Whether an edge of a triangle or a tetrahedron is asked about by itself, outside of any face.
bool is_about_edge(const Region& region) {
  const bool is_edge = region.feature.size() == 2 && region.face.empty();
  return is_edge && (asks_along_edge(region) || !std::holds_alternative<double>(region.value));
}

/// A triangle APQ of the simplex and its normal AP×AQ.
struct Triangle {
  Triangle(const Moment& now, const gjk::Roles& face)
      : corners{vertex(now, face[0]), vertex(now, face[1]), vertex(now, face[2])},
        normal((corners[1] - corners[0]).cross(corners[2] - corners[0])) {}

  std::array<Point, 3> corners;
  Point normal;

  /// Returns: the plane seen down the normal, the longest edge level and the third corner above it.
  Plane true_shape() const {
    std::size_t first = 0;
    const auto edge = [&](std::size_t i) -> Point { return corners[(i + 1) % 3] - corners[i]; };
    for (const std::size_t i : {1u, 2u})
      if (render::length_of(edge(i)) > render::length_of(edge(first))) first = i;
    const Point up = normal.stableNormalized().cross(edge(first).stableNormalized());
    return Plane::spanned(corners[0], edge(first), up);  // counter-clockwise: the third corner lies to the left
  }
  Plane edge_on() const { return Plane::spanned(corners[0], true_shape().right, normal); }
};

DecisionView edge_on(const Moment& now, const gjk::Roles& face, bool decides = true) {
  return {Kind::edge_on, face, Triangle(now, face).edge_on(), height_of_origin(now, face), decides};
}

DecisionView true_shape(const Moment& now, const gjk::Roles& face, bool decides = true) {
  return {Kind::true_shape, face, Triangle(now, face).true_shape(), height_of_origin(now, face), decides};
}

/// Whether a frame speaks of the simplex that is processed, as it was before anything was dropped.
bool is_about_processed(Focus focus) {
  return focus == Focus::added || focus == Focus::region || focus == Focus::reduction;
}

bool is_flat(const Moment& now, const gjk::Roles& face) { return !is_direction(Triangle(now, face).normal); }

std::vector<DecisionView> views_of_triangle(const Moment& now) {
  if (is_flat(now, "ABC")) return {};
  const bool is_height = !now.regions.empty() && now.regions.back().feature == "ABC";
  const bool is_edge = !now.regions.empty() && !is_height;
  return {edge_on(now, "ABC", !is_edge), true_shape(now, "ABC", !is_height)};
}

std::vector<DecisionView> views_of_tetrahedron(const Moment& now) {
  const Region* const last = now.regions.empty() ? nullptr : &now.regions.back();
  if (last && !last->face.empty()) {
    if (is_flat(now, last->face)) return {};
    return {edge_on(now, last->face, false), true_shape(now, last->face)};
  }
  if (last && last->feature.size() == 3 && !is_flat(now, last->feature)) {
    const DecisionView face = edge_on(now, last->feature);
    const bool edges_are_next = last->verdict == gjk::Verdict::chosen, is_in_plane = face.height == 0;
    if (edges_are_next || is_in_plane) return {face, true_shape(now, last->feature, false)};
  }
  std::vector<DecisionView> views;
  for (const gjk::Roles& face : {gjk::Roles("ABC"), gjk::Roles("ACD"), gjk::Roles("ADB")})
    if (!is_flat(now, face) && (!last || last->feature.size() != 3 || last->feature == face))
      views.push_back(edge_on(now, face));
  if (!last && views.size() == 3 && !is_flat(now, "BCD")) views.push_back(edge_on(now, "BCD", false));
  return views;
}

/// Of what the second search keeps.
std::vector<DecisionView> views_of_kept(const Moment& now) {
  const gjk::Roles& kept = now.kept->kept;
  gjk::Roles feature;  // A first
  for (int i = kept.size(); i-- > 0;) feature.add(kept[i]);
  if (now.kept->contains_origin || (kept.size() != 2 && kept.size() != 3)) return {};
  if (kept.size() == 2) return view_of_segment(now, feature);
  if (is_flat(now, feature)) return {};
  return {edge_on(now, feature), true_shape(now, feature, false)};
}

}  // namespace

bool asks_along_edge(const Region& region) {
  return region.expression.form == gjk::Expression::Form::dot &&
         region.expression.X.kind == gjk::NamedVector::Kind::edge;
}

const Region* test_of(const Moment& now, const gjk::Roles& face) {
  const auto found =
      std::ranges::find_if(now.regions, [&](const Region& r) { return r.face.empty() && r.feature == face; });
  return found == now.regions.end() ? nullptr : &*found;
}

double height_of_origin(const Moment& now, const gjk::Roles& face) {
  const Region* const region = test_of(now, face);
  const double* const value = region ? std::get_if<double>(&region->value) : nullptr;
  if (value && std::isfinite(*value) && region->normal && is_direction(*region->normal))
    return *value / render::length_of(*region->normal) * now.scale;
  const Triangle triangle(now, face);
  return triangle.normal.dot(-triangle.corners[0]) /
         render::length_of(triangle.normal);  // as the test to come computes it
}

std::string in_words(const DecisionView& view, const Moment& now, const Names& names) {
  const std::string feature = with_kind(names.sorted(view.face));
  const auto at = [&](Role role) { return view.plane(vertex(now, role)); };
  const render::Vec2 O = view.plane(Point::Zero());
  switch (view.kind) {
    case Kind::crossing: {
      const std::string P = names.of(now.found->w);
      return "In the plane of d and O" + P + ", " + P +
             (view.height < 0   ? " stops short of the origin along d."
              : view.height > 0 ? " lies past the origin along d."
                                : " lies beside the origin, no farther along d.");
    }
    case Kind::segment:
      for (const Role end : {view.face[1], view.face[0]})
        if (end == Role::A ? O.x() >= at(end).x() : O.x() <= at(end).x())
          return "In the plane of " + feature + " and the origin, the origin lies beyond " + names.of(end) + ".";
      return "In the plane of " + feature + " and the origin, the origin lies " +
             (O.y() > 0 ? "to one side of it." : "on it.");
    case Kind::edge_on:
      if (view.is_left_behind()) return "The half space beyond " + feature + ", away from A, is left behind.";
      return "Seen edge-on, the origin lies " +
             std::string(view.height > 0   ? "above "
                         : view.height < 0 ? "below "
                                           : "in the plane of ") +
             feature + ".";
    case Kind::true_shape: {
      std::string beyond;
      for (int i = 0; i < 3; ++i) {
        const Role from = view.face[i], to = view.face[(i + 1) % 3];
        const render::Vec2 along = at(to) - at(from), way = O - at(from);
        if (along.x() * way.y() - along.y() * way.x() < 0)
          beyond += (beyond.empty() ? " beyond " : " and beyond ") + names.sorted({from, to});
      }
      return "Seen from above, in true shape, the origin lies" + (beyond.empty() ? " within " : beyond + " of ") +
             feature + ".";
    }
  }
  return "";
}

gjk::Roles face_in_question(const Moment& now, Focus focus) {
  if (!is_about_processed(focus)) return {};
  const Region* const last = now.regions.empty() ? nullptr : &now.regions.back();
  gjk::Roles face;
  if (now.processed.size() == 3) face = "ABC";
  if (now.processed.size() == 4 && last)
    face = last->face.empty() && last->feature.size() == 3 ? last->feature : last->face;
  return face.empty() || is_flat(now, face) ? gjk::Roles() : face;
}

bool shows_decision(const Story& story) {
  return story.walkthrough.layout == Layout::search && story.walkthrough.panels.decision &&
         story.tellings[0].scene.dimension == Dimension::space;
}

std::vector<DecisionView> decision_views(const Moment& now, Focus focus) {
  const bool is_gap = focus == Focus::end && now.result->separation && now.found && now.crossing;
  if (focus == Focus::crossing || is_gap) return view_of_crossing(now);
  if (focus == Focus::kept) return views_of_kept(now);
  if (!is_about_processed(focus) || now.in_exact_fallback) return {};
  if (focus == Focus::region && is_about_edge(now.regions.back()))
    return view_of_segment(now, now.regions.back().feature);
  switch (now.processed.size()) {
    case 2: return view_of_segment(now, "AB");
    case 3: return views_of_triangle(now);
    case 4: return views_of_tetrahedron(now);
    default: return {};
  }
}

}  // namespace walkthroughs::story
