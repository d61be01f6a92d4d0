/// Answers that are proven, each with its certificate.
#pragma once

#include <string>

#include "walkthroughs/query/query_pair.hpp"

namespace walkthroughs::query {

/// Appends the answer to a pair, which is used up. Of points and balls it is exact; of shapes whose points are computed it may be
/// undecided. Requires: a pair read for a query in float or double whose evidence is a certificate.
void answer_certified(PairAsWritten&& pair, const QueryOptions& query, std::string& out);

}  // namespace walkthroughs::query
