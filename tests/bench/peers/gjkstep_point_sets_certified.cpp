#include "core/certified.hpp"
#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <>
Answer asked_of_point_sets<Certified<gjk::AsIntended>>(const PointSet& a, const PointSet& b,
                                                       const gjk::Options<double>& options) {
  return answer_of(gjk::certified_collision<double, gjk::AsIntended>(a, b, options).status);
}

}  // namespace peers
