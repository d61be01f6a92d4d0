/// What of a scene is nearest to the origin, to the last digits of doubles however near that is: a picture that is magnified
/// around the origin shows differences of products that would have no digit left if each were rounded.
#pragma once

#include <utility>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::picture {

/// Returns: the point of the line through P and Q, or of the segment between them, that is nearest to the origin.
/// Requires: finite points. Where P and Q are the same that is P.
Point foot_on_line(const Point& P, const Point& Q);
Point nearest_of_segment(const Point& P, const Point& Q);

/// Returns: the foot of the origin on the plane through `on` across `normal`, of any length but 0.
Point foot_on_plane(const Point& on, const Point& normal);
/// Returns: the foot of the origin on the plane of a triangle, and whether it lies in that. Requires: no three in line.
struct FootInTriangle {
  Point foot;
  bool is_inside;
};
FootInTriangle foot_in_triangle(const Point& A, const Point& B, const Point& C);

/// Returns: the part of a segment that is at most `reach` from the foot of the origin on its line; the whole where none is.
std::pair<Point, Point> part_near_origin(const Point& P, const Point& Q, double reach);

}  // namespace walkthroughs::picture
