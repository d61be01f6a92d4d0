#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <>
Answer asked_of_point_sets<Relative>(const PointSet& a, const PointSet& b) {
  return asked<Relative>(a, b);
}

}  // namespace peers
