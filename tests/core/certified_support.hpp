/// Pairs of sets of points, and the certified answer about one, which is looked at before it is believed.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/certified/certified.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {

template <class S>
constexpr double u = std::numeric_limits<S>::epsilon() / 2.0;

template <class S>
S above(S x) {
  return std::nextafter(x, std::numeric_limits<S>::max());
}
template <class S>
S below(S x) {
  return std::nextafter(x, std::numeric_limits<S>::lowest());
}

template <class S>
struct Pair {
  PointSet<S> a, b;
};
template <class S>
Pair<S> pair_of(const std::vector<Vec3<S>>& a, const std::vector<Vec3<S>>& b) {
  return {PointSet<S>(a), PointSet<S>(b)};
}
template <class S>
Pair<S> pair_of(const Points& a, const Points& b) {
  return {point_set<S>(a), point_set<S>(b)};
}

/// Returns: that answer. Requires, as all answers must be: it is one, and its certificate holds.
template <class S>
CertifiedResult examined(const CertifiedResult& result, const Pair<S>& pair);

/// Returns: the certified answer, examined.
template <class S>
CertifiedResult proven(const Pair<S>& pair, const Options<S>& options = {});

/// Returns: what the certified answer tells.
template <class S>
std::vector<Event<S>> told(const Pair<S>& pair, const Options<S>& options = {});

}  // namespace gjk::test
