/// The line that a query reads most: two sets of points.
#pragma once

#include <optional>
#include <string_view>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::text {

struct TwoPointSets {
  Points a, b;
};

/// Returns: the points of {"a":{"points":[[x,y,z],…]},"b":{"points":[…]}}, read several times as fast as a document. Nothing where the
/// line holds anything else, or anything that somebody might object to but for the size of numbers: Document::of_line() says what.
std::optional<TwoPointSets> two_point_sets(std::string_view line);

}  // namespace walkthroughs::text
