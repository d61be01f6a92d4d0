/// How pairs are asked, and what an answer is told with.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "walkthroughs/text/scene_values.hpp"

namespace walkthroughs::query {

/// In which numbers a query is computed; the position of its word in query_scalars.
using QueryScalar = reading::Numbers;
inline constexpr std::array<std::string_view, 4> query_scalars{"float", "double", "long-double", "exact"};

/// Where a search begins; the position of its word in query_starts.
enum class QueryStart {
  between,  ///< along the direction from the center of a to that of b
  inside,   ///< with the difference of the centers as the first vertex
};
inline constexpr std::array<std::string_view, 2> query_starts{"between", "inside"};

enum class QueryEvidence {
  of_the_search,  ///< what collision() returns
  certificate,    ///< what certified_collision() returns: a proof
  fractions,      ///< the same, with exact numbers to check it by
};

struct QueryOptions {
  QueryScalar scalar = QueryScalar::binary64;  ///< where there are to be certificates, float or double
  RuleSet rules = RuleSet::as_intended;
  ZeroTest zero_test = ZeroTest::exact;
  int iteration_limit = 20;  ///< 1 to scene_limits::iterations
  /// Where neither is given, eager rules begin between the centers, others along +x.
  std::optional<QueryStart> start = {};
  std::optional<Point> first_direction = {};  ///< goes before `start`; finite and not zero, in the scalar, too
  QueryEvidence evidence = QueryEvidence::of_the_search;
};

}  // namespace walkthroughs::query
