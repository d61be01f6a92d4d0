/// Pairs with their exact answer and what proves it, one JSON line each, as `gjkstep query` reads them:
///
///     {"name":"triangles-3","family":"triangles","a":{"points":[…]},"b":{"points":[…]},
///      "answer":{"status":"separated","certificate":{"direction":["3","-1","0"]}},"notes":["…"],"source":"https://…"}
///
/// The answer is one of `gjkstep query --certified --fractions`: a direction d with a·d < b·d for all points a and b, or the
/// points of the difference whose weights make a common point. Balls and cylinders that meet have the common point alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/study/pairs/pairs.hpp"

namespace study {

struct AnsweredPair {
  NamedPair named;
  Truth truth;
  std::string certificate;         ///< JSON
  std::vector<std::string> notes;  ///< that they touch; that floats change the answer, or have no room for the pair
};

/// Returns: the answer of the oracle with a proof that was multiplied out in fractions.
/// Errors: std::logic_error where none can be; those of the oracle.
AnsweredPair answered(NamedPair named);

/// Returns: all of it, without a line feed.
std::string answered_line(const AnsweredPair& answered);

}  // namespace study
