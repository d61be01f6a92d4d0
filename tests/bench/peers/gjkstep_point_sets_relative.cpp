#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <>
Answer asked_of_point_sets<Relative>(const PointSet& a, const PointSet& b, const gjk::Options<double>& options) {
  return asked<Relative>(a, b, options);
}

}  // namespace peers
