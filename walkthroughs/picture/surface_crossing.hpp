/// The line in which the surfaces of two objects cross. Only pictures need it.
#pragma once

#include <vector>

#include "walkthroughs/picture/body.hpp"

namespace walkthroughs::picture {

/// A piece of the line in which two surfaces cross, and where they face there. Seen from where both are seen, since both are
/// convex.
struct CrossingPiece {
  Point from, to;
  Point outward_a, outward_b;
};

/// Returns: where the surfaces of two objects in space cross, a piece for each two faces that do; of what has no faces those of
/// a polytope close to it. Nothing of two faces in one plane. Counts no support call.
std::vector<CrossingPiece> crossing_of(const Object& a, const Body& body_a, const Object& b, const Body& body_b);

}  // namespace walkthroughs::picture
