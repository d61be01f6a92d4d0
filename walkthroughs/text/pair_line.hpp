/// The line that a query reads most: two sets of points.
#pragma once

#include <string_view>
#include <variant>

#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs::text {

struct TwoPointSets {
  Points a, b;
};

/// Returns: the points of {"a":{"points":[[x,y,z],…]},"b":{"points":[…]}}, read several times as fast as a document. A document where
/// the line holds anything else, or anything that somebody might object to but for the size of numbers.
std::variant<TwoPointSets, Document> pair_of_line(std::string_view text);

}  // namespace walkthroughs::text
