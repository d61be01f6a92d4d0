#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <>
Answer asked_of_point_sets<gjk::Eager<>>(const PointSet& a, const PointSet& b, const gjk::Options<double>& options) {
  return asked<gjk::Eager<>>(a, b, options);
}

}  // namespace peers
