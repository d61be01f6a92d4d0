/// Hulls and outlines of the objects and of their difference. GJK never needs them; only pictures do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/picture/lens.hpp"

namespace walkthroughs {

/// Andrew's monotone chain (Inf. Proc. Letters 9, 1979).
/// Returns: the corners of the hull, counter-clockwise from the leftmost (of two such, the lower), without collinear points.
std::vector<render::Vec2> convex_hull(std::vector<render::Vec2> points);

/// Qhull. Returns: the faces of the hull of points in space, coplanar triangles joined; none where the points are flat.
std::vector<render::Face> hull_faces(const std::vector<Point>& points);

/// The hull of a planar difference of point sets, its corners counter-clockwise, named "A", "B", … from the one farthest
/// along +x (of two such, the upper), as in Figure 4.
struct LabelledHull {
  std::vector<render::Vec2> corners;

  /// Returns: the letter of the corner at `w`, or an empty string where there is none.
  std::string name(const Point& w) const;
};

/// Returns: the hull of all differences of the vertices, projected on the plane z = 0.
LabelledHull difference_hull(const Scene& scene);

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
