/// A pair in the scalar that it is asked in, and what each set of rules answers.
#pragma once

#include "walkthroughs/query/query_pair.hpp"

namespace walkthroughs::query {

/// Searched as often as one likes.
template <class S>
struct PreparedPair {
  gjk::Options<S> options;
  PosedForm<S> a, b;
};

/// Returns: the pair, which is used up.
template <class S>
PreparedPair<S> prepared(PairAsWritten&& pair, const QueryOptions& query) {
  return {search_options<S>(pair, query), query_object<S>(std::move(pair.a)), query_object<S>(std::move(pair.b))};
}
extern template PreparedPair<gjk::Fraction> prepared(PairAsWritten&&, const QueryOptions&);  // much to compile

/// Returns: what collision() does, by the rules and the zero test of the query. Made for float, double, long double and
/// gjk::Fraction.
template <class S>
gjk::Result<S> searched(const PreparedPair<S>& pair, const QueryOptions& query);

}  // namespace walkthroughs::query
