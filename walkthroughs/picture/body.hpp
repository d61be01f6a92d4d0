/// The objects and their difference as pictures need them. GJK never needs their hulls and outlines; only pictures do.
#pragma once

#include <cstddef>
#include <vector>

#include "walkthroughs/picture/lens.hpp"

namespace walkthroughs::picture {

/// A flat part of a round surface, such as the cap of a cylinder.
struct Flat {
  std::vector<Point> rim;
  Point outward;
};

/// A convex body as pictures need it. A polytope has vertices, and faces where it has a volume; a difference with neither
/// is asked for its outline through its support function.
struct Body {
  std::vector<Point> vertices;
  std::vector<render::Face> faces;  ///< of a polytope in space; of a flat one both sides
  std::vector<Flat> flats;          ///< of a round object in space
  bool only_outline = false;        ///< a polytope in space with more than `most_corners`: its faces are left out
};

/// The edges between more would cover a body in a picture, and cost more than all else.
inline constexpr std::size_t most_corners = 1000;

/// Returns: of a polytope, also one that is a sum, its vertices and faces, unless it has too many to be worth it; where it
/// has `only_outline`, perhaps points inside as well; of other objects what of them is flat. Asks no support function.
Body body_of(const Object& object, Dimension dimension);

/// Returns: the difference of two point sets, unless it has too many vertices to be worth it; else an empty body.
Body body_of_difference(const Scene& scene, const Body& a, const Body& b);

/// Returns: so many unit vectors, spread evenly all around.
std::vector<Point> directions_all_around(int count);

/// Returns: the outline of an object in the picture, counter-clockwise, with the corners that are seen; of a sum the sum of
/// the outlines of its two. Asks no support function.
std::vector<render::Vec2> outline(const Object& object, const Body& body, const Lens& lens);

/// Returns: the outline of the difference in the picture. Asks the support functions where `body` is empty.
std::vector<render::Vec2> outline_of_difference(const Scene& scene, const Body& body, const Lens& lens);

/// Returns: the same of a difference in the plane, so fine near `where` that no side there misses the border by more than
/// `tolerance` (scene units). Asks the support functions.
std::vector<render::Vec2> outline_nearby(const Scene& scene, const Lens& lens, const render::Box& where,
                                         double tolerance);

/// Returns: the faces of the hull of points in space, none where the points are flat. Triangles that are coplanar but for rounding
/// are joined. Faces that meet share their corners, which are some of the points.
std::vector<render::Face> hull_faces(const std::vector<Point>& points);

}  // namespace walkthroughs::picture
