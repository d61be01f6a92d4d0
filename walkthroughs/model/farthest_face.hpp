/// Which points of a shape are farthest along a direction: all of them, where a support function answers with one.
#pragma once

#include <vector>

#include "walkthroughs/model/labelled_hull.hpp"

namespace walkthroughs::model {

/// A direction of length 1, and two across it that make a right-handed frame.
struct DirectionFrame {
  /// Requires: a direction that is finite and not zero.
  explicit DirectionFrame(const Point& along) : d(along.stableNormalized()), u(d.unitOrthogonal()), v(d.cross(u)) {}

  render::Vec2 across(const Point& p) const { return {p.dot(u), p.dot(v)}; }
  /// Returns: the point that is so far along and lies there across.
  Point at(double along, const render::Vec2& across) const { return d * along + u * across.x() + v * across.y(); }

  Point d, u, v;
};

/// The face that a shape turns to a direction, perhaps a line or a single point.
struct FarthestFace {
  double reach;                    ///< along the direction
  std::vector<render::Vec2> hull;  ///< across it; a round face as a polygon
  double slack;                    ///< how far from there points may lie because the direction is rounded
};

struct Tolerance {
  double length;  ///< two products that differ by less are equally far
  double angle;   ///< of a direction; at most 1
};

/// Rule: the farthest points of a sum are the sums of the farthest points of its two. Asks no support function.
FarthestFace farthest_face(const AnyShape& shape, const DirectionFrame& frame, const Tolerance& tolerance);

/// Returns: what no coordinate of a point of the shape exceeds.
double bound_of(const AnyShape& shape);

/// Returns: how far `p` lies from a hull as from convex_hull(), 0 within. Requires: at least one corner.
double distance(const render::Vec2& p, const std::vector<render::Vec2>& hull);

}  // namespace walkthroughs::model
