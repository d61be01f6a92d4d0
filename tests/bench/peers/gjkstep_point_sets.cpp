#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <>
Answer asked_of_point_sets<gjk::AsIntended>(const PointSet& a, const PointSet& b, const gjk::Options<double>& options) {
  return asked<gjk::AsIntended>(a, b, options);
}

}  // namespace peers
