/// Is a point what a support function may have answered? Looked at from the shape's geometry; no support function is asked.
#pragma once

#include <string>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::trace {

/// Returns: what speaks against `found` as a farthest point of `object` along `direction`, within the rounding of a pose,
/// of a direction's length and of dot products in `scalar`; empty where nothing does. Requires: a direction that is finite
/// and not zero.
std::string objection_to(const gjk::SupportPoint<double>& found, const Object& object, const Point& direction,
                         Scalar scalar);

}  // namespace walkthroughs::trace
