/// Answers that are proven, each with its certificate.
#pragma once

#include <string>

#include "walkthroughs/query/query_pair.hpp"

namespace walkthroughs {

/// Appends the answer. Requires: a pair read for a query in float or double whose evidence is a certificate.
/// Errors: DocumentError where an object is no list of points: the points of others are rounded before anything is proven.
void answer_certified(const PairAsWritten& pair, const QueryOptions& query, std::string& out);

}  // namespace walkthroughs
