#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/certified/dyadic.hpp"
#include "walkthroughs/picture/body.hpp"

namespace walkthroughs::picture {
namespace {

using gjk::detail::Bounded;
using gjk::detail::Dyadic;
using gjk::detail::Triple;
using Indices = std::vector<std::size_t>;  // of points or of facets

/// How far rounding may put the points of one face off its plane, where the largest coordinate is 1 to 2.
constexpr double coplanar = 0x1p-46;

/// A triangle of the hull, counter-clockwise seen from outside.
struct Facet {
  std::array<std::size_t, 3> corners;
  std::array<std::size_t, 3> neighbors;  ///< across the edge from each corner to the next
  Triple<Bounded> normal;
  Indices outside = {};  ///< its conflict list: points above it that no other facet has, the farthest last
  double farthest = 0;
  bool is_gone = false;

  std::size_t place_of(std::size_t corner) const { return corner == corners[0] ? 0 : corner == corners[1] ? 1 : 2; }
  Point rounded_normal() const { return {normal.x.value, normal.y.value, normal.z.value}; }
};

/// Quickhull (Barber et al. 1996). A facet is visible from the points that are exactly above its plane, none in it. So what a
/// point sees is in one piece, and each facet has an area, whatever is coplanar.
class Hull {
 public:
  /// `span`: three points, both sides of whose triangle are the first hull, and one that makes it a tetrahedron.
  Hull(const std::vector<Point>& of, const std::array<std::size_t, 4>& span) : points(of), facet_from_(of.size()) {
    const auto [a, b, c, d] = span;
    add_facet({a, b, c}, {1, 1, 1});
    add_facet({a, c, b}, {0, 0, 0});
    const double above = height(facets[0], d);
    if (above == 0) return;
    raise(above > 0 ? 0 : 1, d);
    Indices all(points.size());
    std::iota(all.begin(), all.end(), 0);
    sort_outside(all, 0);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      if (facets[i].outside.empty()) continue;
      const std::size_t apex = facets[i].outside.back();
      facets[i].outside.pop_back();
      raise(i, apex);
    }
  }

  /// Returns: the unit normal of a facet. Rounded products of a needle may have no digit of it.
  Point outward(const Facet& facet) const {
    const Point rounded = facet.rounded_normal();
    const double error = facet.normal.x.error + facet.normal.y.error + facet.normal.z.error;
    if (error <= coplanar / 2 * rounded.norm()) return rounded.normalized();
    const Triple<Dyadic> exact = normal<Dyadic>(facet.corners);
    return Point(near(exact.x, 0).value, near(exact.y, 0).value, near(exact.z, 0).value).stableNormalized();
  }

  const std::vector<Point>& points;
  std::vector<Facet> facets;  ///< those that are gone, too

 private:
  struct HorizonEdge {
    std::size_t from, to, beyond;
  };

  template <class N>
  Triple<N> vector(std::size_t from, std::size_t to) const {
    const Point &p = points[from], &q = points[to];
    return {N{q.x()} - N{p.x()}, N{q.y()} - N{p.y()}, N{q.z()} - N{p.z()}};
  }
  template <class N>
  Triple<N> normal(const std::array<std::size_t, 3>& corners) const {
    return cross(vector<N>(corners[0], corners[1]), vector<N>(corners[0], corners[2]));
  }

  /// Returns: how far a point is above a facet, in a unit of that facet. Its sign is exact.
  double height(const Facet& facet, std::size_t point) const {
    const Bounded quick = dot(facet.normal, vector<Bounded>(facet.corners[0], point));
    if (quick.has_certain_sign()) return quick.value;
    const Dyadic exact = dot(normal<Dyadic>(facet.corners), vector<Dyadic>(facet.corners[0], point));
    return sign_of(exact) * quick.error;
  }

  void add_facet(const std::array<std::size_t, 3>& corners, const std::array<std::size_t, 3>& neighbors) {
    facets.push_back({corners, neighbors, normal<Bounded>(corners)});
  }

  /// Gives each point to one facet from `first` on that it is above. One that is above none is inside, and forgotten.
  void sort_outside(const Indices& some, std::size_t first) {
    for (const std::size_t point : some)
      for (std::size_t i = first; i < facets.size(); ++i) {
        Facet& facet = facets[i];
        const double above = facet.is_gone ? 0 : height(facet, point);
        if (above <= 0) continue;
        facet.outside.push_back(point);
        if (above < facet.farthest) std::iter_swap(facet.outside.end() - 2, facet.outside.end() - 1);
        facet.farthest = std::max(above, facet.farthest);
        break;
      }
  }

  /// Replaces the facets visible from a point, `facet` among them, by those between their horizon and that point.
  void raise(std::size_t facet, std::size_t apex) {
    const std::size_t first = facets.size();
    Indices orphans;
    for (const auto& [from, to, beyond] : take_visible(facet, apex, orphans)) {
      facet_from_[from] = facets.size();
      Facet& other = facets[beyond];
      other.neighbors[other.place_of(to)] = facets.size();
      add_facet({from, to, apex}, {beyond, 0, 0});
    }
    for (std::size_t i = first; i < facets.size(); ++i) {
      const std::size_t next = facet_from_[facets[i].corners[1]];
      facets[i].neighbors[1] = next;
      facets[next].neighbors[2] = i;
    }
    sort_outside(orphans, first);
  }

  /// Takes away what is visible from a point, and gives the points outside of that to `orphans`. Returns: the horizon.
  std::vector<HorizonEdge> take_visible(std::size_t facet, std::size_t apex, Indices& orphans) {
    std::vector<HorizonEdge> horizon;
    Indices visible{facet};
    facets[facet].is_gone = true;
    for (std::size_t i = 0; i < visible.size(); ++i) {
      Facet& seen = facets[visible[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = seen.neighbors[k];
        if (facets[next].is_gone) continue;
        if (height(facets[next], apex) > 0) {
          facets[next].is_gone = true;
          visible.push_back(next);
        } else {
          horizon.push_back({seen.corners[k], seen.corners[(k + 1) % 3], next});
        }
      }
      orphans.insert(orphans.end(), seen.outside.begin(), seen.outside.end());
      seen.outside = {};
    }
    return horizon;
  }

  Indices facet_from_;  ///< of the newest facets, by the corner where their edge of the horizon starts
};

/// Returns: of each facet the largest of its face; all corners of the face are in its plane.
Indices joined(const Hull& hull) {
  const std::vector<Facet>& facets = hull.facets;
  std::vector<std::pair<double, std::size_t>> by_size;
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (!facets[i].is_gone) by_size.emplace_back(-facets[i].rounded_normal().norm(), i);
  std::ranges::sort(by_size);
  const std::size_t none = facets.size();
  Indices face_of(facets.size(), none);
  for (const auto& [size, largest] : by_size) {
    if (face_of[largest] != none) continue;
    const Point normal = hull.outward(facets[largest]), &on = hull.points[facets[largest].corners[0]];
    const auto is_in_plane = [&](std::size_t i) { return std::abs(normal.dot(hull.points[i] - on)) <= coplanar; };
    Indices face{largest};
    face_of[largest] = largest;
    for (std::size_t i = 0; i < face.size(); ++i)
      for (const std::size_t next : facets[face[i]].neighbors)
        if (face_of[next] == none && std::ranges::all_of(facets[next].corners, is_in_plane)) {
          face_of[next] = largest;
          face.push_back(next);
        }
  }
  return face_of;
}

/// Returns: the corners of each face, the first of all points first. Corners of two faces only are left out: they are on the edge
/// between the two.
std::vector<Indices> corners_of(const Hull& hull, const Indices& face_of) {
  const std::vector<Facet>& facets = hull.facets;
  std::vector<std::map<std::size_t, std::size_t>> borders(facets.size());  // of each face, from each corner to the next
  std::vector<int> faces_at(hull.points.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (facets[i].is_gone || face_of[facets[i].neighbors[k]] == face_of[i]) continue;
      borders[face_of[i]][facets[i].corners[k]] = facets[i].corners[(k + 1) % 3];
      ++faces_at[facets[i].corners[k]];
    }
  std::vector<Indices> faces;
  for (const auto& next : borders) {
    if (next.empty()) continue;
    Indices corners;
    std::size_t corner = next.begin()->first;
    for (std::size_t i = 0; i < next.size(); ++i, corner = next.find(corner)->second)
      if (faces_at[corner] > 2) corners.push_back(corner);
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    if (corners.size() > 2) faces.push_back(std::move(corners));
  }
  std::ranges::sort(faces);
  return faces;
}

/// Returns: the points times a power of two, so that no product overflows or vanishes; none where one is not finite.
std::vector<Point> near_one(std::vector<Point> points) {
  double largest = 0;
  for (const Point& p : points) {
    if (!p.allFinite()) return {};
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
  for (Point& p : points) p = p.unaryExpr([&](double x) { return std::ldexp(x, exponent); });
  return points;
}

/// Returns: four points far apart; none where all are in one plane, or as good as.
std::optional<std::array<std::size_t, 4>> span_of(const std::vector<Point>& points) {
  if (points.size() < 4) return std::nullopt;
  const auto farthest = [&](const auto& distance) {
    return static_cast<std::size_t>(std::ranges::max_element(points, {}, distance) - points.begin());
  };
  const std::size_t a = farthest([&](const Point& p) { return (p - points[0]).norm(); });
  const Point& A = points[a];
  const std::size_t b = farthest([&](const Point& p) { return (p - A).norm(); });
  const Point along = (points[b] - A).normalized();
  const std::size_t c = farthest([&](const Point& p) { return along.cross(p - A).norm(); });
  const Point across = along.cross(points[c] - A), normal = across.normalized();
  const auto height = [&](const Point& p) { return std::abs(normal.dot(p - A)); };
  const std::size_t d = farthest(height);
  if (across.norm() <= coplanar || height(points[d]) <= coplanar) return std::nullopt;
  return std::array{a, b, c, d};
}

}  // namespace

std::vector<render::Face> hull_faces(const std::vector<Point>& points) {
  const std::vector<Point> scaled = near_one(points);
  const auto span = span_of(scaled);
  if (!span) return {};
  const Hull hull(scaled, *span);
  std::vector<render::Face> faces;
  for (const Indices& corners : corners_of(hull, joined(hull))) {
    faces.emplace_back();
    for (const std::size_t i : corners) faces.back().corners.push_back(points[i]);
  }
  return faces.size() < 4 ? std::vector<render::Face>() : faces;  // as good as flat
}

}  // namespace walkthroughs::picture
