#include "tests/core/certified_support.hpp"

#include "core/certified/check.hpp"

namespace gjk::test {

template <class S>
CertifiedResult examined(const CertifiedResult& result, const Pair<S>& pair) {
  REQUIRE(result.status != Status::undecided);
  REQUIRE(claim_of(result.certificate) == result.status);
  REQUIRE(holds(result.certificate, pair.a, pair.b));
  REQUIRE((result.fallback_iterations > 0) == (result.proof == Proof::exact_fallback));
  REQUIRE(result.fallback_iterations <= 12);  // a seen maximum, 9, with slack
  return result;
}

template <class S>
CertifiedResult proven(const Pair<S>& pair, const Options<S>& options) {
  return examined(certified_collision(pair.a, pair.b, options), pair);
}

template <class S>
std::vector<Event<S>> told(const Pair<S>& pair, const Options<S>& options) {
  Trace<S> trace;
  certified_collision(pair.a, pair.b, options, trace);
  return std::move(trace.events);
}

template CertifiedResult examined(const CertifiedResult&, const Pair<float>&);
template CertifiedResult examined(const CertifiedResult&, const Pair<double>&);
template CertifiedResult proven(const Pair<float>&, const Options<float>&);
template CertifiedResult proven(const Pair<double>&, const Options<double>&);
template std::vector<Event<float>> told(const Pair<float>&, const Options<float>&);
template std::vector<Event<double>> told(const Pair<double>&, const Options<double>&);

}  // namespace gjk::test
