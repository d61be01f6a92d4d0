/// The objects and their difference as pictures need them. GJK never needs their hulls and outlines; only pictures do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/picture/lens.hpp"

namespace walkthroughs {

/// A convex body as pictures need it. A polytope has vertices, and faces where it has a volume; a body with neither is
/// asked for its outline through its support function.
struct Body {
  std::vector<Point> vertices;
  std::vector<render::Face> faces;  ///< of a body in space
};

/// Returns: the vertices (of a round object: none) and faces of one object. Asks no support function.
Body body_of(const Object& object, Dimension dimension);

/// Returns: the difference of two point sets, unless it has too many vertices to be worth it; else an empty body.
Body body_of_difference(const Scene& scene, const Body& a, const Body& b);

/// Returns: points around the cap at the end -1 or 1 of the axis.
std::vector<Point> rim_of(const Cylinder& cylinder, double end);

/// Returns: the outline of an object in the picture, counter-clockwise. Asks no support function.
std::vector<render::Vec2> outline(const Object& object, const Body& body, const Lens& lens);

/// Returns: the outline of the difference in the picture. Asks the support functions where `body` is empty.
std::vector<render::Vec2> outline_of_difference(const Scene& scene, const Body& body, const Lens& lens);

}  // namespace walkthroughs
