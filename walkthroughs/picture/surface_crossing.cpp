#include "walkthroughs/picture/surface_crossing.hpp"

#include <optional>

namespace walkthroughs::picture {
namespace {

constexpr int mesh_directions = 700;

/// Returns: the faces of a polytope; of a round object those of one that touches its surface from within.
std::vector<render::Face> mesh_of(const Object& object, const Body& body) {
  if (!body.faces.empty() || (!body.vertices.empty() && !body.only_outline)) return body.faces;
  const PosedForm<double> form(Asked<double>(object.form), object.pose);  // which counts no call
  std::vector<Point> points;
  for (const Point& d : directions_all_around(mesh_directions)) points.push_back(form.support(d).point);
  for (const Flat& flat : body.flats) points.insert(points.end(), flat.rim.begin(), flat.rim.end());
  return hull_faces(points);
}

struct Bounds {
  Point min, max;

  explicit Bounds(const std::vector<Point>& points) : min(points.front()), max(points.front()) {
    for (const Point& p : points) {
      min = min.cwiseMin(p);
      max = max.cwiseMax(p);
    }
  }
  bool overlap(const Bounds& other) const {
    return (min.array() <= other.max.array()).all() && (other.min.array() <= max.array()).all();
  }
};

/// A face with what is asked of it again and again.
struct CutFace {
  explicit CutFace(const render::Face& of) : face(of), outward(of.outward().stableNormalized()), bounds(of.corners) {}

  const render::Face& face;
  Point outward;
  Bounds bounds;
};

struct Piece {
  Point from, to;
};

/// Returns: what the plane of `other` cuts out of a face.
std::optional<Piece> cut_by_plane(const CutFace& cut, const CutFace& other) {
  const std::vector<Point>& corners = cut.face.corners;
  const auto height = [&](const Point& p) { return other.outward.dot(p - other.face.corners[0]); };
  std::vector<Point> ends;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double at_p = height(p), at_q = height(q);
    if (at_p == 0) ends.push_back(p);
    if (at_p * at_q < 0) ends.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  if (ends.size() != 2) return std::nullopt;  // beside it, in one corner, or in the same plane
  return Piece{ends[0], ends[1]};
}

/// Returns: the part of a line in the plane of a face that lies on it.
std::optional<Piece> clipped(Piece piece, const CutFace& face) {
  const std::vector<Point>& corners = face.face.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point inward = face.outward.cross(corners[(i + 1) % corners.size()] - corners[i]);
    const double from = inward.dot(piece.from - corners[i]), to = inward.dot(piece.to - corners[i]);
    if (from <= 0 && to <= 0) return std::nullopt;
    const Point between = piece.from + (piece.to - piece.from) * (from / (from - to));
    if (from < 0) piece.from = between;
    if (to < 0) piece.to = between;
  }
  return piece;
}

}  // namespace

std::vector<CrossingPiece> crossing_of(const Object& a, const Body& body_a, const Object& b, const Body& body_b) {
  const std::vector<render::Face> faces_a = mesh_of(a, body_a), faces_b = mesh_of(b, body_b);
  const std::vector<CutFace> cut_a(faces_a.begin(), faces_a.end()), cut_b(faces_b.begin(), faces_b.end());
  std::vector<CrossingPiece> pieces;
  for (const CutFace& of_a : cut_a)
    for (const CutFace& of_b : cut_b) {
      if (!of_a.bounds.overlap(of_b.bounds)) continue;
      std::optional<Piece> piece = cut_by_plane(of_a, of_b);
      if (piece) piece = clipped(*piece, of_b);
      if (piece) pieces.push_back({piece->from, piece->to, of_a.outward, of_b.outward});
    }
  return pieces;
}

}  // namespace walkthroughs::picture
