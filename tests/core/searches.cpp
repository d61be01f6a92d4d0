// Searches are compiled here, once for each scalar and set of rules.
#include "core/rule_sets.hpp"
#include "tests/core/support.hpp"

namespace gjk::test {

template <class S, class Rules>
Result<S> Searches<S, Rules>::asked(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options) {
  return collision<S, Rules>(a, b, options);
}
template <class S, class Rules>
Run<S> Searches<S, Rules>::observed(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options) {
  Trace<S> trace;
  const Result<S> result = collision<S, Rules>(a, b, options, trace);
  return {result, std::move(trace.events)};
}
template <class S>
std::optional<Vec3<S>> direction_of(const Next<S>& next) {
  return next.contains_origin() ? std::nullopt : std::optional(next.direction());
}

/// Throws where a step that is told differs from one that is not.
template <class S, class Rules>
ToldStep<S> Searches<S, Rules>::step(Simplex<S>& simplex, CrossingTest crossing_test) {
  Trace<S> trace;
  Simplex<S> plain = simplex;
  const auto plain_direction = direction_of(process<Rules>(plain, crossing_test));
  const auto direction = direction_of(process<Rules>(simplex, crossing_test, trace));
  if (direction != plain_direction || !(simplex == plain)) throw std::logic_error("telling changes the step");
  return {direction, std::move(trace.events)};
}

template struct Searches<float, AsIntended>;
template struct Searches<double, AsIntended>;
template struct Searches<long double, AsIntended>;
template struct Searches<Rational, AsIntended>;
template struct Searches<double, AsPrinted>;
template struct Searches<double, Eager<>>;
template struct Searches<double, Complete<>>;
template struct Searches<Rational, Complete<>>;
template struct Searches<float, Intended<RelativeZeroTest>>;
template struct Searches<double, Intended<RelativeZeroTest>>;
template struct Searches<Rational, Intended<RelativeZeroTest>>;

}  // namespace gjk::test
